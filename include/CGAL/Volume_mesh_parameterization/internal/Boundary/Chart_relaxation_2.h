// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_CHART_RELAXATION_2_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_CHART_RELAXATION_2_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Harmonic_extension_2.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Untangling_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/eigen_decomposition_2.h>

#include <optional>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

using Held_coordinates = std::vector<std::array<bool, 3> >; // by vertex and axis: coordinates of images that stay

// Moves the inner vertices of a plane image of a chart, first harmonically, then such that no triangle is flipped
// and the distortion is low. The border stays. The energy is the one of Garanzha et al., Foldover-free maps in 50 lines of
// code (2021),
//   sum over triangles of area (|J|^2 + (D^2 + 1) / 2) / chi(D),   chi(D) = (D + sqrt(D^2 + epsilon^2)) / 2,
// where J is the Jacobian of the map from the surface, D its determinant, and epsilon tends to zero; minimized by
// Newton's method with Hessians that are made positive.
class Chart_relaxation_2
{
public:
  // Maps the chart harmonically. The axes u and v of the images give positive orientation; the chart is scaled to the area
  // of its image.
  Chart_relaxation_2(const Boundary_mesh_3& mesh, const std::vector<Boundary_mesh_3::Face_index>& faces,
                     const Held_coordinates& is_held, const int u, const int v,
                     std::vector<Vector_3>& images)
    : m_u(u), m_v(v), m_chart(mesh, faces)
  {
    const std::vector<Boundary_mesh_3::Vertex_index>& vertices = m_chart.vertices;
    m_images.resize(2, vertices.size());
    double area = 0, image_area = 0;
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      m_images.col(i) << images[vertices[i]][u], images[vertices[i]][v];
      m_unknown.emplace_back();
      for(const int axis : { 0, 1 })
        m_unknown.back()[axis] = is_held[vertices[i]][axis == 0 ? u : v] ? -1 : m_number_of_unknowns++;
    }
    move_to_harmonic_map();
    for(const Triangle& t : m_chart.triangles)
    {
      area += t.area;
      image_area += edges(t, m_images).determinant() / 2;
    }
    for(Triangle& t : m_chart.triangles)
    {
      t.to_rest *= std::sqrt(area / image_area);
      t.area /= area;
    }
    write(images);
  }

  // Returns whether this relaxation was made for these held coordinates, at their places.
  bool was_made_for(const Held_coordinates& is_held, const std::vector<Vector_3>& images) const
  {
    for(std::size_t i = 0; i < m_unknown.size(); ++i)
      for(const int axis : { 0, 1 })
      {
        const auto v = m_chart.vertices[i];
        const int k = axis == 0 ? m_u : m_v;
        if(is_held[v][k] != holds(i, axis) || (is_held[v][k] && images[v][k] != m_images(axis, i)))
          return false;
      }
    return true;
  }

  // Moves the vertices; only the first call does so.
  void run(std::vector<Vector_3>& images, const Budget& budget)
  {
    if(std::exchange(m_is_relaxed, true))
      return;
    const auto solver = make_symmetric_sparse_solver();
    State state = evaluate(m_images, 1);
    m_epsilon = first_epsilon(state.smallest_determinant);
    constexpr int maximum_number_of_steps = 50; // a guess; of 2336 charts that had room, one took more
    for(int step = 0; step < maximum_number_of_steps && m_number_of_unknowns > 0
        && budget.may_begin_round(Phase::BOUNDARY, "relaxation of a chart"); ++step)
    {
      state = evaluate(m_images, m_epsilon);
      const State next = newton_step(state, *solver);
      const double decrease = 1 - next.energy / state.energy;
      if(decrease == 0 || (next.smallest_determinant > 0 && decrease < 1e-3))
        break;
      m_epsilon = next_epsilon(m_epsilon, decrease, state.smallest_determinant, next.smallest_determinant);
    }
    write(images);
  }

  void write(std::vector<Vector_3>& images) const
  {
    for(std::size_t i = 0; i < m_chart.vertices.size(); ++i)
    {
      images[m_chart.vertices[i]][m_u] = m_images(0, i);
      images[m_chart.vertices[i]][m_v] = m_images(1, i);
    }
  }

