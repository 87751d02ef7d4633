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

#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_arithmetic_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The source, rotated, scaled and translated such that the sum of the squared distances of its
// prescribed vertices to their targets is minimal. Keeps every orientation: the rotation is proper
// and the scale positive. (Jin et al. minimize the same sum over 13 variables with a penalty that makes
// the matrix nearly a scaled rotation, and round the result; the closed form is due to Umeyama 1991.)
inline Eigen::Matrix3Xd similarity_alignment_3(const Numbered_mesh_3& mesh)
{
  const Eigen::Index n = mesh.number_of_vertices() - mesh.number_of_free_vertices;
  if(n == 0)
    return mesh.source;
  const auto source = mesh.source.rightCols(n), target = mesh.target.rightCols(n);
  const Eigen::Vector3d source_mean = source.rowwise().mean(), target_mean = target.rowwise().mean();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double variance = 0;
  for(Eigen::Index i = 0; i < n; ++i)
  {
    const Eigen::Vector3d x = source.col(i) - source_mean;
    covariance += (target.col(i) - target_mean) * x.transpose();
    variance += x.squaredNorm();
  }
  const Rotation_and_stretch_3 polar = rotation_and_stretch_3(covariance);
  const double scale = polar.stretch / variance;
  // without a correlation of source and target the best scale would be zero
  if(!(scale > 0))
    return mesh.source;
  const Eigen::Matrix3d scaled_rotation = scale * polar.rotation;
  Eigen::Matrix3Xd result(3, mesh.source.cols());
  for(Eigen::Index v = 0; v < result.cols(); ++v)
    result.col(v) = scaled_rotation * (mesh.source.col(v) - source_mean) + target_mean;
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_SIMILARITY_ALIGNMENT_3_H
