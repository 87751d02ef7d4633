// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SHARP_EDGES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SHARP_EDGES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <cmath>
#include <map>
#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the cosine of the angle between the normals of two facets.
template <typename Facet, typename Position>
double cosine_between_facets(const Facet& f, const Facet& g, const Position& position)
{
  const auto normal = [&](const Facet& facet)
  {
    const auto [a, b] = edges_of_facet(facet, position);
    return a.cross(b).stableNormalized();
  };
  return normal(f).dot(normal(g));
}

// Returns whether the edge between two facets is sharp.
template <typename Facet, typename Position>
bool is_sharp_edge(const Facet& f, const Facet& g, const Position& position, const bool are_oriented_alike = true)
{
  constexpr double cosine_of_sharp_edge = 0.5; // a guess; 60 degrees between normals
  return (are_oriented_alike ? 1 : -1) * cosine_between_facets(f, g, position) < cosine_of_sharp_edge;
}

// Returns the cosine of the turn up to which an edge of a curve of sharp edges goes on in the next one.
inline double cosine_of_smooth_turn() { return std::sqrt(0.5); } // a guess; 45 degrees

// Returns whether the edge between two points leads along an axis, bit by bit, as edges of a polycube and lines in its faces do.
inline bool leads_along_axis(const Vector_3& p, const Vector_3& q)
{ return (p[0] != q[0]) + (p[1] != q[1]) + (p[2] != q[2]) == 1; }

// Returns the sharp edges of a surface, the smaller vertex first: those among the marked ones, or if there are none, those
// whose normals on both sides make more than 60 degrees.
template <typename Vertex, typename Position>
std::vector<std::array<Vertex, 2> > sharp_edges_3(const std::vector<std::array<Vertex, 3> >& facets,
                                                  std::vector<std::array<Vertex, 2> > marked, const Position& position)
{
  for(std::array<Vertex, 2>& edge : marked)
    edge = sorted(edge);
  std::sort(marked.begin(), marked.end());
  std::vector<std::array<Vertex, 2> > found, by_angle;
  for_each_edge(facets, [&](const auto begin, const auto end)
  {
    if(std::binary_search(marked.begin(), marked.end(), begin->first))
      found.push_back(begin->first);
    const auto is_forward = [](const auto& corners) { return corners[1] % 3 == (corners[0] + 1) % 3; };
    const bool are_oriented_alike = end - begin != 2 || is_forward(begin->second) != is_forward((end - 1)->second);
    if(is_sharp_edge(facets[begin->second[0] / 3], facets[(end - 1)->second[0] / 3], position, are_oriented_alike))
      by_angle.push_back(begin->first);
  });
  return found.empty() ? by_angle : found;
}

// Feature edges as curves, and the number of curves at each of their vertices, with two at a corner where a curve turns.
class Feature_curves_3
{
public:
  using Edge = std::array<std::size_t, 2>;

  Feature_curves_3(std::vector<Edge> edges, const std::vector<std::array<double, 3> >& points) : m_edges(std::move(edges))
  {
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      for(const std::size_t v : m_edges[e])
        m_edges_of_vertices[v].push_back(e);
    Disjoint_sets sets(m_edges.size());
    const auto direction_from = [&](const std::size_t v, const std::size_t e) -> Vector_3
    {
      const Vector_3 p = to_vector(points[m_edges[e][0]]), q = to_vector(points[m_edges[e][1]]);
      return ((m_edges[e][0] == v ? 1 : -1) * (q - p)).stableNormalized();
    };
    for(const auto& [v, at] : m_edges_of_vertices)
      if(at.size() == 2 && -direction_from(v, at[0]).dot(direction_from(v, at[1])) >= cosine_of_smooth_turn())
        sets.unite(at[0], at[1]);
      else
        m_corners.insert(v);
    m_curves = sets.numbers();
  }

  const std::vector<Edge>& edges() const { return m_edges; }
  const std::vector<std::size_t>& curves() const { return m_curves; } // of each edge
  const std::map<std::size_t, std::vector<std::size_t> >& edges_of_vertices() const { return m_edges_of_vertices; }
  bool is_corner(const std::size_t v) const { return m_corners.count(v) > 0; }

private:
  std::vector<Edge> m_edges;
  std::vector<std::size_t> m_curves;
  std::map<std::size_t, std::vector<std::size_t> > m_edges_of_vertices;
  std::set<std::size_t> m_corners;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SHARP_EDGES_3_H
