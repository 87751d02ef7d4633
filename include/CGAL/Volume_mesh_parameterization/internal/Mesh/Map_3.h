// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_point_3.h>

#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// Is the cell positively oriented? Decided by exact predicates on the coordinates as they are.
inline bool is_positive(const Eigen::Matrix3Xd& positions, const std::array<int, 4>& cell)
{
  const auto point = [&](const int i) { return exact_point(positions.col(cell[i])); };
  return is_positive_cell({ point(0), point(1), point(2), point(3) });
}

// How many cells there are with some property, and the first of them in the order of the user.
struct Found_cells
{
  std::size_t number = 0;
  std::size_t first = 0;
  bool has_first = false; // does this process own it?
};

template <typename Condition>
Found_cells find_cells(const Numbered_mesh_3& mesh, const Condition& condition)
{
  const std::vector<char> is_found = values_of_cells(mesh, mesh.number_of_own_cells(),
    [&](const std::array<int, 4>& cell) { return static_cast<char>(condition(cell)); });
  Found_cells result;
  for(std::size_t c = 0; c < is_found.size(); ++c)
    if(is_found[c] && (result.number++ == 0 || mesh.user_number(c) < mesh.user_number(result.first)))
      result.first = c;
  const double first = result.number > 0 ? static_cast<double>(mesh.user_number(result.first))
                                         : std::numeric_limits<double>::infinity();
  result.has_first = mesh.communicator->minimum(first) == first && result.number > 0;
  result.number = static_cast<std::size_t>(mesh.communicator->sum(static_cast<double>(result.number)));
  return result;
}

inline Found_cells inverted_cells(const Numbered_mesh_3& mesh, const Eigen::Matrix3Xd& positions)
{
  return find_cells(mesh, [&](const std::array<int, 4>& cell) { return !is_positive(positions, cell); });
}

// Those of the cells with four prescribed vertices whose targets give them no positive volume.
inline Found_cells inverted_prescribed_cells(const Numbered_mesh_3& mesh)
{
  return find_cells(mesh, [&](const std::array<int, 4>& cell)
  {
    return std::none_of(cell.begin(), cell.end(), [&](const int v) { return mesh.is_free(v); })
           && !is_positive(mesh.target, cell);
  });
}

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

// Why no map was found with fixed boundary.
struct Diagnosis_3
{
  std::vector<std::size_t> inverted_cells;
  std::size_t number_of_proofs = 0; // that there is none
  std::string message;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_MAP_3_H
