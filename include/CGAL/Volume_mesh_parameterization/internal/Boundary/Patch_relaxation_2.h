// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_PATCH_RELAXATION_2_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_PATCH_RELAXATION_2_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Untangling_energy_3.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Moves the inner vertices of a plane image of a surface patch such that no triangle is flipped and the distortion is
// low. The border stays. The energy is the one of Garanzha et al., Foldover-free maps in 50 lines of code (2021),
//   sum over triangles of area (|J|^2 + (D^2 + 1) / 2) / chi(D),   chi(D) = (D + sqrt(D^2 + epsilon^2)) / 2,
// where J is the Jacobian of the map from the surface, D its determinant, and epsilon tends to zero; minimized by
// Newton's method with Hessians that are made positive.
class Patch_relaxation_2
{
public:
  // Images have positive orientation; the patch is scaled to the area of its image.
  Patch_relaxation_2(const Boundary_mesh_3& patch, Eigen::Matrix2Xd& images, const Budget& budget)
    : m_images(images), m_budget(budget), m_unknown(patch.number_of_vertices(), -1)
  {
    for(const auto v : patch.vertices())
      if(!patch.is_border(v))
        m_unknown[v] = m_number_of_unknowns++;
    double area = 0, image_area = 0;
    for(const auto f : patch.faces())
    {
      add_triangle(patch, patch.halfedge(f));
      area += m_triangles.back().area;
      image_area += edges(m_triangles.back(), images).determinant() / 2;
    }
    for(Triangle& t : m_triangles)
    {
      t.to_rest *= std::sqrt(area / image_area);
      t.area /= area;
    }
  }

  void run()
  {
    State state = evaluate(m_images, 1);
    m_epsilon = first_epsilon(state.smallest_determinant);
    for(int iteration = 0; iteration < 100 && !m_budget.is_exhausted(); ++iteration)
    {
      state = evaluate(m_images, m_epsilon);
      const State next = newton_step(state);
      const double decrease = 1 - next.energy / state.energy;
      if(decrease == 0 || (next.smallest_determinant > 0 && decrease < 1e-3))
        break;
      m_epsilon = next_epsilon(m_epsilon, decrease, state.smallest_determinant, next.smallest_determinant);
    }
  }

private:
  struct Triangle
  {
    std::array<int, 3> vertices;
    Eigen::Matrix2d to_rest; // edges of the image times this are the Jacobian
    double area;
  };

  struct State
  {
    double energy;
    double smallest_determinant;
  };

  void add_triangle(const Boundary_mesh_3& patch, const Boundary_mesh_3::Halfedge_index h)
  {
    const std::array<Boundary_mesh_3::Vertex_index, 3> v = { patch.source(h), patch.target(h),
                                                            patch.target(patch.next(h)) };
    std::array<Eigen::Vector3d, 3> p;
    for(int i = 0; i < 3; ++i)
      p[i] = eigen_point(patch, v[i]);
    const Eigen::Vector3d a = p[1] - p[0], b = p[2] - p[0];
    Eigen::Matrix2d rest;
    rest << a.norm(), a.dot(b) / a.norm(), 0, a.cross(b).norm() / a.norm();
    m_triangles.push_back({ { static_cast<int>(v[0]), static_cast<int>(v[1]), static_cast<int>(v[2]) },
                            rest.inverse(), rest.determinant() / 2 });
  }

  static Eigen::Matrix2d edges(const Triangle& t, const Eigen::Matrix2Xd& u)
  {
    Eigen::Matrix2d result;
    result << u.col(t.vertices[1]) - u.col(t.vertices[0]), u.col(t.vertices[2]) - u.col(t.vertices[0]);
    return result;
  }

  State evaluate(const Eigen::Matrix2Xd& u, const double epsilon) const
  {
    State state = { 0, (std::numeric_limits<double>::infinity)() };
    for(const Triangle& t : m_triangles)
    {
      const Eigen::Matrix2d J = edges(t, u) * t.to_rest;
      const double D = J.determinant();
      state.energy += t.area * (J.squaredNorm() + (D * D + 1) / 2) / regularized_determinant(D, epsilon);
      state.smallest_determinant = (std::min)(state.smallest_determinant, D);
    }
    return state;
  }

