// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_CUBE_EDGE_ROUTER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_CUBE_EDGE_ROUTER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Shortest_paths.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/coarsen_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>

#include <CGAL/Random.h>
#include <CGAL/algorithm.h>

#include <cmath>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the shortest path along edges, or an empty one. The length of an edge is multiplied by the cost of its end, which
// is infinite for vertices that the path may not touch; the cost of the target does not matter. Cheap edges cost less.
inline std::vector<int> shortest_vertex_path_3(const Vertex_rings_3& rings, const std::vector<Vector_3>& points,
                                               const int source, const int target, const std::vector<double>& costs,
                                               const Sorted_edges& cheap, const Budget& budget)
{
  constexpr double cost_of_cheap = 0.3; // a guess; a path along cheap edges may be three times as long as another
  const auto for_each_edge = [&](const std::size_t v, const auto& reach)
  {
    for(const int w : rings[static_cast<int>(v)])
    {
      const double cost = w == target ? 1 : costs[w];
      const bool is_cheap = std::isfinite(cost)
        && std::binary_search(cheap.begin(), cheap.end(), sorted(std::array<std::size_t, 2>{ v, static_cast<std::size_t>(w) }));
      reach(w, (is_cheap ? cost_of_cheap : cost) * (points[w] - points[v]).norm());
    }
  };
  const Shortest_paths paths(points.size(), std::array<int, 1>{ source }, for_each_edge, [&](const std::size_t v)
  { return v == static_cast<std::size_t>(target) || budget.is_exhausted(); });
  const std::vector<std::size_t> path = paths.path_to(target);
  return std::vector<int>(path.begin(), path.end());
}

// Returns on which side of the cube a corner is along an axis a, which is bit a of its number.
inline int side_of_corner(const int corner, const int axis) { return (corner >> axis & 1) ? 1 : -1; }

inline std::array<int, 8> mirrored(std::array<int, 8> corners)
{
  for(std::size_t k = 0; k < 8; k += 2)
    std::swap(corners[k], corners[k + 1]);
  return corners;
}

struct Cube_edge_3
{
  int corner; // the end on the negative side along the axis
  int axis;

  int other_corner() const { return corner + (1 << axis); }
};

inline std::array<Cube_edge_3, 12> cube_edges()
{
  std::array<Cube_edge_3, 12> edges;
  std::size_t n = 0;
  for(int axis = 0; axis < 3; ++axis)
    for(int corner = 0; corner < 8; ++corner)
      if(side_of_corner(corner, axis) < 0)
        edges[n++] = { corner, axis };
  return edges;
}

// Returns the axis of the edge that follows around a corner, counterclockwise as seen from outside.
inline int next_axis_around_corner(const int corner, const int axis)
{
  const bool is_direct = side_of_corner(corner, 0) * side_of_corner(corner, 1) * side_of_corner(corner, 2) > 0;
  return (axis + (is_direct ? 1 : 2)) % 3;
}

// Vertices of a surface for the corners of a box, and paths that become its edges, from `corner` to `other_corner()` each.
struct Box_paths_3
{
  std::array<int, 8> corners;
  std::array<Cube_edge_3, 12> edges = cube_edges();
  std::array<std::vector<int>, 12> paths = {};

  // Calls f for each vertex of a path.
  template <typename Function>
  void for_each_vertex(const Function& f)
  {
    std::for_each(corners.begin(), corners.end(), f);
    for(std::vector<int>& path : paths)
      std::for_each(path.begin(), path.end(), f);
  }
};

// Finds disjoint paths along edges of a triangulated sphere that join eight of its vertices like the edges of a cube.
//
// The paths are shortest paths between the points, found one after the other. The paths respect the cyclic order of the
// edges around the corners, and a spanning tree comes first: then no path separates the ends of a later one (Praun,
// Sweldens, Schroeder, Consistent mesh parameterizations, 2001). Earlier paths may nevertheless use up the vertices that a
// later one needs. Therefore paths keep away from each other and from the corners, and if one is not found, all are found
// again in another order.
//
// Paths are shortened until no edge of the surface joins two of their vertices that do not follow each other. They prefer the
// sharp edges that they are given.
class Cube_edge_router_3
{
public:
  Cube_edge_router_3(const Vertex_rings_3& rings, const std::vector<Vector_3>& points,
                     const std::array<int, 8>& corners, const Sorted_edges& sharp_edges, const Budget& budget)
    : m_rings(rings), m_points(points), m_sharp_edges(sharp_edges), m_budget(budget), m_found{ corners }
  {}

  bool run()
  {
    sort_edges_by_distance();
    Random random(0);
    for(int attempt = 0; attempt < 100 && m_budget.may_begin_round(Phase::BOUNDARY, "edges of a box"); ++attempt)
    {
      if(route_all())
        return true;
      CGAL::cpp98::random_shuffle(m_found.edges.begin(), m_found.edges.end(), random);
    }
    return false;
  }

  const Box_paths_3& paths() const { return m_found; }

