// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Facet_matching_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/projector_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
std::vector<std::array<std::size_t, 3> > facets_of_sides(const std::vector<std::array<std::size_t, 4> >& cells,
                                                         const std::vector<std::size_t>& sides)
{
  std::vector<std::array<std::size_t, 3> > result;
  result.reserve(sides.size());
  for(const std::size_t side : sides)
  {
    const auto [u, v, w] = facet_of_cell(cells[side / 4], side % 4);
    result.push_back({ v, w, u });
  }
  return result;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Body_3 body_of_arrays(std::vector<std::array<double, 3> > points, std::vector<std::array<std::size_t, 4> > cells,
                      std::vector<std::array<std::size_t, 2> > edges, const bool is_parallel)
{
  check_cells(cells, points.size());
  const std::vector<std::size_t> sides = Facet_matching_3(cells, is_parallel).sides_on_boundary();
  const auto boundary = facets_of_sides(cells, sides);
  return { std::move(points), std::move(cells), std::move(edges), boundary, sides, {}, {} };
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE void Prescription_3::extend_to(const std::size_t number_of_points)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  targets.resize(number_of_points, { nan, nan, nan });
  conditions.resize(number_of_points);
  if(!slides_in_source.empty())
    slides_in_source.resize(number_of_points, false);
  if(!initial.empty())
    initial.resize(number_of_points, { nan, nan, nan });
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::vector<bool> Prescription_3::prescribed_points() const
{
  std::vector<bool> result;
  for(const Vertex_condition_3& condition : conditions)
    result.push_back(condition.dimension() < 3);
  return result;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::vector<bool> Prescription_3::fixed_points() const
{
  std::vector<bool> result;
  for(const Vertex_condition_3& condition : conditions)
    result.push_back(is_at_target_first(condition));
  return result;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
std::array<double, 3> completed_target(std::array<double, 3> target, const Vertex_condition_3& condition)
{
  if(condition.is_sliding())
  {
    const std::array<double, 3> point = condition.surface().nearest_point(target).point;
    const auto has_nan = [](const Vector_3& p) { return p.hasNaN(); };
    constexpr double infinity = std::numeric_limits<double>::infinity(); // the fault of the surface, not a missing target
    return has_nan(to_vector(point)) && !has_nan(to_vector(target)) ? std::array{ infinity, infinity, infinity } : point;
  }
  const Matrix_3 P = projector_3(condition);
  for(int i = 0; i < 3; ++i)
    if(std::isnan(target[i]) && P.col(i) == Vector_3::Unit(i))
      target[i] = 0;
  return target;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_3_IMPL_H
