// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPLIT_EDGE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPLIT_EDGE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>

namespace CGAL::Volume_mesh_parameterization::internal {

// Splits an edge of a closed surface at its midpoint, and the facets beside it. The new vertex comes behind all others, and so do
// half of the edge, the two edges from its midpoint, and their facets. Returns the ends of the edge.
inline std::array<std::size_t, 2> split_edge_3(Boundary_mesh_3& mesh, const Boundary_mesh_3::Edge_index e)
{
  const auto h = mesh.halfedge(e);
  const auto v = mesh.source(h), w = mesh.target(h);
  const auto half = CGAL::Euler::split_edge(h, mesh); // from v to the midpoint
  mesh.point(mesh.target(half)) = exact_point((to_vector(mesh.point(v)) + to_vector(mesh.point(w))) / 2);
  for(const auto g : { half, mesh.opposite(h) }) // both end at the midpoint
    CGAL::Euler::split_face(g, mesh.next(mesh.next(g)), mesh);
  return { v, w };
}

// Returns the longest edge of the facet beside a halfedge.
inline Boundary_mesh_3::Edge_index longest_edge(const Boundary_mesh_3& mesh, const Boundary_mesh_3::Halfedge_index h,
                                                const std::vector<double>& lengths)
{
  const std::array<Boundary_mesh_3::Edge_index, 3> around = { mesh.edge(h), mesh.edge(mesh.next(h)), mesh.edge(mesh.prev(h)) };
  return *std::max_element(around.begin(), around.end(), [&](const auto e, const auto f) { return lengths[e] < lengths[f]; });
}

// Returns edges once each, with others such that no facet is split unless its longest edge is. This keeps its angles from becoming
// ever smaller if longer edges are split first.
inline std::vector<Boundary_mesh_3::Edge_index> with_longest_edges(const Boundary_mesh_3& mesh,
                                                                   const std::vector<Boundary_mesh_3::Edge_index>& edges,
                                                                   const std::vector<double>& lengths)
{
  std::vector<Boundary_mesh_3::Edge_index> result;
  std::vector<bool> is_among(mesh.number_of_edges(), false);
  const auto add = [&](const auto e)
  {
    if(is_among[e])
      return;
    is_among[e] = true;
    result.push_back(e);
  };
  std::for_each(edges.begin(), edges.end(), add);
  for(std::size_t i = 0; i < result.size(); ++i) // also those that are added here
    for(const auto h : { mesh.halfedge(result[i]), mesh.opposite(mesh.halfedge(result[i])) })
      add(longest_edge(mesh, h, lengths));
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPLIT_EDGE_3_H