  // Returns whether two routers have found the same paths; in another order, these count as others.
  bool has_paths_of(const Cube_edge_router_3& other) const { return m_found.paths == other.m_found.paths; }

private:
  void sort_edges_by_distance()
  {
    const auto squared_distance = [&](const Cube_edge_3& edge)
    { return (m_points[m_found.corners[edge.corner]] - m_points[m_found.corners[edge.other_corner()]]).squaredNorm(); };
    std::stable_sort(m_found.edges.begin(), m_found.edges.end(), [&](const Cube_edge_3& a, const Cube_edge_3& b)
    { return squared_distance(a) < squared_distance(b); });
  }

  bool route_all()
  {
    put_spanning_tree_first();
    m_is_used.assign(m_points.size(), false);
    for(std::size_t k = 0; k < 8; ++k)
    {
      m_is_used[m_found.corners[k]] = true;
      m_exits[k].fill(-1);
    }
    for(std::size_t i = 0; i < 12; ++i)
      if(!route(i))
        return false;
    return true;
  }

  void put_spanning_tree_first()
  {
    Disjoint_sets trees(8);
    std::array<Cube_edge_3, 12> ordered;
    auto front = ordered.begin();
    auto back = ordered.rbegin();
    for(const Cube_edge_3& edge : m_found.edges)
    {
      const bool joins_trees = trees.find(edge.corner) != trees.find(edge.other_corner());
      trees.unite(edge.corner, edge.other_corner());
      (joins_trees ? *front++ : *back++) = edge;
    }
    m_found.edges = ordered;
  }

  bool route(const std::size_t i)
  {
    const int corner = m_found.edges[i].corner, other = m_found.edges[i].other_corner(), axis = m_found.edges[i].axis;
    m_found.paths[i] = find_path(m_found.corners[corner], admissible_exits(corner, axis),
                           m_found.corners[other], admissible_exits(other, axis));
    if(m_found.paths[i].empty())
      return false;
    for(const int v : m_found.paths[i])
      m_is_used[v] = true;
    m_exits[corner][axis] = m_found.paths[i][1];
    m_exits[other][axis] = m_found.paths[i][m_found.paths[i].size() - 2];
    return true;
  }

  // Returns the neighbors of a corner by which the path along an axis may leave it, such that the cyclic order is right and a
  // neighbor remains for each path that is missing.
  std::vector<int> admissible_exits(const int corner, const int axis) const
  {
    const int after = next_axis_around_corner(corner, axis);
    const int next = m_exits[corner][after], previous = m_exits[corner][next_axis_around_corner(corner, after)];
    std::vector<int> exits = m_rings[m_found.corners[corner]];
    if(next < 0 && previous < 0)
      return exits;

    const int first = (previous >= 0) ? previous : next;
    std::rotate(exits.begin(), std::find(exits.begin(), exits.end(), first), exits.end());
    exits.erase(exits.begin());
    if(next >= 0 && previous >= 0)
      exits.erase(std::find(exits.begin(), exits.end(), next), exits.end());
    else
      exits.erase((previous >= 0) ? exits.end() - 1 : exits.begin());
    return exits;
  }

  std::vector<int> find_path(const int source, const std::vector<int>& source_exits,
                             const int target, const std::vector<int>& target_exits) const
  {
    if(contains(m_rings[source], target) && !(contains(source_exits, target) && contains(target_exits, source)))
      return {};

    std::vector<double> costs = costs_of_vertices(source, target);
    forbid_other_neighbors(source, source_exits, costs);
    forbid_other_neighbors(target, target_exits, costs);
    return without_chords(shortest_vertex_path_3(m_rings, m_points, source, target, costs, m_sharp_edges, m_budget));
  }

  // Returns costs that are high beside other paths, and higher beside other corners, which need their neighbors.
  std::vector<double> costs_of_vertices(const int source, const int target) const
  {
    std::vector<double> costs(m_points.size(), 1.);
    for(std::size_t v = 0; v < costs.size(); ++v)
      if(m_is_used[v])
        for(const int w : m_rings[static_cast<int>(v)])
          costs[w] = 3;
    for(const int corner : m_found.corners)
      if(corner != source && corner != target)
        for(const int w : m_rings[corner])
          costs[w] = 10;
    for(std::size_t v = 0; v < costs.size(); ++v)
      if(m_is_used[v])
        costs[v] = (std::numeric_limits<double>::infinity)();
    return costs;
  }

  // Forbids the neighbors of the end of a path that are no exits: later on the path, their edge would be a chord.
  void forbid_other_neighbors(const int end, const std::vector<int>& exits, std::vector<double>& costs) const
  {
    for(const int v : m_rings[end])
      if(!contains(exits, v))
        costs[v] = (std::numeric_limits<double>::infinity)();
  }

  // Goes from each vertex to the last one of the path that is joined to it by an edge.
  std::vector<int> without_chords(const std::vector<int>& path) const
  {
    std::vector<int> result;
    for(auto it = path.begin(); it != path.end(); )
    {
      result.push_back(*it);
      auto next = path.end() - 1;
      while(next != it && !contains(m_rings[*it], *next))
        --next;
      it = (next == it) ? path.end() : next;
    }
    return result;
  }

  const Vertex_rings_3& m_rings;
  const std::vector<Vector_3>& m_points;
  const Sorted_edges m_sharp_edges;
  const Budget& m_budget;
  Box_paths_3 m_found;
  std::array<std::array<int, 3>, 8> m_exits; // second vertex of the paths found, by corner and axis, or -1
  std::vector<bool> m_is_used;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_CUBE_EDGE_ROUTER_3_H
