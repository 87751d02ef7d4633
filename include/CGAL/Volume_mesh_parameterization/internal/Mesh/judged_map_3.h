// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_JUDGED_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_JUDGED_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>

#include <Eigen/Core>

#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

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

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_JUDGED_MAP_3_H
