// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUBE_CORNERS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUBE_CORNERS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Cube_edge_3.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The rotation of the sphere that turns the images into the directions of the points from the centre
// of their bounding box, scaled to a cube, as well as possible (Kabsch).
inline Eigen::Matrix3d rotation_to_bounding_box(const std::vector<Eigen::Vector3d>& points,
                                                const std::vector<Eigen::Vector3d>& images)
{
  Eigen::AlignedBox3d box;
  for(const Eigen::Vector3d& p : points)
    box.extend(p);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for(std::size_t v = 0; v < points.size(); ++v)
    covariance += (points[v] - box.center()).cwiseQuotient(box.sizes()) * images[v].transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  return svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

// Eight different vertices near the corners of a cube that is inscribed in the sphere.
inline std::array<int, 8> cube_corners_3(const std::vector<Eigen::Vector3d>& points,
                                         const std::vector<Eigen::Vector3d>& images)
{
  const Eigen::Matrix3d rotation = rotation_to_bounding_box(points, images);
  std::array<int, 8> corners;
  std::vector<bool> is_corner(points.size(), false);
  for(int k = 0; k < 8; ++k)
  {
    const Eigen::Vector3d corner(side_of_corner(k, 0), side_of_corner(k, 1), side_of_corner(k, 2));
    const Eigen::Vector3d direction = rotation.transpose() * corner;
    double largest = -(std::numeric_limits<double>::infinity)();
    for(std::size_t v = 0; v < images.size(); ++v)
      if(!is_corner[v] && direction.dot(images[v]) > largest)
      {
        largest = direction.dot(images[v]);
        corners[k] = static_cast<int>(v);
      }
    is_corner[corners[k]] = true;
  }
  return corners;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUBE_CORNERS_3_H
