// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The positions with the prescribed vertices on their targets.
inline Matrix3Xd snapped(const Numbered_mesh_3& mesh, Matrix3Xd positions)
{
  const int n = mesh.number_of_prescribed_vertices();
  positions.rightCols(n) = mesh.target.rightCols(n);
  return positions;
}

inline Found_cells inverted_cells(const Numbered_mesh_3& mesh, const Matrix3Xd& positions)
{
  return find_cells(mesh, [&](const std::array<int, 4>& cell) { return !is_positive(positions, cell); });
}

// The images of all vertices, with the verdict of exact predicates on them.
struct Map_3
{
  Matrix3Xd positions;
  std::size_t number_of_inverted_cells = (std::numeric_limits<std::size_t>::max)(); // or flat ones
  std::vector<std::size_t> inverted_cells; // those of this process
  bool meets_boundary = false;
  double distance_to_boundary = 0; // the largest one of a prescribed vertex; may be zero by underflow

  bool is_valid() const { return number_of_inverted_cells == 0; }
  bool is_solution() const { return is_valid() && meets_boundary; }
};

// Evaluates positions that are to have the prescribed vertices on their targets.
inline Map_3 evaluated_map(const Numbered_mesh_3& mesh, Matrix3Xd positions)
{
  const int n = mesh.number_of_prescribed_vertices();
  Found_cells inverted = inverted_cells(mesh, positions);
  Map_3 map;
  map.number_of_inverted_cells = inverted.number;
  map.inverted_cells = std::move(inverted.cells);
  map.meets_boundary = mesh.communicator->all(positions.rightCols(n) == mesh.target.rightCols(n));
  map.distance_to_boundary
    = mesh.communicator->maximum(n == 0 ? 0 : (positions - mesh.target).rightCols(n).colwise().norm().maxCoeff());
  map.positions = std::move(positions);
  return map;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_MAP_3_H
