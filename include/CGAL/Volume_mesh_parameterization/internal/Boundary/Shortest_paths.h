// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SHORTEST_PATHS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SHORTEST_PATHS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Shortest paths in a graph from the nearest one of some vertices, by Dijkstra's algorithm. Edges of infinite length are not used.
struct Shortest_paths
{
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  std::vector<double> distance;
  std::vector<std::size_t> previous; // vertex on the path to each one that has been reached; itself, where it begins

  // Calls `for_each_edge(v, reach)`, which calls `reach(w, length)` for the edges from v, for one vertex after the other until
  // `is_end(v)`.
  template <typename Sources, typename ForEachEdge, typename IsEnd>
  Shortest_paths(const std::size_t n, const Sources& sources, const ForEachEdge& for_each_edge, const IsEnd& is_end)
    : distance(n, infinity), previous(n)
  {
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    const auto reach_from = [&](const std::size_t v, const std::size_t w, const double d)
    {
      if(!(d < distance[w]))
        return;
      distance[w] = d;
      previous[w] = v;
      queue.push({ d, w });
    };
    for(const std::size_t v : sources)
      reach_from(v, v, 0);
    while(!queue.empty() && !is_end(queue.top().second))
    {
      const auto [d, v] = queue.top();
      queue.pop();
      if(d == distance[v])
        for_each_edge(v, [&, v = v, d = d](const std::size_t w, const double length) { reach_from(v, w, d + length); });
    }
  }

  // Returns the vertices on the path to a vertex; none if it has not been reached.
  std::vector<std::size_t> path_to(std::size_t v) const
  {
    if(distance[v] == infinity)
      return {};
    std::vector<std::size_t> result(1, v);
    for(; previous[v] != v; v = previous[v])
      result.push_back(previous[v]);
    std::reverse(result.begin(), result.end());
    return result;
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SHORTEST_PATHS_H