  State newton_step(const State& before)
  {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(2 * m_number_of_unknowns);
    std::vector<Eigen::Triplet<double> > entries;
    for(const Triangle& t : m_triangles)
      add_derivatives(t, gradient, entries);
    Eigen::SparseMatrix<double> hessian(gradient.size(), gradient.size());
    hessian.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd solution = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> >(hessian).solve(-gradient);

    Eigen::Matrix2Xd direction = Eigen::Matrix2Xd::Zero(2, m_images.cols());
    for(std::size_t v = 0; v < m_unknown.size(); ++v)
      if(m_unknown[v] >= 0)
        direction.col(v) = solution.segment<2>(2 * m_unknown[v]);
    for(double length = 1; length > 1e-12; length /= 2)
    {
      const Eigen::Matrix2Xd candidate = m_images + length * direction;
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

  void add_derivatives(const Triangle& t, Eigen::VectorXd& gradient,
                       std::vector<Eigen::Triplet<double> >& entries) const
  {
    const Eigen::Matrix2d J = edges(t, m_images) * t.to_rest;
    const Eigen::Vector4d j(J(0, 0), J(1, 0), J(0, 1), J(1, 1)), cofactors(J(1, 1), -J(0, 1), -J(1, 0), J(0, 0));
    const double D = J.determinant(), root = std::sqrt(D * D + m_epsilon * m_epsilon);
    const double inverse = 1 / regularized_determinant(D, m_epsilon);
    const double slope = 1 / root;                                                              // chi' / chi
    const double curvature = m_epsilon * m_epsilon / (2 * root * root * root) * inverse;        // chi'' / chi
    const double value = (j.squaredNorm() + (D * D + 1) / 2) * inverse;
    const double first = D * inverse - value * slope; // derivatives by D for fixed |J|
    const double second = inverse - 2 * D * inverse * slope + value * (2 * slope * slope - curvature);

    Eigen::Matrix4d H = second * cofactors * cofactors.transpose();
    H -= 2 * inverse * slope * (j * cofactors.transpose() + cofactors * j.transpose());
    H.diagonal().array() += 2 * inverse;
    H(0, 3) += first;
    H(3, 0) += first;
    H(1, 2) -= first;
    H(2, 1) -= first;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(H);
    H = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(1e-6 * inverse).asDiagonal()
        * eigen.eigenvectors().transpose();

    Eigen::Matrix<double, 4, 6> derivative = Eigen::Matrix<double, 4, 6>::Zero(); // of j by the images
    for(int k = 0; k < 2; ++k)
      for(int i = 0; i < 3; ++i)
        derivative.block<2, 2>(2 * k, 2 * i).diagonal().setConstant(
          (i == 0) ? -t.to_rest.col(k).sum() : t.to_rest(i - 1, k));
    const Eigen::Matrix<double, 6, 1> g
      = t.area * derivative.transpose() * (2 * inverse * j + first * cofactors);
    const Eigen::Matrix<double, 6, 6> h = t.area * derivative.transpose() * H * derivative;
    for(int i = 0; i < 6; ++i)
    {
      const int row = 2 * m_unknown[t.vertices[i / 2]] + i % 2;
      if(row < 0)
        continue;
      gradient[row] += g[i];
      for(int k = 0; k < 6; ++k)
        if(m_unknown[t.vertices[k / 2]] >= 0)
          entries.emplace_back(row, 2 * m_unknown[t.vertices[k / 2]] + k % 2, h(i, k));
    }
  }

  Eigen::Matrix2Xd& m_images;
  const Budget& m_budget;
  std::vector<int> m_unknown; // the number of an inner vertex, or -1
  int m_number_of_unknowns = 0;
  std::vector<Triangle> m_triangles;
  double m_epsilon = 1;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_PATCH_RELAXATION_2_H
