// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SHORTEST_VERTEX_PATH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SHORTEST_VERTEX_PATH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Vertex_rings_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>

#include <Eigen/Dense>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The shortest path along edges, or an empty one. The length of an edge is multiplied by the cost of its end,
// which is infinite for vertices that the path may not touch; that of the target does not matter.
inline std::vector<int> shortest_vertex_path_3(const Vertex_rings_3& rings, const std::vector<Eigen::Vector3d>& points,
                                               const int source, const int target, const std::vector<double>& costs,
                                               const Budget& budget)
{
  using Entry = std::pair<double, int>;
  std::vector<double> distance(points.size(), (std::numeric_limits<double>::infinity)());
  std::vector<int> previous(points.size(), -1);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
  distance[source] = 0;
  queue.emplace(0., source);
  while(!queue.empty() && queue.top().second != target && !budget.is_exhausted())
  {
    const Entry nearest = queue.top();
    queue.pop();
    if(nearest.first > distance[nearest.second])
      continue;
    for(const int w : rings[nearest.second])
    {
      const double length = (points[w] - points[nearest.second]).norm();
      const double candidate = nearest.first + ((w == target) ? length : costs[w] * length);
      if(candidate < distance[w])
      {
        distance[w] = candidate;
        previous[w] = nearest.second;
        queue.emplace(candidate, w);
      }
    }
  }

  if(previous[target] < 0)
    return {};
  std::vector<int> path(1, target);
  while(path.back() != source)
    path.push_back(previous[path.back()]);
  std::reverse(path.begin(), path.end());
  return path;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SHORTEST_VERTEX_PATH_3_H
