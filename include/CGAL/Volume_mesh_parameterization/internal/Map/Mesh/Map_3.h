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

// The vector from the nearest point at which a vertex may be.
inline Vector_3 offset_3(const Matrix_3& projector, const Vector_3& position, const Vector_3& target)
{
  const Matrix_3 Q = Matrix_3::Identity() - projector;
  const Vector_3 d = position - target;
  return d[0] * Q.col(0) + (d[1] * Q.col(1) + d[2] * Q.col(2));
}

// Returns the nearest point at which a vertex may be. A coordinate that cannot change has the bits of the target.
inline Vector_3 allowed_point_3(const Vertex_condition_3& condition, const Vector_3& position, const Vector_3& target)
{
  if(condition.is_sliding())
    return put_on_surface_3(condition, position).first;
  const Matrix_3 projector = projector_3(condition);
  Vector_3 result = position - offset_3(projector, position, target);
  for(int k = 0; k < 3; ++k)
    if(projector.row(k) == Vector_3::Zero())
      result[k] = target[k];
  return result;
}

// Returns a distance below which a vertex is where it may be.
inline double rounding_of_targets(const Numbered_mesh_3& mesh) { return 1e-14 * mesh.target.cwiseAbs().maxCoeff(); }

// Returns the positions with the prescribed vertices on their targets, or at the nearest points at which they may be. Vertices on
// surfaces keep each digit, as steps judge facets at these positions, and a facet next to edges of a surface may depend on it.
inline Matrix3Xd snapped(const Numbered_mesh_3& mesh, Matrix3Xd positions, const Conditions_3& conditions)
{
  const int n = mesh.number_of_prescribed_vertices();
  if(conditions.empty())
  {
    positions.rightCols(n) = mesh.target.rightCols(n);
    return positions;
  }
  const double rounding = rounding_of_targets(mesh);
  for(std::size_t i = 0; i < conditions.size(); ++i)
  {
    const int v = mesh.number_of_free_vertices + static_cast<int>(i);
    const Vector_3 p = positions.col(v), q = allowed_point_3(conditions[i], p, mesh.target.col(v));
    if(!conditions[i].is_sliding() || length_3(q - p) > rounding) // not if its surface has no point
      positions.col(v) = q;
  }
  return positions;
}

inline Matrix3Xd snapped(const Numbered_mesh_3& mesh, Matrix3Xd positions)
{ return snapped(mesh, std::move(positions), mesh.conditions); }

// A prescribed vertex, and how far it is from where it may be.
struct Missing_vertex_3
{
  int vertex = -1;       // of this process; -1 if none is missing
  Vector_3 allowed = {}; // the nearest point at which it may be
  double distance = 0;   // infinite if its surface has no point
};

// Returns the prescribed vertex that is farthest from its target, plane, line or surface. Errors of rounding count as 0; along
// the axes, there are none.
inline Missing_vertex_3 farthest_vertex_3(const Numbered_mesh_3& mesh, const Matrix3Xd& positions, const Conditions_3& conditions,
                                          const double rounding)
{
  Missing_vertex_3 result;
  for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices(); ++v)
  {
    const Vertex_condition_3 condition
      = conditions.empty() ? Vertex_condition_3::at_target() : conditions[v - mesh.number_of_free_vertices];
    const Vector_3 p = positions.col(v), q = allowed_point_3(condition, p, mesh.target.col(v));
    const double length = length_3(q - p), distance = std::isnan(length) ? std::numeric_limits<double>::infinity() : length;
    const bool is_exact = !condition.is_sliding() && projector_3(condition).is_diagonal();
    if(distance > result.distance && distance > (is_exact ? 0 : rounding))
      result = { v, q, distance };
  }
  return result;
}

inline Found_cells inverted_cells(const Numbered_mesh_3& mesh, const Matrix3Xd& positions)
{
  return find_cells(mesh, [&](const std::array<int, 4>& cell) { return !is_positive(positions, cell); });
}

// Images of all vertices, with the verdict of exact predicates on them.
struct Map_3
{
  Matrix3Xd positions;
  std::size_t number_of_inverted_cells = (std::numeric_limits<std::size_t>::max)(); // or flat ones
  std::vector<std::size_t> inverted_cells; // those of this process
  bool meets_boundary = false;
  double distance_to_boundary = 0; // the largest one of a prescribed vertex; may be zero by underflow
  Missing_vertex_3 farthest_vertex;

  bool is_valid() const { return number_of_inverted_cells == 0; }
  bool is_solution() const { return is_valid() && meets_boundary; }
};

// Evaluates positions that are to have the prescribed vertices where they may be, within rounding.
inline Map_3 evaluated_map(const Numbered_mesh_3& mesh, Matrix3Xd positions, const Conditions_3& conditions,
                           const double rounding)
{
  const int n = mesh.number_of_prescribed_vertices();
  Found_cells inverted = inverted_cells(mesh, positions);
  Map_3 map;
  map.number_of_inverted_cells = inverted.number;
  map.inverted_cells = std::move(inverted.cells);
  map.farthest_vertex = farthest_vertex_3(mesh, positions, conditions, rounding);
  map.distance_to_boundary = mesh.communicator->maximum(map.farthest_vertex.distance);
  map.meets_boundary = mesh.communicator->all(conditions.empty() ? positions.rightCols(n) == mesh.target.rightCols(n)
                                                                 : map.distance_to_boundary == 0);
  map.positions = std::move(positions);
  return map;
}

inline Map_3 evaluated_map(const Numbered_mesh_3& mesh, Matrix3Xd positions, const Conditions_3& conditions)
{
  const double rounding = conditions.empty() ? 0 : rounding_of_targets(mesh); // a process may have no target
  return evaluated_map(mesh, std::move(positions), conditions, rounding);
}

inline Map_3 evaluated_map(const Numbered_mesh_3& mesh, Matrix3Xd positions)
{ return evaluated_map(mesh, std::move(positions), mesh.conditions); }

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_MAP_3_H
