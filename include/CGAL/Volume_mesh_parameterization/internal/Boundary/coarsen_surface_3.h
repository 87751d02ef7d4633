// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_COARSEN_SURFACE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_COARSEN_SURFACE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <iterator>

namespace CGAL::Volume_mesh_parameterization::internal {

inline bool contains(const std::vector<int>& vertices, const int v)
{ return std::find(vertices.begin(), vertices.end(), v) != vertices.end(); }

// Vertex that was collapsed onto the first vertex of its ring.
struct Removed_vertex
{
  int vertex;
  std::vector<int> ring;
};

// Closed triangulated surface as the neighbors of each vertex, counterclockwise as seen from outside.
class Vertex_rings_3
{
public:
  explicit Vertex_rings_3(const Boundary_mesh_3& mesh) : m_rings(mesh.number_of_vertices())
  {
    for(const auto v : mesh.vertices())
    {
      const auto clockwise = CGAL::vertices_around_target(v, mesh);
      m_rings[v].assign(clockwise.begin(), clockwise.end());
      std::reverse(m_rings[v].begin(), m_rings[v].end());
    }
  }

  int number_of_vertices() const { return static_cast<int>(m_rings.size()); }

  // Returns the neighbors of a vertex; none if it is removed.
  const std::vector<int>& operator[](const int v) const { return m_rings[v]; }

  // Returns by the link condition whether the surface remains a manifold if v is collapsed onto its neighbor u.
  bool is_collapsible(const int v, const int u) const
  {
    return std::count_if(m_rings[v].begin(), m_rings[v].end(), [&](const int w) { return contains(m_rings[u], w); }) == 2;
  }

  Removed_vertex collapse(const int v, const int u)
  {
    CGAL_assertion(is_collapsible(v, u));
    std::vector<int> ring;
    ring.swap(m_rings[v]);
    std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), u), ring.end());

    const auto in_u = begin_at(u, v);
    m_rings[u].insert(m_rings[u].erase(in_u), ring.begin() + 2, ring.end() - 1);
    m_rings[ring[1]].erase(begin_at(ring[1], v));
    m_rings[ring.back()].erase(begin_at(ring.back(), v));
    for(std::size_t i = 2; i + 1 < ring.size(); ++i)
      *begin_at(ring[i], v) = u;
    return { v, ring };
  }

  // Undoes a collapse. Collapses are undone in reverse order, as the rings are those right after each.
  void insert(const Removed_vertex& removed)
  {
    const int v = removed.vertex;
    const std::vector<int>& ring = removed.ring;
    const int u = ring.front();

    std::vector<int>& ring_of_u = m_rings[u];
    std::rotate(ring_of_u.begin(), begin_at(u, ring[1]), ring_of_u.end());
    ring_of_u.erase(ring_of_u.begin() + 1, begin_at(u, ring.back()));
    ring_of_u.insert(ring_of_u.begin() + 1, v);
    m_rings[ring[1]].insert(begin_at(ring[1], u), v);
    m_rings[ring.back()].insert(std::next(begin_at(ring.back(), u)), v);
    for(std::size_t i = 2; i + 1 < ring.size(); ++i)
      *begin_at(ring[i], u) = v;
    m_rings[v] = ring;
  }

private:
  std::vector<int>::iterator begin_at(const int v, const int neighbor)
  { return std::find(m_rings[v].begin(), m_rings[v].end(), neighbor); }

  std::vector<std::vector<int> > m_rings;
};

// Collapse of a vertex. Its cost is the largest squared length of an edge of the triangles that fill the hole.
struct Collapse
{
  int from, to;
  double cost;
};

// Returns the cheapest collapse of a vertex onto a neighbor that keeps the surface a manifold, or -1 as its end.
inline Collapse best_collapse(const Vertex_rings_3& rings, const std::vector<Vector_3>& points, const int v)
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
                                                        const std::vector<Vector_3>& points, const Budget& budget)
{
  std::vector<Collapse> collapses;
  for(int v = 0; v < rings.number_of_vertices(); ++v)
    if(!rings[v].empty() && !budget.is_exhausted())
      if(const Collapse collapse = best_collapse(rings, points, v); collapse.to >= 0)
        collapses.push_back(collapse);
  std::stable_sort(collapses.begin(), collapses.end(), [](const Collapse& a, const Collapse& b) { return a.cost < b.cost; });
  collapses.resize((collapses.size() + 1) / 2);
  return collapses;
}

// Removes vertices from a triangulated sphere until a tetrahedron remains, and returns them level by level. Collapses of one
// level do not touch each other. While there are more than four vertices, one can be collapsed. Ends early if the budget does.
inline std::vector<std::vector<Removed_vertex> > coarsen_surface_3(Vertex_rings_3& rings,
                                                                   const std::vector<Vector_3>& points,
                                                                   const Budget& budget)
{
  std::vector<std::vector<Removed_vertex> > levels;
  for(int remaining = rings.number_of_vertices(); remaining > 4 && budget.may_begin_round(Phase::BOUNDARY, "coarsening"); )
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
