// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_SIMILARITY_ALIGNMENT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_SIMILARITY_ALIGNMENT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <cmath>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The source, rotated, scaled and translated such that the sum of the squared distances of its
// prescribed vertices to their targets is minimal. Keeps every orientation: the rotation is proper
// and the scale positive. (Jin et al. minimize the same sum over 13 variables with a penalty that makes
// the matrix nearly a scaled rotation, and round the result; the closed form is due to Umeyama 1991.)
inline Eigen::Matrix3Xd similarity_alignment_3(const Numbered_mesh_3& mesh)
{
  const Eigen::Index n = mesh.number_of_vertices() - mesh.number_of_free_vertices;
  if(n == 0)
    return mesh.source;
  const Eigen::MatrixXd source = mesh.source.rightCols(n); // of dynamic size: GCC 12 warns of fixed ones
  const Eigen::MatrixXd target = mesh.target.rightCols(n);
  const Eigen::MatrixXd similarity = Eigen::umeyama(source, target);
  const Eigen::Matrix3d scaled_rotation = similarity.topLeftCorner<3, 3>();
  // without a correlation of source and target the best scale would be zero
  const bool is_invertible = scaled_rotation.determinant() > 0;
  if(!is_invertible)
    return mesh.source;
  return (scaled_rotation * mesh.source).colwise() + similarity.topRightCorner<3, 1>();
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_SIMILARITY_ALIGNMENT_3_H
