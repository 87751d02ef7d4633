// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_UNAVOIDABLE_ANGLE_DISTORTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_UNAVOIDABLE_ANGLE_DISTORTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/measure_distortion_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Volume_mesh_parameterization::internal {

// The squared singular values of the map between two triangles with edges X and U are the eigenvalues of
// U^T U relative to X^T X.
inline double angle_distortion_of_facet(const Eigen::Matrix<double, 3, 2>& X, const Eigen::Matrix<double, 3, 2>& U)
{
  const Eigen::Matrix2d source = X.transpose() * X, image = U.transpose() * U;
  // of a 2x2 matrix, from half of its trace and its determinant
  const Eigen::Matrix2d relative = source.inverse() * image;
  const double half = relative.trace() / 2;
  const double root = std::sqrt((std::max)(half * half - relative.determinant(), 0.));
  const double largest = half + root;
  return angle_distortion(std::sqrt(largest), std::sqrt((std::max)(relative.determinant() / largest, 0.)));
}

// The largest distortion of angles that the prescribed vertices force alone: that of a cell with four of
// them, and that of a facet with three, which is a lower bound for its cells.
inline double unavoidable_angle_distortion_3(const Numbered_mesh_3& mesh)
{
  double result = 2;
  for(std::array<int, 4> cell : mesh.cells)
  {
    // the prescribed vertices come first
    const auto first_free
      = std::stable_partition(cell.begin(), cell.end(), [&](const int v) { return !mesh.is_free(v); });
    const auto number_of_prescribed = first_free - cell.begin();
    if(number_of_prescribed < 3)
      continue;
    const Eigen::Matrix3d X = edge_matrix(mesh.source, cell), U = edge_matrix(mesh.target, cell);
    if(number_of_prescribed == 4)
    {
      const Eigen::Vector3d s = signed_singular_values_3(U * X.inverse());
      result = (std::max)(result, angle_distortion(s[0], s[2]));
    }
    else
      result = (std::max)(result, angle_distortion_of_facet(X.leftCols<2>(), U.leftCols<2>()));
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_UNAVOIDABLE_ANGLE_DISTORTION_3_H