private:
  using Columns_2 = Dynamic_matrix<double, 2, Eigen::Dynamic>;

  using Triangle = Chart_triangles_2::Triangle;

  struct State { double energy, smallest_determinant; };

  bool holds(const std::size_t v, const int axis) const { return m_unknown[v][axis] < 0; }

  // Maps each coordinate for itself; with one factorization if the same vertices are held.
  void move_to_harmonic_map()
  {
    std::optional<Harmonic_extension_2> extension;
    std::vector<bool> is_held, was_held;
    for(int axis = 0; axis < 2; ++axis, was_held = is_held)
    {
      is_held.clear();
      for(std::size_t v = 0; v < m_unknown.size(); ++v)
        is_held.push_back(holds(v, axis));
      if(is_held != was_held)
        extension.emplace(m_chart, is_held);
      VectorXd values = m_images.row(axis).transpose();
      extension->apply(values);
      m_images.row(axis) = values.transpose();
    }
  }

  static Small_matrix<2, 2> edges(const Triangle& t, const Columns_2& u)
  {
    Small_matrix<2, 2> result;
    result << u.col(t.vertices[1]) - u.col(t.vertices[0]), u.col(t.vertices[2]) - u.col(t.vertices[0]);
    return result;
  }

  State evaluate(const Columns_2& u, const double epsilon) const
  {
    State state = { 0, (std::numeric_limits<double>::infinity)() };
    for(const Triangle& t : m_chart.triangles)
    {
      const Small_matrix<2, 2> J = edges(t, u) * t.to_rest;
      const double D = J.determinant();
      state.energy += t.area * (J.squaredNorm() + (D * D + 1) / 2) / regularized_determinant(D, epsilon);
      state.smallest_determinant = (std::min)(state.smallest_determinant, D);
    }
    return state;
  }

  State newton_step(const State& before, Symmetric_sparse_solver& solver)
  {
    VectorXd gradient = VectorXd::Zero(m_number_of_unknowns);
    std::vector<Sparse_entry> entries;
    for(const Triangle& t : m_chart.triangles)
      add_derivatives(t, gradient, entries);
    solver.factorize(m_number_of_unknowns, entries);
    const VectorXd solution = solver.solve(-gradient);

    Columns_2 direction = Columns_2::Zero(2, m_images.cols());
    for(std::size_t v = 0; v < m_unknown.size(); ++v)
      for(int axis = 0; axis < 2; ++axis)
        if(!holds(v, axis))
          direction(axis, v) = solution[m_unknown[v][axis]];
    for(double length = 1; length > 1e-12; length /= 2)
    {
      const Columns_2 candidate = m_images + length * direction;
      const State after = evaluate(candidate, m_epsilon);
      if(after.energy <= before.energy + 1e-4 * length * gradient.dot(solution)
         && (after.smallest_determinant > 0 || before.smallest_determinant <= 0))
      {
        m_images = candidate;
        return after;
      }
    }
    return before;
  }

  void add_derivatives(const Triangle& t, VectorXd& gradient, std::vector<Sparse_entry>& entries) const
  {
    const Small_matrix<2, 2> J = edges(t, m_images) * t.to_rest;
    const Small_matrix<4, 1> j(J(0, 0), J(1, 0), J(0, 1), J(1, 1)), cofactors(J(1, 1), -J(0, 1), -J(1, 0), J(0, 0));
    const double D = J.determinant(), root = std::sqrt(D * D + m_epsilon * m_epsilon);
    const double inverse = 1 / regularized_determinant(D, m_epsilon);
    const double slope = 1 / root;                                                              // chi' / chi
    const double curvature = m_epsilon * m_epsilon / (2 * root * root * root) * inverse;        // chi'' / chi
    const double value = (j.squaredNorm() + (D * D + 1) / 2) * inverse;
    const double first = D * inverse - value * slope; // derivatives by D, |J| fixed
    const double second = inverse - 2 * D * inverse * slope + value * (2 * slope * slope - curvature);

    // J is the sum of a similarity p and a reflected one q, and its cofactors are p - q. In the basis of p, q and of the
    // vectors orthogonal to them in both planes of similarities, the Hessian couples p with q alone.
    const Small_matrix<2, 1> p = (j + cofactors).head<2>() / 2, q = (j - cofactors).head<2>() / 2;
    const auto unit = [](const Small_matrix<2, 1>& x) -> Small_matrix<2, 1>
    { return x.isZero(0) ? Small_matrix<2, 1>(Small_matrix<2, 1>::UnitX()) : Small_matrix<2, 1>(x.normalized()); };
    const Small_matrix<2, 1> a = unit(p), b = unit(q);
    Small_matrix<4, 4> basis;
    basis <<  a[0],  b[0], -a[1], -b[1],
              a[1],  b[1],  a[0],  b[0],
             -a[1],  b[1], -a[0],  b[0],
              a[0], -b[0], -a[1],  b[1];
    basis /= std::sqrt(2.);
    const double pp = 2 * p.squaredNorm(), qq = 2 * q.squaredNorm(), pq = 2 * p.norm() * q.norm(); // each number stands twice in J
    Small_matrix<2, 2> coupled;
    coupled << 2 * inverse + first + (second - 4 * inverse * slope) * pp, -second * pq,
               -second * pq, 2 * inverse - first + (second + 4 * inverse * slope) * qq;
    const Eigen_decomposition_2 eigen = eigen_decomposition_2(coupled);
    const Small_matrix<4, 2> turned = basis.leftCols<2>() * eigen.vectors;
    basis.leftCols<2>() = turned;
    Small_matrix<4, 1> eigenvalues;
    eigenvalues << eigen.values, 2 * inverse + first, 2 * inverse - first;
    const Small_matrix<4, 4> scaled = basis * eigenvalues.cwiseMax(1e-6 * inverse).asDiagonal();
    const Small_matrix<4, 4> H = scaled * basis.transpose();

    Small_matrix<4, 6> derivative = Small_matrix<4, 6>::Zero(); // derivative of j by the images
    for(int k = 0; k < 2; ++k)
      for(int i = 0; i < 3; ++i)
        derivative.block<2, 2>(2 * k, 2 * i).diagonal().setConstant(
          (i == 0) ? -t.to_rest.col(k).sum() : t.to_rest(i - 1, k));
    const Small_matrix<6, 4> weighted = t.area * derivative.transpose();
    const Small_matrix<4, 1> slopes = 2 * inverse * j + first * cofactors;
    const Small_matrix<6, 1> g = weighted * slopes;
    const Small_matrix<6, 4> curved = weighted * H;
    const Small_matrix<6, 6> h = curved * derivative;
    for(int i = 0; i < 6; ++i)
    {
      const int row = m_unknown[t.vertices[i / 2]][i % 2];
      if(row < 0)
        continue;
      gradient[row] += g[i];
      for(int k = 0; k < 6; ++k)
        if(const int column = m_unknown[t.vertices[k / 2]][k % 2]; column >= 0)
          entries.push_back({ row, column, h(i, k) });
    }
  }

  int m_u, m_v;
  Chart_triangles_2 m_chart;
  Columns_2 m_images;
  std::vector<std::array<int, 2> > m_unknown; // number of each coordinate of a vertex, or -1 if it is held
  int m_number_of_unknowns = 0;
  double m_epsilon = 1;
  bool m_is_relaxed = false;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_CHART_RELAXATION_2_H
