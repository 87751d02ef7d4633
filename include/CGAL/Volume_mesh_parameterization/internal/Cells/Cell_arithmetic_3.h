// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_CELL_ARITHMETIC_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_CELL_ARITHMETIC_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Cells/Pack.h>

// The arithmetic with the instructions of this unit, which is also the one for single cells.
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Kernels/Distortion_derivatives_3.inc>

namespace CGAL::Volume_mesh_parameterization::internal {

namespace arithmetic_of_unit = CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS;

inline arithmetic_of_unit::Signed_singular_values_3<double> decomposed(const Eigen::Matrix3d& J)
{
  arithmetic_of_unit::Matrix_3<double> matrix;
  for(int j = 0; j < 3; ++j)
    for(int i = 0; i < 3; ++i)
      matrix(i, j) = J(i, j);
  arithmetic_of_unit::Signed_singular_values_3<double> result;
  decompose(matrix, result);
  return result;
}

// The signed singular values of a matrix, the smallest of which has the sign of its determinant.
inline Eigen::Vector3d signed_singular_values_3(const Eigen::Matrix3d& J)
{
  const auto s = decomposed(J).s;
  return Eigen::Vector3d(s[0], s[1], s[2]);
}

// The rotation R Q^T that is nearest to a matrix R diag(s) Q^T, and the sum of s.
struct Rotation_and_stretch_3
{
  Eigen::Matrix3d rotation;
  double stretch;
};

inline Rotation_and_stretch_3 rotation_and_stretch_3(const Eigen::Matrix3d& J)
{
  const auto d = decomposed(J);
  const auto R = product(d.R, transposed(d.Q));
  Rotation_and_stretch_3 result;
  for(int j = 0; j < 3; ++j)
    for(int i = 0; i < 3; ++i)
      result.rotation(i, j) = R(i, j);
  result.stretch = d.s[0] + d.s[1] + d.s[2];
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_CELL_ARITHMETIC_3_H
