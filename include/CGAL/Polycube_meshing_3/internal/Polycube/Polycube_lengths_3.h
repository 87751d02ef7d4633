// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_LENGTHS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_LENGTHS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Harmonic_polycube_map_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/ordered_coordinates_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/sparse_systems.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/eigen_decomposition_2.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Moves the faces of a polycube along their axes such that lengths on it become those on the surface: a limb that leads askew
// to the axes gets its own length, not that of its projection. With s and t the singular values of the harmonic map, the least
//   sum over facets of area (log(s)^2 + log(t)^2)
// is looked for, by Newton's method on sums of squares that are weighted anew in each step. The scale is that of the surface. A
// polycube of less volume than the body is scaled to this volume, so that hexahedra are on the mean not larger than the spacing of
// a grid, neither inside nor where thin limbs have more surface than volume.
class Polycube_lengths_3
{
public:
  Polycube_lengths_3(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts, const Polycube_planes_3& planes)
    : m_mesh(mesh), m_planes(planes), m_map(mesh, charts, planes), m_weights(planes.size())
  {
    for(std::size_t p = 0; p < planes.size(); ++p)
      m_weights[p] = weight_of_position * planes.areas()[p];
  }

  // Returns the coordinates of the planes of the best polycube. Takes the coordinates of the charts at the start, and a grid, to
  // whose planes the result is rounded if there is a spacing.
  std::vector<double> run(const std::vector<double>& coordinates, const Plane_grid_3& grid, const Budget& budget) const
  {
    constexpr double rounding = 1e-12; // far below the energy of any polycube that is not the body itself
    VectorXd start(m_planes.size());
    for(std::size_t c = 0; c < coordinates.size(); ++c)
      start[m_planes[c]] = coordinates[c];
    if(energy(start, start) < rounding)
      return { start.data(), start.data() + start.size() };
    VectorXd x = minimum_of_energy(start, budget);
    if(const double volume = m_map.volume(x); volume > 0)
      x *= (std::max)(1., std::cbrt(Polygon_mesh_processing::volume(m_mesh) / volume));
    if(grid.spacing > 0)
      round_to_planes(at_largest_faces(grid, x), x);
    return { x.data(), x.data() + x.size() };
  }

private:
  using Matrix = Dynamic_matrix<double, Eigen::Dynamic, Eigen::Dynamic>;

  // Sum of squares x^T A x / 2 - b^T x, up to a constant.
  struct Sum_of_squares { Matrix A; VectorXd b; };

  // Returns the factorization of A, which is sparse because only planes at the border of one chart share an entry.
  static std::unique_ptr<Symmetric_sparse_solver> factorized(const Matrix& A)
  {
    std::vector<Sparse_entry> entries;
    for(int i = 0; i < A.rows(); ++i)
      for(int k = 0; k < A.cols(); ++k)
        if(A(i, k) != 0)
          entries.push_back({ i, k, A(i, k) });
    std::unique_ptr<Symmetric_sparse_solver> solver = make_symmetric_sparse_solver();
    solver->factorize(static_cast<int>(A.rows()), entries);
    return solver;
  }

  VectorXd minimum_of_energy(const VectorXd& start, const Budget& budget) const
  {
    constexpr int maximum_number_of_steps = 20; // five or six are usual
    constexpr double smallest_gain = 1e-3, shortest_step = 0.05; // guesses
    VectorXd x = start;
    double energy = this->energy(x, start), gain = 1;
    for(int step = 0; step < maximum_number_of_steps && gain > smallest_gain
        && budget.may_begin_round(Phase::BOUNDARY, "lengths of a polycube"); ++step)
    {
      const Sum_of_squares squares = sum_of_squares(x, start);
      const VectorXd direction = factorized(squares.A)->solve(squares.b) - x;
      gain = 0;
      for(double length = 1; length > shortest_step && gain <= 0; length /= 2)
      {
        const VectorXd next = x + length * direction;
        const double next_energy = this->energy(next, start);
        if(!(next_energy < energy))
          continue;
        gain = 1 - next_energy / energy;
        energy = next_energy;
        x = next;
      }
    }
    return x;
  }

  // Returns a singular value that keeps the energy finite where a facet vanishes, as facets at concave corners do.
  static double bounded(const double singular_value) { return (std::max)(singular_value, 0.03); } // a guess

  // Returns the sum over facets, and the weighted squares of the distances from the start, which hold the polycube in its place.
  double energy(const VectorXd& x, const VectorXd& start) const
  {
    double result = (x - start).cwiseAbs2().dot(m_weights);
    for(const Harmonic_chart_2& chart : m_map.charts())
      for(const Chart_triangles_2::Triangle& t : chart.triangles)
      {
        const Small_matrix<2, 2> J = chart.jacobian(chart.gradients(t), x);
        const double half = J.squaredNorm() / 2, determinant = std::abs(J.determinant());
        const double largest = std::sqrt(half + std::sqrt((std::max)(half * half - determinant * determinant, 0.)));
        const double smallest = largest > 0 ? determinant / largest : 0;
        result += t.area * (std::pow(std::log(bounded(largest)), 2) + std::pow(std::log(bounded(smallest)), 2));
      }
    return result;
  }

