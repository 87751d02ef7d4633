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

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/alignment_3.h>

#include <Eigen/Jacobi>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
    const System system(*this, positions);
    return static_cast<int>(std::lround(solved(Square::Identity(), system.conditions).second.trace()));
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
      positions = moved(system.similarity(d * (std::min)(1., 0.5 / d.norm())), positions); // no turn is larger than half a radian
    }
    return positions;
  }

private:
  using Motion = Small_matrix<7, 1>;
  using Square = Small_matrix<7, 7>;

  using Velocities = std::array<Vector_3, 7>; // of a point, for each direction

  struct Normal_equations
  {
    Square matrix = Square::Zero();
    Motion right_side = Motion::Zero();

    // Adds those of a point that has some way to go in the range of a projector.
    void add(const Velocities& J, const Matrix_3& projector, const Vector_3& way)
    {
      for(int i = 0; i < 7; ++i)
      {
        const Vector_3 part = projector * J[i];
        right_side[i] += part.dot(way);
        for(int j = 0; j < 7; ++j)
          matrix(i, j) += part.dot(J[j]);
      }
    }
  };

  // Returns the least solution in a space, and the space of directions that are left open, both spaces as orthogonal projectors.
  static std::pair<Motion, Square> solved(const Square& space, const Normal_equations& equations)
  {
    constexpr double rounding = 1e-12; // a guess; relative to the trace
    const double trace = equations.matrix.trace();
    const Square reduced = space * equations.matrix * space; // other directions get the largest eigenvalues
    const Motion right_side = space * equations.right_side;
    const auto [values, vectors] = eigen_decomposition(reduced + (trace > 0 ? 2 * trace : 1.) * (Square::Identity() - space));
    std::pair<Motion, Square> result = { Motion::Zero(), Square::Zero() };
    for(int i = 0; i < 7; ++i)
    {
      const Motion v = vectors.col(i);
      if(values[i] <= rounding * trace)
        result.second += v * v.transpose();
      else
        result.first += v.dot(right_side) / values[i] * v;
    }
    return result;
  }

  // Returns the eigenvalues and eigenvectors by Jacobi rotations, which converge quadratically. Compilers take several seconds for
  // the solver of Eigen.
  static std::pair<Motion, Square> eigen_decomposition(Square A)
  {
    constexpr int number_of_sweeps = 12; // a guess, twice what large matrices need
    Square vectors = Square::Identity();
    for(int sweep = 0; sweep < number_of_sweeps; ++sweep)
      for(int q = 1; q < 7; ++q)
        for(int p = 0; p < q; ++p)
          if(Eigen::JacobiRotation<double> rotation; rotation.makeJacobi(A, p, q))
          {
            A.applyOnTheLeft(p, q, rotation.adjoint());
            A.applyOnTheRight(p, q, rotation);
            vectors.applyOnTheRight(p, q, rotation);
          }
    return { A.diagonal(), vectors };
  }

  // The normal equations of the distances to the conditions and to the source, about the center of the image.
  struct System
  {
    Vector_3 center;
    double radius;
    Normal_equations conditions, shape, center_of_source;

    System(const Open_motions_3& motions, const Matrix3Xd& positions) : center(positions.rowwise().mean())
    {
      const Numbered_mesh_3& mesh = motions.m_mesh;
      const Vector_3 source_center = mesh.source.rowwise().mean();
      const double spread = squared_distances(positions, center);
      radius = std::sqrt(spread / positions.cols());
      for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices(); ++v)
        conditions.add(velocities(positions.col(v)), Matrix_3::Identity() - mesh.projector(v),
                       mesh.target.col(v) - positions.col(v));
      if(!motions.m_may_scale)
        conditions.matrix(6, 6) += 3 * spread;
      for(int v = 0; v < mesh.number_of_vertices(); ++v)
      {
        Velocities J = velocities(positions.col(v));
        std::fill_n(J.begin() + 3, 3, Vector_3::Zero());
        shape.add(J, Matrix_3::Identity(), mesh.source.col(v) - source_center - (positions.col(v) - center));
      }
      // a bound of the Hessian: steps do not turn too far if the image is small
      shape.matrix.topLeftCorner<3, 3>() *= std::sqrt(squared_distances(mesh.source, source_center) / spread);
      for(int i = 0; i < 3; ++i)
      {
        center_of_source.matrix(3 + i, 3 + i) = 1;
        center_of_source.right_side[3 + i] = (source_center[i] - center[i]) / radius;
      }
    }

    static double squared_distances(const Matrix3Xd& points, const Vector_3& center)
    {
      double result = 0;
      for(int v = 0; v < points.cols(); ++v)
        result += (points.col(v) - center).squaredNorm();
      return result;
    }

    Velocities velocities(const Vector_3& p) const
    {
      const Vector_3 x = p - center;
      Velocities result;
      for(int i = 0; i < 3; ++i)
      {
        result[i] = Vector_3::Unit(i).cross(x);
        result[3 + i] = radius * Vector_3::Unit(i);
      }
      result[6] = x;
      return result;
    }

    Similarity_3 similarity(const Motion& d) const
    { return { std::exp(d[6]), rotation_3({ d[0], d[1], d[2] }), center, center + radius * Vector_3(d[3], d[4], d[5]) }; }
  };

  const Numbered_mesh_3& m_mesh;
  bool m_may_scale;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_OPEN_MOTIONS_3_H
