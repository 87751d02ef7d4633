// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// The images of all vertices, with the verdict of exact predicates on them.
struct Map_3
{
  Eigen::Matrix3Xd positions;
  std::size_t number_of_inverted_cells = (std::numeric_limits<std::size_t>::max)(); // or flat ones
  bool meets_boundary = false;
  double distance_to_boundary = 0; // the largest one of a prescribed vertex; may be zero by underflow

  bool is_valid() const { return number_of_inverted_cells == 0; }
  bool is_solution() const { return is_valid() && meets_boundary; }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_MAP_3_H
