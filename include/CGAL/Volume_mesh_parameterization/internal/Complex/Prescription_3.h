// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PRESCRIPTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PRESCRIPTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Soft_boundary_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/mistakes.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// What the user tells of the points of a body. Without a target or an initial image, a point has coordinates that are not
// numbers.
struct Prescription_3
{
  std::vector<std::array<double, 3> > targets;
  std::vector<bool> is_constrained;            // inside, as those on the boundary are
  std::vector<std::array<double, 3> > initial; // images to start from; none of any point if there are no entries
  std::vector<Linear_constraint_3<std::size_t> > constraints;

  // New points are told nothing of.
  void resize(const std::size_t number_of_points)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    targets.resize(number_of_points, { nan, nan, nan });
    is_constrained.resize(number_of_points, false);
    if(!initial.empty())
      initial.resize(number_of_points, { nan, nan, nan });
  }
};

// Reads the named parameters about the vertices of a body. `vertex(p)` is what the user calls the point p of a cell.
template <typename Vertex, typename NamedParameters, typename BoundaryMap, typename VertexOfPoint>
Prescription_3 prescription_3(const Body_3& body, const NamedParameters& np, const BoundaryMap& boundary_map,
                              const VertexOfPoint& vertex)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const auto is_constrained = choose_parameter(get_parameter(np, internal_np::vertex_is_constrained),
                                               Static_boolean_property_map<Vertex, false>());
  const auto constraints = choose_parameter(get_parameter(np, internal_np::positional_constraints),
                                            std::vector<Linear_constraint_3<Vertex> >());
  const std::size_t number_of_points = body.soup.points.size();
  const std::vector<bool> is_on_boundary = prescribed_points(body);
  std::vector<bool> has_cell(number_of_points, false);
  for(const std::array<std::size_t, 4>& cell : body.soup.cells)
    for(const std::size_t p : cell)
      has_cell[p] = true;

  Prescription_3 result;
  result.resize(number_of_points);
  std::unordered_map<Vertex, std::size_t> points;
  for(std::size_t p = 0; p < number_of_points; ++p)
    if(has_cell[p])
    {
      result.is_constrained[p] = get(is_constrained, vertex(p));
      if(is_on_boundary[p] || result.is_constrained[p])
        result.targets[p] = coordinates(get(boundary_map, vertex(p)));
      if(!constraints.empty())
        points.emplace(vertex(p), p);
    }
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::initial_map_t>::value)
  {
    const auto initial_map = get_parameter(np, internal_np::initial_map);
    static_assert(Is_map_of<std::remove_const_t<decltype(initial_map)>, Vertex>::value,
                  "initial_map must be a property map of vertices: for a container, pass make_vertex_point_map(container).");
    result.initial.resize(number_of_points);
    for(std::size_t p = 0; p < number_of_points; ++p)
      if(has_cell[p])
        result.initial[p] = coordinates(get(initial_map, vertex(p)));
  }
  for(const Linear_constraint_3<Vertex>& constraint : constraints)
  {
    result.constraints.push_back({ {}, constraint.value });
    for(const auto& term : constraint.terms)
      result.constraints.back().terms.push_back({ points.at(term.vertex), term.coefficient });
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PRESCRIPTION_3_H
