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

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <utility>

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

// With the prescribed vertices to be on their targets.
inline Map_3 judged(const Numbered_mesh_3& mesh, Eigen::Matrix3Xd positions)
{
  Map_3 map;
  map.number_of_inverted_cells = inverted_cells(mesh, positions).number;
  map.meets_boundary = is_on_target(mesh, positions);
  map.distance_to_boundary = largest_distance_to_target(mesh, positions);
  map.positions = std::move(positions);
  return map;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_MAP_3_H
