// Matches a surface with the boundary of a mesh, by their triangles alone.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MATCH_SURFACE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MATCH_SURFACE_H

#include "mend_source.h"

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using Triangles = std::vector<std::array<std::size_t, 3> >;

// Triangles with one orientation, and the third vertex of the one at each directed edge.
class Triangulated_surface
{
public:
  using Edge = std::array<std::size_t, 2>;

  explicit Triangulated_surface(const Triangles& triangles, const std::size_t number_of_vertices)
    : m_triangles(triangles), m_degrees(number_of_vertices)
  {
    for(const auto& [u, v, w] : triangles)
    {
      m_third_vertices[{ u, v }] = w;
      m_third_vertices[{ v, w }] = u;
      m_third_vertices[{ w, u }] = v;
      for(const std::size_t x : { u, v, w })
        ++m_degrees[x];
    }
  }

  // Tells whether each edge has a triangle on either side, as on a closed surface that does not touch itself in an edge.
  bool is_closed() const
  {
    return m_third_vertices.size() == 3 * m_triangles.size()
        && std::all_of(m_third_vertices.begin(), m_third_vertices.end(), [&](const auto& entry)
           { return m_third_vertices.count({ entry.first[1], entry.first[0] }) > 0; });
  }

  const std::map<Edge, std::size_t>& third_vertices() const { return m_third_vertices; }
  std::size_t number_of_triangles() const { return m_triangles.size(); }
  Edge degrees(const Edge& edge) const { return { m_degrees[edge[0]], m_degrees[edge[1]] }; }

  std::vector<std::size_t> vertices() const
  {
    std::vector<std::size_t> result;
    for(std::size_t v = 0; v < m_degrees.size(); ++v)
      if(m_degrees[v] > 0)
        result.push_back(v);
    return result;
  }

private:
  const Triangles& m_triangles;
  std::map<Edge, std::size_t> m_third_vertices;
  std::vector<std::size_t> m_degrees;
};

constexpr std::size_t no_vertex = (std::numeric_limits<std::size_t>::max)();

// Vertex of another surface for each vertex.
using Matching = std::vector<std::size_t>;

inline bool is_matching(const Triangulated_surface& a, const Triangulated_surface& b, const Matching& matching)
{
  return a.number_of_triangles() == b.number_of_triangles()
      && std::all_of(a.third_vertices().begin(), a.third_vertices().end(), [&](const auto& entry)
  {
    const auto found = b.third_vertices().find({ matching[entry.first[0]], matching[entry.first[1]] });
    return found != b.third_vertices().end() && found->second == matching[entry.second];
  });
}

// Continues from an edge of each surface over all triangles. Returns nothing where they differ.
inline std::optional<Matching> matching_from(const Triangulated_surface& a, const Triangulated_surface& b,
                                             const Triangulated_surface::Edge& first, const Triangulated_surface::Edge& image,
                                             const std::size_t number_of_vertices)
{
  Matching matching(number_of_vertices, no_vertex);
  matching[first[0]] = image[0];
  matching[first[1]] = image[1];
  std::vector<Triangulated_surface::Edge> edges = { first };
  std::size_t number_of_triangles = 0;
  std::map<Triangulated_surface::Edge, bool> is_done;
  while(!edges.empty())
  {
    const auto [u, v] = edges.back();
    edges.pop_back();
    if(is_done[{ u, v }])
      continue;
    const std::size_t w = a.third_vertices().at({ u, v });
    const auto found = b.third_vertices().find({ matching[u], matching[v] });
    if(found == b.third_vertices().end() || (matching[w] != no_vertex && matching[w] != found->second))
      return std::nullopt;
    matching[w] = found->second;
    ++number_of_triangles;
    for(const Triangulated_surface::Edge& edge : { Triangulated_surface::Edge{ u, v }, { v, w }, { w, u } })
    {
      is_done[edge] = true;
      edges.push_back({ edge[1], edge[0] });
    }
  }
  if(number_of_triangles < a.number_of_triangles() || !is_matching(a, b, matching))
    return std::nullopt;
  return matching;
}

// Finds the ways, at most two, in which triangles match. They begin at an edge whose numbers of triangles are rare.
inline std::vector<Matching> matchings(const Triangulated_surface& a, const Triangulated_surface& b,
                                       const std::size_t number_of_vertices)
{
  std::map<Triangulated_surface::Edge, std::vector<Triangulated_surface::Edge> > edges_of_degrees;
  for(const auto& [edge, third] : a.third_vertices())
    edges_of_degrees[a.degrees(edge)].push_back(edge);
  const auto& rarest = *std::min_element(edges_of_degrees.begin(), edges_of_degrees.end(), [](const auto& x, const auto& y)
                                         { return x.second.size() < y.second.size(); });
  std::vector<Matching> result;
  for(const auto& [edge, third] : b.third_vertices())
    if(result.size() < 2 && b.degrees(edge) == rarest.first)
      if(auto matching = matching_from(a, b, rarest.second.front(), edge, number_of_vertices))
        result.push_back(std::move(*matching));
  return result;
}

inline Triangles reversed(Triangles triangles)
{
  for(auto& triangle : triangles)
    std::swap(triangle[1], triangle[2]);
  return triangles;
}

// Finds the point of a surface for each vertex on the boundary of a mesh, and none for the others. The vertices of the surface
// are those of the mesh, or those of the boundary in the order of the mesh; or, where the triangles fit together in one way
// only, in any order.
inline Points targets_of_surface(const Points& points, const Triangles& triangles,
                                 const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& mesh)
{
  using CGAL::Volume_mesh_parameterization::Input_error;
  const Triangles facets = CGAL::Volume_mesh_parameterization::internal::boundary_facets_3(mesh.cells);
  if(facets.size() != triangles.size())
    throw Input_error("the surface has " + std::to_string(triangles.size()) + " triangles and the boundary of the source has "
                      + std::to_string(facets.size()));
  const Triangulated_surface boundary(facets, mesh.points.size());
  const Triangles turned = reversed(triangles);
  const Triangulated_surface surfaces[] = { Triangulated_surface(triangles, points.size()),
                                            Triangulated_surface(turned, points.size()) };
  const std::vector<std::size_t> boundary_vertices = boundary.vertices(), vertices = surfaces[0].vertices();

  const auto targets = [&](const Matching& matching)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Points result(mesh.points.size(), { nan, nan, nan });
    for(const std::size_t v : boundary_vertices)
      result[v] = points[matching[v]];
    return result;
  };
  Matching same(mesh.points.size()), in_order(mesh.points.size(), no_vertex);
  std::iota(same.begin(), same.end(), std::size_t(0));
  if(boundary_vertices.size() == vertices.size())
    for(std::size_t i = 0; i < vertices.size(); ++i)
      in_order[boundary_vertices[i]] = vertices[i];
  for(const Triangulated_surface& surface : surfaces)
    for(const Matching& matching : { same, in_order })
      if(is_matching(boundary, surface, matching))
        return targets(matching);
  if(boundary_vertices.size() == vertices.size() && boundary.is_closed() && surfaces[0].is_closed())
    for(const Triangulated_surface& surface : surfaces)
    {
      const std::vector<Matching> all = matchings(boundary, surface, mesh.points.size());
      if(all.size() == 1)
        return targets(all.front());
      if(all.size() > 1)
        throw Input_error("the triangles of the surface are those of the boundary of the source in several ways; write it with "
                          "the vertices in the order of the source");
    }
  throw Input_error("the triangles of the surface join other vertices than those of the boundary of the source");
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MATCH_SURFACE_H
