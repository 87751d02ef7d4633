// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_PROJECTOR_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_PROJECTOR_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Vertex_condition_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <algorithm>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

using Conditions_3 = std::vector<Vertex_condition_3>;

inline bool slides_in_boundary(const Vertex_condition_3& condition)
{ return condition.kind() == Vertex_condition_3::IN_BOUNDARY; }

// Returns whether a vertex is at its target first, and slides later.
inline bool does_slide_later(const Vertex_condition_3& condition)
{ return condition.is_sliding() || slides_in_boundary(condition); }

inline bool is_at_target_first(const Vertex_condition_3& condition)
{ return condition.dimension() == 0 || does_slide_later(condition); }

inline bool are_some_in_boundary(const Conditions_3& conditions)
{ return std::any_of(conditions.begin(), conditions.end(), slides_in_boundary); }

inline bool are_some_on_surfaces(const Conditions_3& conditions)
{ return std::any_of(conditions.begin(), conditions.end(), [](const Vertex_condition_3& c) { return c.is_sliding(); }); }

// Returns the projector onto the directions in which a vertex may move: space, a plane, a line or a point. A vertex that slides
// stays until then.
inline Matrix_3 projector_3(const Vertex_condition_3& condition)
{
  const auto& [x, y, z] = condition.direction();
  const Vector_3 n = unit_vector_3(Vector_3(x, y, z));
  switch(condition.kind())
  {
    case Vertex_condition_3::FREE: return Matrix_3::Identity();
    case Vertex_condition_3::IN_PLANE: return Matrix_3::Identity() - Matrix_3::outer_product(n, n);
    case Vertex_condition_3::ON_LINE: return Matrix_3::outer_product(n, n);
    default: return Matrix_3::Zero();
  }
}

// Returns the projector for a vertex that slides, where the unit normal of its surface or the tangent of its curve is known.
inline Matrix_3 projector_3(const Vertex_condition_3& condition, const Vector_3& direction)
{
  const Matrix_3 along = Matrix_3::outer_product(direction, direction);
  return condition.dimension() == 1 ? along : Matrix_3::Identity() - along;
}

// Returns the point to which a vertex is put back on its surface or curve, and the unit normal or tangent there.
inline std::pair<Vector_3, Vector_3> put_on_surface_3(const Vertex_condition_3& condition, const Vector_3& p)
{
  const auto [point, direction] = condition.surface().nearest_point({ p[0], p[1], p[2] });
  return { to_vector(point), unit_vector_3(to_vector(direction)) };
}

// Returns whether the conditions keep all these vertices in one plane, wherever they move, and not each at its target. A plane
// orthogonal to an axis is known exactly, any other within rounding.
template <typename Vertices, typename ProjectorOf, typename TargetOf>
bool are_kept_in_one_plane(const Vertices& vertices, const ProjectorOf& projector, const TargetOf& target)
{
  constexpr double rounding = 1e-12;
  std::vector<Vector_3> normals = { Vector_3::Unit(0), Vector_3::Unit(1), Vector_3::Unit(2) };
  bool is_one_moving = false;
  for(const auto v : vertices)
  {
    const Matrix_3 Q = Matrix_3::Identity() - projector(v);
    const int k = Vector_3(Q.col(0).norm(), Q.col(1).norm(), Q.col(2).norm()).largest_index();
    if(Q.is_zero())
      return false;
    is_one_moving = is_one_moving || Q != Matrix_3::Identity();
    if(Q.trace() < 1.5 && !Q.is_diagonal()) // the normal of a plane
      normals.push_back(Q.col(k).normalized());
  }
  const Vector_3 origin = target(*std::begin(vertices));
  for(std::size_t i = 0; i < normals.size() && is_one_moving; ++i)
    if(std::all_of(std::begin(vertices), std::end(vertices), [&](const auto v)
    {
      const Vector_3 p = target(v);
      const double bound = i < 3 ? 0 : rounding * (p.norm() + origin.norm());
      return (projector(v) * normals[i]).norm() <= (i < 3 ? 0 : rounding) && std::abs(normals[i].dot(p - origin)) <= bound;
    }))
      return true;
  return false;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_PROJECTOR_3_H
