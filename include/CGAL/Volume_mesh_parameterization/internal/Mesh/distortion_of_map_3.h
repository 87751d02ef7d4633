// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_DISTORTION_OF_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_DISTORTION_OF_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Signed_singular_values_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The distortions of the map from the source to `image`, and the mean of psi over the cells with
// both meshes scaled to one volume.
struct Distortion_of_map_3
{
  Distortion_3 as_it_is;
  Distortion_3 at_source_volume;
  double energy = 0;
};

inline void add_cell(Distortion_3& distortion, const double cell_volume, const Eigen::Vector3d& s)
{
  const double angle = s[0] / s[2] + s[2] / s[0];
  const double determinant = s.prod();
  const double change = determinant + 1 / determinant;
  distortion.angle_mean += cell_volume * angle;
  distortion.angle_max = (std::max)(distortion.angle_max, angle);
  distortion.volume_mean += cell_volume * change;
  distortion.volume_max = (std::max)(distortion.volume_max, change);
}

// The distortions that are no numbers: cells may be so flat that rounding leaves no singular value above 0.
inline void replace_by_infinity(Distortion_3& distortion)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if(std::isnan(distortion.angle_mean))
    distortion.angle_mean = distortion.angle_max = infinity;
  if(std::isnan(distortion.volume_mean))
    distortion.volume_mean = distortion.volume_max = infinity;
}

template <typename Energy>
Distortion_of_map_3 distortion_of_map_3(const Numbered_mesh_3& mesh, const Eigen::Matrix3Xd& image, const Energy& energy)
{
  const double source_volume = volume(mesh.source, mesh.cells);
  const double scale = std::cbrt(source_volume / volume(image, mesh.cells));
  Distortion_of_map_3 result;
  const std::vector<double> weights = cell_weights(mesh);
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
  {
    const std::array<int, 4>& cell = mesh.cells[c];
    const Eigen::Matrix3d X = edge_matrix(mesh.source, cell);
    const Eigen::Matrix3d J = edge_matrix(image, cell) * X.inverse();
    const Eigen::Vector3d s = signed_singular_values_3<double>(J).s;
    const double cell_volume = X.determinant() / 6 / source_volume;
    add_cell(result.as_it_is, cell_volume, s);
    add_cell(result.at_source_volume, cell_volume, scale * s);
    result.energy += weights[c] * energy.value(Eigen::Vector3d(scale * s));
  }
  replace_by_infinity(result.as_it_is);
  replace_by_infinity(result.at_source_volume);
  if(std::isnan(result.energy))
    result.energy = std::numeric_limits<double>::infinity();
  return result;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_DISTORTION_OF_MAP_3_H
