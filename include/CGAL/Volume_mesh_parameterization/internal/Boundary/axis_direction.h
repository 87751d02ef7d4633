// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_AXIS_DIRECTION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_AXIS_DIRECTION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Dense>

#include <cstddef>

namespace CGAL::Volume_mesh_parameterization::internal {

// The six directions along the axes: 0 and 1 are +x and -x, 2 and 3 are +y and -y, 4 and 5 are +z and -z.

inline int axis_of_direction(const std::size_t direction)
{
  return static_cast<int>(direction / 2);
}

inline int sign_of_direction(const std::size_t direction)
{
  return (direction % 2 == 0) ? 1 : -1;
}

inline Eigen::Vector3d vector_of_direction(const std::size_t direction)
{
  return sign_of_direction(direction) * Eigen::Vector3d::Unit(axis_of_direction(direction));
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_AXIS_DIRECTION_H
