// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_POLYCUBE_3_IMPL_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_POLYCUBE_3_IMPL_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Order_of_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Search_for_polycube_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Unit_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/map_to_voxels_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/map_bodies_apart_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/map_in_order_of_planes_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/map_to_bounding_box_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/map_to_polycube_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/rotation_to_axes_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <utility>

namespace CGAL::Polycube_meshing_3::internal {

// Inserts the polycube of a map by its cost. If the map failed, its status becomes that of the search, unless a polycube was found
// or an earlier map failed with another status than ERROR_NO_POLYCUBE.
inline void add_candidate(const char* strategy, const Turned_surface_3& turned, Surface_map_3 map, Found_polycubes_3& found)
{
  if(map.status == OK || found.status == ERROR_NO_POLYCUBE)
    found.status = map.status;
  if(map.status != OK)
    return;
  const double cost = cost_of_map(map) + part_given_up_3(turned.surface, map); // large if a bounding box flattens pockets
  const auto costs_more = [&](const Polycube_candidate_3& candidate) { return candidate.cost > cost; };
  found.candidates.insert(std::find_if(found.candidates.begin(), found.candidates.end(), costs_more),
                          { strategy, turned.rotation, std::move(map), cost });
}

// Returns the surface as it is, or turned such that its normals are close to the axes.
inline Turned_surface_3 turned_surface_3(const Polycube_problem_3& problem, const Boundary_mesh_3& mesh)
{
  const bool do_find_axes = problem.do_find_axes && problem.labels.empty();
  Turned_surface_3 result(problem.surface, mesh, Matrix_3::Identity());
  if(do_find_axes)
    result = Turned_surface_3(problem.surface, mesh, rotation_to_axes_3(result.mesh));
  result.spacing = problem.spacing;
  result.may_move = do_find_axes;
  return result;
}

// Strategy that may lead to a polycube. It is not tried if there is a polycube that costs less than `sufficient_cost`.
struct Polycube_strategy_3
{
  const char* name;
  bool is_possible;
  double sufficient_cost;
  std::function<Surface_map_3()> map;
};

// Maps a surface by one strategy after the other, except for those whose sufficient cost is already undercut.
inline Found_polycubes_3 map_by_strategies_3(const Turned_surface_3& turned, const bool may_split, const Budget& budget)
{
  const Error_code status = check_sphere(turned.mesh);
  const bool is_sphere = status == OK, is_connected = status != ERROR_SEVERAL_BOUNDARY_COMPONENTS;
  const auto map_body = [&](const Numbered_surface_3& body)
  {
    Polycube_problem_3 problem = { body, {}, turned.spacing };
    Found_polycubes_3 found = map_to_polycube_3(problem, budget);
    problem.may_split = may_split; // only if there is no polycube without
    if(found.candidates.empty() && may_split)
      found = map_to_polycube_3(problem, budget);
    return found.candidates.empty() ? Surface_map_3{ found.status } : found.candidates.front().map;
  };
  const auto search = [&](const Unit_surface_3& surface) { return Search_for_polycube_3(surface, budget).run(); };
  constexpr double low_cost = 0.7; // a guess: above it, voxels keep more features of blocks with oblique pockets
  const std::array<Polycube_strategy_3, 4> strategies = {{
    { "labels", true, 0, [&] { return map_with_thin_walls_3(turned, search, budget); } },
    { "bounding box", is_sphere, low_cost, [&] { return map_to_bounding_box_3(turned, budget); } },
    { "bodies side by side", !is_connected, (std::numeric_limits<double>::infinity)(),
      [&] { return map_bodies_apart_3(turned.surface, turned.spacing, map_body); } },
    { "voxels", is_connected && may_split, low_cost, [&] { return map_to_voxels_3(turned, budget); } }
  }};
  Found_polycubes_3 found;
  for(const Polycube_strategy_3& strategy : strategies)
    if(strategy.is_possible && (found.candidates.empty() || !(found.candidates.front().cost < strategy.sufficient_cost)))
      add_candidate(strategy.name, turned, strategy.map(), found);
  return found;
}

// Maps a surface to the polycube of given labels.
inline Surface_map_3 map_with_labels_3(const Unit_surface_3& surface, const std::vector<std::size_t>& labels, const Budget& budget)
{
  Polycube_map_3 map(surface, labels);
  const Error_code status = map.start_close_to_surface(budget);
  return status == OK ? finished_map_3(map, budget) : Surface_map_3{ status };
}

// Maps a surface whose points and facets are in the order of `Order_of_surface_3`.
inline Found_polycubes_3 map_ordered_surface_3(const Polycube_problem_3& problem, const Budget& budget)
{
  constexpr double largest_spacing = 1e60; // cubes of longer edges overflow
  if(problem.spacing > largest_spacing)
    return { ERROR_SPACING_TOO_COARSE };
  Boundary_mesh_3 mesh;
  if(const Error_code status = build_boundary_mesh_3(problem.surface, mesh); status != OK)
    return { status };
  const Turned_surface_3 turned = turned_surface_3(problem, mesh);
  if(problem.labels.empty())
    return map_by_strategies_3(turned, problem.may_split, budget);
  Found_polycubes_3 found;
  const auto map = [&](const Unit_surface_3& surface) { return map_with_labels_3(surface, problem.labels, budget); };
  add_candidate("given labels", turned, map_with_thin_walls_3(turned, map, budget), found);
  return found;
}

CGAL_POLYCUBE_MESHING_3_INLINE
Found_polycubes_3 map_to_polycube_3(const Polycube_problem_3& problem, const Budget& budget)
{
  const Order_of_surface_3 order(problem.surface);
  Polycube_problem_3 ordered = problem;
  ordered.surface = order.surface();
  ordered.labels = order.of_facets(problem.labels);
  Found_polycubes_3 found = map_ordered_surface_3(ordered, budget);
  for(Polycube_candidate_3& candidate : found.candidates)
  {
    candidate.map.images = order.in_given_order(candidate.map.images);
    for(auto& [v, w] : candidate.map.splits)
    {
      v = order.given_point(v);
      w = order.given_point(w);
    }
  }
  return found;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_POLYCUBE_3_IMPL_H
