// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_TRIANGULATED_SURFACE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_TRIANGULATED_SURFACE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <map>
#include <optional>
#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

using Points = std::vector<std::array<double, 3> >;
using Triangles = std::vector<std::array<std::size_t, 3> >;

constexpr std::size_t no_vertex = (std::numeric_limits<std::size_t>::max)();

inline Triangles reversed(Triangles triangles)
{
  for(auto& triangle : triangles)
    std::swap(triangle[1], triangle[2]);
  return triangles;
}

// Triangles with one orientation, and the third vertex of the one at each directed edge.
class Triangulated_surface
{
public:
  using Edge = std::array<std::size_t, 2>;

  explicit Triangulated_surface(const Triangles& triangles) : m_number_of_triangles(triangles.size())
  {
    for(const auto& [u, v, w] : triangles)
    {
      m_third_vertices[{ u, v }] = w;
      m_third_vertices[{ v, w }] = u;
      m_third_vertices[{ w, u }] = v;
      for(const std::size_t x : { u, v, w })
        ++m_degrees[x];
    }
    for(const auto& [edge, third] : m_third_vertices)
      if(third_vertex({ edge[1], edge[0] }) == no_vertex)
        m_border.insert(edge.begin(), edge.end());
  }

  // Returns whether no two triangles have a directed edge in common.
  bool is_oriented() const { return m_third_vertices.size() == 3 * m_number_of_triangles; }

  std::size_t third_vertex(const Edge& edge) const
  {
    const auto found = m_third_vertices.find(edge);
    return found == m_third_vertices.end() ? no_vertex : found->second;
  }

  const std::map<Edge, std::size_t>& third_vertices() const { return m_third_vertices; }
  std::size_t number_of_triangles() const { return m_number_of_triangles; }
  std::size_t degree(const std::size_t v) const { return m_degrees.at(v); }
  bool is_inner(const std::size_t v) const { return m_border.count(v) == 0; } // and not on a border

  std::vector<std::size_t> vertices() const
  {
    std::vector<std::size_t> result;
    for(const auto& [v, degree] : m_degrees)
      result.push_back(v);
    return result;
  }

private:
  std::size_t m_number_of_triangles;
  std::map<Edge, std::size_t> m_third_vertices;
  std::map<std::size_t, std::size_t> m_degrees; // the number of triangles at each vertex
  std::set<std::size_t> m_border;               // vertices
};

// Returns the parts of a surface that edges join.
inline std::vector<Triangles> components(const Triangles& triangles)
{
  Disjoint_sets sets(triangles.size());
  for_each_edge(triangles, [&](const auto begin, const auto end)
  {
    for(auto it = begin; it != end; ++it)
      sets.unite(begin->second[0] / 3, it->second[0] / 3);
  });
  std::map<std::size_t, Triangles> result;
  for(std::size_t t = 0; t < triangles.size(); ++t)
    result[sets.find(t)].push_back(triangles[t]);
  std::vector<Triangles> parts;
  for(auto& [set, part] : result)
    parts.push_back(std::move(part));
  return parts;
}

// Vertices and triangles of a boundary that those of a part of a surface are, and how far the vertices are from these.
struct Matching
{
  std::map<std::size_t, std::size_t> vertices;
  Triangles triangles; // with sorted vertices
  double displacement = 0; // the sum of the squared distances
};

inline double squared_distance(const std::array<double, 3>& p, const std::array<double, 3>& q)
{ return (to_vector(p) - to_vector(q)).squaredNorm(); }

// Continues from an edge of a part and one of a boundary over all triangles of the part. Returns nothing if the triangles
// differ, or if the displacement would be larger than a bound.
inline std::optional<Matching> matching_from(const Triangulated_surface& part, const Triangulated_surface& boundary,
                                             const Triangulated_surface::Edge& first, const Triangulated_surface::Edge& image,
                                             const Points& points, const Points& points_of_boundary, const double bound)
{
  Matching result;
  std::set<std::size_t> images;
  const auto match = [&](const std::size_t v, const std::size_t w)
  {
    const auto [entry, is_new] = result.vertices.emplace(v, w);
    if(is_new)
      result.displacement += squared_distance(points[v], points_of_boundary[w]);
    return is_new ? images.insert(w).second : entry->second == w;
  };
  if(!match(first[0], image[0]) || !match(first[1], image[1]))
    return std::nullopt;
  std::vector<Triangulated_surface::Edge> edges = { first };
  std::set<Triangulated_surface::Edge> done;
  while(!edges.empty())
  {
    const auto [u, v] = edges.back();
    edges.pop_back();
    const std::size_t w = part.third_vertex({ u, v });
    if(w == no_vertex || done.count({ u, v }) != 0)
      continue;
    const std::size_t third = boundary.third_vertex({ result.vertices[u], result.vertices[v] });
    if(third == no_vertex || !match(w, third) || result.displacement > bound)
      return std::nullopt;
    result.triangles.push_back(sorted(
      std::array{ result.vertices[u], result.vertices[v], third }));
    for(const Triangulated_surface::Edge& edge : { Triangulated_surface::Edge{ u, v }, { v, w }, { w, u } })
    {
      done.insert(edge);
      edges.push_back({ edge[1], edge[0] });
    }
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_TRIANGULATED_SURFACE_H
