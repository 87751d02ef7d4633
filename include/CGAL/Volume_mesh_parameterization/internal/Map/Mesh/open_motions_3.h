// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_OPEN_MOTIONS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_OPEN_MOTIONS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>

#include <Eigen/Dense>

namespace CGAL::Volume_mesh_parameterization::internal {

// Motions of an image as a whole that conditions leave open: three rotations, three translations, and perhaps the scale. Steps are
// taken back to the conditions, and as far as these leave it open to the shape of the source, and then to its center.
class Open_motions_3
{
public:
  Open_motions_3(const Numbered_mesh_3& mesh, const bool may_scale) : m_mesh(mesh), m_may_scale(may_scale) {}

  // Returns the number of directions that are open at some positions.
  int number(const Matrix3Xd& positions) const
  {
    return static_cast<int>(solved(Square::Identity(), System(*this, positions).conditions).second.cols());
  }

  // Returns the positions moved such that the sum of the squared distances to the source is least, first without the centers of
  // both, and then of the centers. Otherwise, a body would turn if only one vertex moves away.
  Matrix3Xd nearest_to_source(Matrix3Xd positions) const
  {
    constexpr int maximum_number_of_steps = 200; // a guess
    constexpr double rounding = 1e-13;
    for(int step = 0; step < maximum_number_of_steps; ++step)
    {
      const System system(*this, positions);
      auto [d, open] = solved(Square::Identity(), system.conditions);
      for(const Normal_equations& next : { system.shape, system.center_of_source })
      {
        const auto [part, rest] = solved(open, { next.matrix, next.right_side - next.matrix * d });
        d += part;
        open = rest;
      }
      if(!(d.norm() > rounding))
        break;
      positions = system.moved(positions, d * (std::min)(1., 0.5 / d.norm())); // no turn is larger than half a radian
    }
    return positions;
  }

private:
  using Motion = Eigen::Matrix<double, 7, 1>;
  using Square = Eigen::Matrix<double, 7, 7>;
  using Directions = Eigen::Matrix<double, 7, Eigen::Dynamic>;

  struct Normal_equations
  {
    Square matrix = Square::Zero();
    Motion right_side = Motion::Zero();
  };

  // Returns the least solution in the space of some orthonormal directions, and those directions that are left open.
  static std::pair<Motion, Directions> solved(const Directions& space, const Normal_equations& equations)
  {
    constexpr double rounding = 1e-12; // a guess; relative to the trace
    const Eigen::Index n = space.cols();
    const double trace = equations.matrix.trace();
    Square reduced = (trace > 0 ? 2 * trace : 1.) * Square::Identity(); // the largest eigenvalues stand for no direction
    reduced.topLeftCorner(n, n) = space.transpose() * equations.matrix * space;
    const Eigen::SelfAdjointEigenSolver<Square> solver(reduced);
    const Eigen::Index number = (solver.eigenvalues().array() <= rounding * trace).count(), others = n - number;
    const Directions open = space * solver.eigenvectors().topLeftCorner(n, number);
    const Directions met = space * solver.eigenvectors().block(0, number, n, others);
    Motion result = Motion::Zero();
    if(others > 0)
      result = met * (met.transpose() * equations.right_side).cwiseQuotient(solver.eigenvalues().segment(number, others));
    return { result, open };
  }

  static Eigen::Vector3d vector(const Vector_3& v) { return v; }

  // The normal equations of the distances to the conditions and to the source, about the center of the image.
  struct System
  {
    Eigen::Vector3d center;
    double radius;
    Normal_equations conditions, shape, center_of_source;

    System(const Open_motions_3& motions, const Matrix3Xd& positions) : center(positions.rowwise().mean())
    {
      const Numbered_mesh_3& mesh = motions.m_mesh;
      const Eigen::Vector3d source_center = mesh.source.rowwise().mean();
      const double spread = (positions.colwise() - center).squaredNorm();
      radius = std::sqrt(spread / positions.cols());
      for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices(); ++v)
      {
        const auto J = velocities(positions.col(v));
        const Eigen::Matrix3d Q = Matrix_3::Identity() - mesh.projector(v);
        conditions.matrix += J.transpose() * Q * J;
        conditions.right_side += J.transpose() * (Q * vector(mesh.target.col(v) - positions.col(v)));
      }
      if(!motions.m_may_scale)
        conditions.matrix(6, 6) += 3 * spread;
      for(int v = 0; v < mesh.number_of_vertices(); ++v)
      {
        auto J = velocities(positions.col(v));
        J.middleCols<3>(3).setZero();
        shape.matrix += J.transpose() * J;
        shape.right_side += J.transpose() * (vector(mesh.source.col(v)) - source_center - vector(positions.col(v)) + center);
      }
      // a bound of the Hessian: steps do not turn too far if the image is small
      shape.matrix.topLeftCorner<3, 3>() *= std::sqrt((mesh.source.colwise() - source_center).squaredNorm() / spread);
      center_of_source.matrix.block<3, 3>(3, 3).setIdentity();
      center_of_source.right_side.segment<3>(3) = (source_center - center) / radius;
    }

    Eigen::Matrix<double, 3, 7> velocities(const Eigen::Vector3d& p) const
    {
      const Eigen::Vector3d x = p - center;
      Eigen::Matrix<double, 3, 7> result;
      result << Eigen::Vector3d::UnitX().cross(x), Eigen::Vector3d::UnitY().cross(x), Eigen::Vector3d::UnitZ().cross(x),
                radius * Eigen::Matrix3d::Identity(), x;
      return result;
    }

    Matrix3Xd moved(const Matrix3Xd& positions, const Motion& d) const
    {
      const double angle = d.head<3>().norm();
      Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
      if(angle > 0)
        turn = Eigen::AngleAxisd(angle, d.head<3>() / angle).toRotationMatrix();
      const Eigen::Vector3d new_center = center + radius * d.segment<3>(3);
      return ((std::exp(d[6]) * turn) * (positions.colwise() - center)).colwise() + new_center;
    }
  };

  const Numbered_mesh_3& m_mesh;
  bool m_may_scale;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_OPEN_MOTIONS_3_H
