// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_COARSEN_SURFACE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_COARSEN_SURFACE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Vertex_rings_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// A way to remove a vertex; the cost is the largest squared length of an edge of the triangles that fill the hole.
struct Collapse
{
  int from;
  int to;
  double cost;
};

inline Collapse best_collapse(const Vertex_rings_3& rings, const std::vector<Eigen::Vector3d>& points, const int v)
{
  Collapse best = { v, -1, (std::numeric_limits<double>::infinity)() };
  for(const int u : rings[v])
  {
    double cost = 0;
    for(const int w : rings[v])
      cost = (std::max)(cost, (points[w] - points[u]).squaredNorm());
    if(cost < best.cost && rings.is_collapsible(v, u))
      best = { v, u, cost };
  }
  return best;
}

inline std::vector<Collapse> cheapest_half_of_collapses(const Vertex_rings_3& rings,
                                                        const std::vector<Eigen::Vector3d>& points,
                                                        const Budget& budget)
{
  std::vector<Collapse> collapses;
  for(int v = 0; v < rings.number_of_vertices() && !budget.is_exhausted(); ++v)
    if(!rings[v].empty())
    {
      const Collapse collapse = best_collapse(rings, points, v);
      if(collapse.to >= 0)
        collapses.push_back(collapse);
    }
  std::stable_sort(collapses.begin(), collapses.end(), [](const Collapse& a, const Collapse& b)
  {
    return a.cost < b.cost;
  });
  collapses.resize((collapses.size() + 1) / 2);
  return collapses;
}

// The vertices removed from a triangulated sphere until a tetrahedron remains, level by level.
// Collapses of one level do not touch each other. As long as there are more than four vertices one can be collapsed.
// Ends early if the budget does.
inline std::vector<std::vector<Removed_vertex> > coarsen_surface_3(Vertex_rings_3& rings,
                                                                   const std::vector<Eigen::Vector3d>& points,
                                                                   const Budget& budget)
{
  std::vector<std::vector<Removed_vertex> > levels;
  for(int remaining = rings.number_of_vertices(); remaining > 4 && !budget.is_exhausted(); )
  {
    levels.emplace_back();
    std::vector<bool> is_touched(rings.number_of_vertices(), false);
    for(const Collapse& collapse : cheapest_half_of_collapses(rings, points, budget))
    {
      const std::vector<int>& ring = rings[collapse.from];
      if(is_touched[collapse.from]
         || std::any_of(ring.begin(), ring.end(), [&](const int w) { return is_touched[w]; }))
        continue;
      levels.back().push_back(rings.collapse(collapse.from, collapse.to));
      for(const int w : levels.back().back().ring)
        is_touched[w] = true;
      if(--remaining == 4)
        break;
    }
  }
  return levels;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_COARSEN_SURFACE_3_H
