// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_TO_VECTOR_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_TO_VECTOR_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <array>

namespace CGAL::Volume_mesh_parameterization::internal {

template <typename Point>
Eigen::Vector3d to_vector(const Point& p)
{
  return Eigen::Vector3d(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

inline Eigen::Vector3d to_vector(const std::array<double, 3>& p)
{
  return Eigen::Vector3d(p[0], p[1], p[2]);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_TO_VECTOR_H
