// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_SPLIT_SURFACE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_SPLIT_SURFACE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace CGAL::Polycube_meshing_3::internal {

// Triangulated surface whose edges are split at their midpoints. The splits are those of the edges one after the other, so that
// they can be made in a tetrahedral mesh, too.
struct Split_surface_3
{
  using Edge = std::pair<std::size_t, std::size_t>; // the smaller one first

  std::vector<Vector_3> points;
  std::vector<std::array<std::size_t, 3> > facets;
  std::vector<std::array<std::size_t, 2> > splits = {}; // edges whose midpoints were appended to the points, one after the other
  std::set<Edge> sharp_edges = {};

  static Edge edge(const std::array<std::size_t, 3>& facet, const std::size_t i)
  { return (std::minmax)(facet[i], facet[(i + 1) % 3]); }

  Boundary_mesh_3 mesh() const
  {
    Boundary_mesh_3 result;
    build_boundary_mesh_3(*this, result);
    return result;
  }

  double length(const Edge& e) const { return (points[e.first] - points[e.second]).norm(); }

  // Splits edges, the longest one first. Returns which facet each one comes from.
  std::vector<std::size_t> split(const std::set<Edge>& edges)
  {
    std::vector<Edge> order(edges.begin(), edges.end());
    std::stable_sort(order.begin(), order.end(), [&](const Edge& e, const Edge& f) { return length(e) > length(f); });
    std::map<Edge, std::size_t> midpoints;
    for(const Edge& e : order)
    {
      midpoints.emplace(e, points.size());
      points.push_back((points[e.first] + points[e.second]) / 2);
      splits.push_back({ e.first, e.second });
      if(sharp_edges.erase(e) > 0)
        sharp_edges.insert({ { e.first, midpoints[e] }, { e.second, midpoints[e] } });
    }
    std::vector<std::array<std::size_t, 3> > parts;
    std::vector<std::size_t> parents;
    for(std::size_t f = 0; f < facets.size(); ++f)
    {
      append_parts(facets[f], midpoints, parts);
      parents.resize(parts.size(), f);
    }
    facets = std::move(parts);
    return parents;
  }

  // Splits edges that are longer than is allowed at their midpoints, and their halves, until there are none. No facet is split
  // unless its longest edge is, which keeps its angles from becoming ever smaller.
  template <typename Length>
  void split_long_edges(const Length& maximum_length_at)
  {
    for(std::set<Edge> edges; ; edges.clear())
    {
      for(const std::array<std::size_t, 3>& facet : facets)
        for(std::size_t i = 0; i < 3; ++i)
          if(const Edge e = edge(facet, i); length(e) > maximum_length_at((points[e.first] + points[e.second]) / 2))
            edges.insert(e);
      if(edges.empty())
        return;
      add_longest_edges(edges);
      split(edges);
    }
  }

  void split_edges_longer_than(const double maximum_length)
  { split_long_edges([maximum_length](const Vector_3&) { return maximum_length; }); }

private:
  // Adds the longest edge of each facet that has an edge among some.
  void add_longest_edges(std::set<Edge>& edges) const
  {
    for(bool has_changed = true; has_changed; )
    {
      has_changed = false;
      for(const std::array<std::size_t, 3>& facet : facets)
      {
        const std::array<Edge, 3> around = { edge(facet, 0), edge(facet, 1), edge(facet, 2) };
        if(std::none_of(around.begin(), around.end(), [&](const Edge& e) { return edges.count(e) > 0; }))
          continue;
        const Edge longest = *std::max_element(around.begin(), around.end(),
                                               [&](const Edge& e, const Edge& f) { return length(e) < length(f); });
        has_changed = edges.insert(longest).second || has_changed;
      }
    }
  }

  // Splits a facet at the first of the midpoints of its edges, which have the order of the splits, and then its parts.
  static void append_parts(const std::array<std::size_t, 3>& facet, const std::map<Edge, std::size_t>& midpoints,
                           std::vector<std::array<std::size_t, 3> >& parts)
  {
    std::size_t first = 3, midpoint = 0;
    for(std::size_t i = 0; i < 3; ++i)
      if(const auto it = midpoints.find(edge(facet, i)); it != midpoints.end() && (first == 3 || it->second < midpoint))
      {
        first = i;
        midpoint = it->second;
      }
    if(first == 3)
    {
      parts.push_back(facet);
      return;
    }
    append_parts({ facet[first], midpoint, facet[(first + 2) % 3] }, midpoints, parts);
    append_parts({ midpoint, facet[(first + 1) % 3], facet[(first + 2) % 3] }, midpoints, parts);
  }
};

// Measures of the facets of a surface.
struct Facets_3
{
  std::vector<Vector_3> centers, normals; // unit normals, or 0
  std::vector<double> areas;

  explicit Facets_3(const Split_surface_3& surface)
  {
    for(const auto& [a, b, c] : surface.facets)
    {
      const Vector_3 &p = surface.points[a], &q = surface.points[b], &r = surface.points[c];
      const Vector_3 n = (q - p).cross(r - p) / 2;
      areas.push_back(n.norm());
      normals.push_back(n.normalized());
      centers.push_back((p + q + r) / 3);
    }
  }
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_SPLIT_SURFACE_3_H