  // Returns a sum of squares with the derivatives of the energy at x: with J = U S V^T, those of the elements of U^T J V - I, of
  // which those on the diagonal have the weights log(s) / (s (s - 1)).
  Sum_of_squares sum_of_squares(const VectorXd& x, const VectorXd& start) const
  {
    Sum_of_squares result = { m_weights.asDiagonal(), m_weights.cwiseProduct(start) };
    for(const Harmonic_chart_2& chart : m_map.charts())
      for(const Chart_triangles_2::Triangle& t : chart.triangles)
        add_squares(chart, t, x, result);
    return result;
  }

  // Adds the squares of a triangle, whose U and V are those at x, while J depends on the coordinates that are looked for.
  static void add_squares(const Harmonic_chart_2& chart, const Chart_triangles_2::Triangle& t, const VectorXd& x,
                          Sum_of_squares& sum)
  {
    const auto gradients = chart.gradients(t);
    const Small_matrix<2, 2> J = chart.jacobian(gradients, x), V = eigen_decomposition_2(J.transpose() * J).vectors;
    const Small_matrix<2, 2> images = J * V;
    Small_matrix<2, 2> U; // with the determinant of V: U V^T is a rotation, so that flipped facets are turned back
    U.col(1) = images.col(1).stableNormalized();
    U.col(0) << U(1, 1), -U(0, 1);
    if(V.determinant() < 0)
      U.col(0) *= -1;
    const auto weight = [](const double s) { return std::abs(s - 1) < 1e-3 ? 1 : std::log(s) / (s * (s - 1)); }; // limit: 1
    const Small_matrix<2, 1> weights(weight(bounded(images.col(0).norm())), weight(bounded(images.col(1).norm())));
    const Dynamic_matrix<double, Eigen::Dynamic, 2> turned = gradients * V;
    const std::vector<Harmonic_chart_2::Function>& functions = chart.functions;
    for(int i = 0; i < 2; ++i)
      for(int k = 0; k < 2; ++k)
      {
        const double w = t.area * std::sqrt(weights[i] * weights[k]); // off the diagonal, the geometric mean
        const auto derivative = [&](const std::size_t f) { return U(functions[f].row, i) * turned(f, k); };
        for(std::size_t f = 0; f < functions.size(); ++f)
        {
          sum.b[functions[f].plane] += i == k ? w * derivative(f) : 0;
          for(std::size_t g = 0; g < functions.size(); ++g)
            sum.A(functions[f].plane, functions[g].plane) += w * derivative(f) * derivative(g);
        }
      }
  }

  // Returns a grid whose origin, if it may move, is on the planes with the largest faces along each axis, wherever the body lies.
  Plane_grid_3 at_largest_faces(Plane_grid_3 grid, const VectorXd& x) const
  {
    Vector_3 largest = Vector_3::Zero();
    for(Eigen::Index g = 0; g < x.size() && grid.may_move; ++g)
      if(const int axis = m_planes.axis(g); m_planes.areas()[g] > largest[axis])
      {
        largest[axis] = m_planes.areas()[g];
        grid.origin[axis] = x[g];
      }
    return grid;
  }

  // Moves coordinates to planes of the grid, one after the other, the closest first. The others go along such that the sum of
  // squares stays the least, as the mean of a normal distribution does if one of its numbers becomes known.
  void round_to_planes(const Plane_grid_3& grid, VectorXd& x) const
  {
    const std::unique_ptr<Symmetric_sparse_solver> solver = factorized(sum_of_squares(x, x).A);
    Matrix covariance(x.size(), x.size());
    for(Eigen::Index g = 0; g < x.size(); ++g)
    {
      VectorXd unit = VectorXd::Zero(x.size());
      unit[g] = 1;
      covariance.col(g) = solver->solve(unit);
    }
    const auto offset_to_plane = [&](const Eigen::Index g)
    {
      const double multiple = (x[g] - grid.origin[m_planes.axis(g)]) / grid.spacing;
      return grid.spacing * (std::round(multiple) - multiple);
    };
    std::vector<Eigen::Index> unknown(x.size());
    for(std::iota(unknown.begin(), unknown.end(), 0); !unknown.empty(); )
    {
      const auto closest = std::min_element(unknown.begin(), unknown.end(), [&](const Eigen::Index g, const Eigen::Index h)
      { return std::abs(offset_to_plane(g)) < std::abs(offset_to_plane(h)); });
      const Eigen::Index known = *closest;
      unknown.erase(closest);
      const VectorXd column = covariance.col(known);
      const double step = offset_to_plane(known) / column[known];
      x[known] += step * column[known];
      for(const Eigen::Index g : unknown)
      {
        x[g] += step * column[g];
        for(const Eigen::Index h : unknown)
          covariance(g, h) -= column[g] * column[h] / column[known];
      }
    }
  }

  static constexpr double weight_of_position = 0.01; // a guess; hardly changes lengths, but holds the polycube

  const Boundary_mesh_3& m_mesh;
  const Polycube_planes_3& m_planes;
  const Harmonic_polycube_map_3 m_map;
  VectorXd m_weights; // of positions, by plane
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_LENGTHS_3_H
