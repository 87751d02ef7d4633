// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_CUBE_CORNERS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_CUBE_CORNERS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Box/Cube_edge_router_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_arithmetic_3.h>

#include <CGAL/number_utils.h>

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The points, moved and scaled such that their bounding box becomes the cube [-1, 1]^3.
inline std::vector<Eigen::Vector3d> in_bounding_cube(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::AlignedBox3d box;
  for(const Eigen::Vector3d& point : points)
    box.extend(point);
  const Eigen::Vector3d sizes = box.sizes().cwiseMax((std::numeric_limits<double>::min)());
  std::vector<Eigen::Vector3d> result;
  for(const Eigen::Vector3d& point : points)
    result.push_back(2 * (point - box.center()).cwiseQuotient(sizes));
  return result;
}

// The rotation that turns the images into the directions of the points as well as possible (Kabsch).
inline Eigen::Matrix3d rotation_between(const std::vector<Eigen::Vector3d>& images,
                                        const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for(std::size_t v = 0; v < points.size(); ++v)
    covariance += points[v] * images[v].transpose();
  return rotation_and_stretch_3(covariance).rotation;
}

// The corner with positive coordinates of the box in the sphere whose faces, seen from the centre, have solid
// angles in the ratio of the areas of the given box. In the unit sphere the angle of the face that is normal to
// the third axis of a box with corner (a, b, c) is 4 atan(a b / c), and so on.
inline Eigen::Vector3d corner_on_sphere(const Eigen::Vector3d& half_lengths)
{
  const Eigen::Vector3d areas = half_lengths.minCoeff() * half_lengths.cwiseInverse();
  Eigen::Vector3d corner;
  for(int axis = 0; axis < 3; ++axis)
  {
    const double t = std::tan(CGAL_PI / 2 * areas[(axis + 1) % 3] / areas.sum());
    const double u = std::tan(CGAL_PI / 2 * areas[(axis + 2) % 3] / areas.sum());
    corner[axis] = std::sqrt(t * u);
  }
  return corner;
}

// Eight different vertices for the corners of a box: such that the patches between them on the sphere, onto which
// the images map the surface, have areas in the ratio of those of the box; and among the vertices close to there,
// those close to the corners of the bounding box.
inline std::array<int, 8> cube_corners_3(const std::vector<Eigen::Vector3d>& points,
                                         const std::vector<Eigen::Vector3d>& images,
                                         const Eigen::Vector3d& half_lengths)
{
  const double weight_of_box = 0.3; // lowered the distortion most over organic and mechanical models
  const std::vector<Eigen::Vector3d> cube_points = in_bounding_cube(points);
  const Eigen::Matrix3d rotation = rotation_between(images, cube_points);
  const Eigen::Vector3d positive_corner = corner_on_sphere(half_lengths);
  std::array<int, 8> corners = {};
  std::vector<bool> is_corner(points.size(), false);
  for(int k = 0; k < 8; ++k)
  {
    const Eigen::Vector3d corner(side_of_corner(k, 0), side_of_corner(k, 1), side_of_corner(k, 2));
    const Eigen::Vector3d direction = rotation.transpose() * corner.cwiseProduct(positive_corner);
    double largest = -(std::numeric_limits<double>::infinity)();
    for(std::size_t v = 0; v < images.size(); ++v)
    {
      const double closeness = direction.dot(images[v]) + weight_of_box * corner.dot(cube_points[v]) / 3;
      if(!is_corner[v] && closeness > largest)
      {
        largest = closeness;
        corners[k] = static_cast<int>(v);
      }
    }
    is_corner[corners[k]] = true;
  }
  return corners;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_CUBE_CORNERS_3_H
