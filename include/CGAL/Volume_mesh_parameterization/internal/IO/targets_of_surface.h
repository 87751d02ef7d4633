// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_TARGETS_OF_SURFACE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_TARGETS_OF_SURFACE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Triangulated_surface.h>

#include <numeric>

namespace CGAL::Volume_mesh_parameterization::internal {

// Targets of vertices, and a note on the way in which the file is understood, if there are several.
struct Read_targets
{
  Points points;
  std::string note = {};
};

// The way with the least displacement in which a part of a surface matches a boundary, and the displacement of the next one.
struct Best_matching
{
  std::optional<Matching> matching = {};
  double next_displacement = std::numeric_limits<double>::infinity();
};

// The boundary of a mesh with both orientations, and the triangles that parts of a surface have taken.
struct Boundary_to_match
{
  const Points& points;
  std::array<Triangulated_surface, 2> surfaces;
  std::set<std::array<std::size_t, 3> > taken = {};

  bool is_free(const Matching& matching) const
  {
    return std::none_of(matching.triangles.begin(), matching.triangles.end(), [&](const auto& triangle)
                        { return taken.count(triangle) != 0; });
  }
};

// Chooses an edge of a part whose numbers of triangles are rare, if possible one with triangles all around both ends.
inline Triangulated_surface::Edge rare_edge(const Triangulated_surface& part)
{
  using Edge = Triangulated_surface::Edge;
  std::map<std::pair<bool, Edge>, std::vector<Edge> > edges; // by whether an end is on a border, and the numbers of triangles
  for(const auto& [edge, third] : part.third_vertices())
    edges[{ !part.is_inner(edge[0]) || !part.is_inner(edge[1]), { part.degree(edge[0]), part.degree(edge[1]) } }].push_back(edge);
  return std::min_element(edges.begin(), edges.end(), [](const auto& a, const auto& b)
    { return std::make_pair(a.first.first, a.second.size()) < std::make_pair(b.first.first, b.second.size()); })->second.front();
}

// Finds the best way by walks that begin at edges of the boundary, near ones first: few walks after those go far.
inline Best_matching best_matching(const Triangulated_surface& part, const Points& points, const Boundary_to_match& boundary,
                                   const Budget& budget)
{
  using Edge = Triangulated_surface::Edge;
  const Edge first = rare_edge(part);
  std::vector<std::pair<double, std::pair<std::size_t, Edge> > > starts; // displacements, orientations and edges
  for(std::size_t o = 0; o < 2; ++o)
    for(const auto& [edge, third] : boundary.surfaces[o].third_vertices())
    {
      double displacement = 0;
      bool can_match = true;
      for(std::size_t i = 0; i < 2; ++i)
      {
        const std::size_t degree = boundary.surfaces[o].degree(edge[i]), degree_in_part = part.degree(first[i]);
        can_match = can_match && (part.is_inner(first[i]) ? degree == degree_in_part : degree > degree_in_part);
        displacement += squared_distance(points[first[i]], boundary.points[edge[i]]);
      }
      if(can_match)
        starts.push_back({ displacement, { o, edge } });
    }
  std::sort(starts.begin(), starts.end());

  Best_matching best;
  for(const auto& [displacement, start] : starts)
  {
    go_on(budget);
    auto matching = matching_from(part, boundary.surfaces[start.first], first, start.second, points, boundary.points,
                                  best.next_displacement);
    if(!matching || !boundary.is_free(*matching))
      continue;
    if(best.matching && best.matching->displacement <= matching->displacement)
    {
      best.next_displacement = matching->displacement; // which is the bound of the walk
      continue;
    }
    if(best.matching)
      best.next_displacement = best.matching->displacement;
    best.matching = std::move(matching);
  }
  return best;
}

// Finds the vertices of the boundary by triangles alone, for one part of the surface after the other: first the one with the least
// displacement.
inline Read_targets targets_by_triangles(const Points& points, const Triangles& triangles, Boundary_to_match& boundary,
                                         const Budget& budget)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Read_targets result = { Points(boundary.points.size(), { nan, nan, nan }) };
  std::vector<Triangulated_surface> parts;
  for(const Triangles& part : components(triangles))
    parts.emplace_back(part);
  std::vector<Best_matching> matchings(parts.size());
  std::vector<char> is_placed(parts.size(), false);
  double displacement = 0, least_increase = std::numeric_limits<double>::infinity();
  std::size_t number_of_vertices = 0;
  for(std::size_t k = 0; k < parts.size(); ++k)
  {
    const Best_matching* best = nullptr;
    for(std::size_t i = 0; i < parts.size(); ++i)
    {
      if(is_placed[i])
        continue;
      if(!matchings[i].matching || !boundary.is_free(*matchings[i].matching))
        matchings[i] = best_matching(parts[i], points, boundary, budget);
      if(!matchings[i].matching)
        throw Input_error("the surface has "
                          + counted(parts[i].number_of_triangles(), "triangle that matches", "triangles that match")
                          + " no part of the boundary of the source with "
                          + counted(boundary.surfaces[0].number_of_triangles(), "triangle", "triangles")
                          + ". Move the triangles of the source onto the surface, for instance to its nearest points; or fit the "
                            "body to the surface, as the example body_to_scan.cpp does");
      if(best == nullptr || matchings[i].matching->displacement < best->matching->displacement)
        best = &matchings[i];
    }
    is_placed[static_cast<std::size_t>(best - matchings.data())] = true;
    displacement += best->matching->displacement;
    number_of_vertices += best->matching->vertices.size();
    least_increase = (std::min)(least_increase, best->next_displacement - best->matching->displacement);
    boundary.taken.insert(best->matching->triangles.begin(), best->matching->triangles.end());
    for(const auto& [v, w] : best->matching->vertices)
    {
      if(!std::isnan(result.points[w][0]) && result.points[w] != points[v])
        throw Input_error("two parts of the surface have different points for the vertex " + std::to_string(w)
                          + " (counted from 0) of the source");
      result.points[w] = points[v];
    }
  }
  constexpr double relative_difference = 1e-9; // of ways that differ by rounding alone
  const auto mean = [&](const double sum)
  { return sentence(std::sqrt(sum / static_cast<double>(number_of_vertices))); };
  if(least_increase <= relative_difference * displacement)
    throw Input_error("the triangles of the surface match the boundary of the source in several ways with the least "
                      "displacement. Write the surface with the vertices in the order of the source");
  if(std::isfinite(least_increase))
    result.note = "the triangles match the boundary of the source in several ways. The match with the least displacement is "
                  "used: "
      + mean(displacement) + " in the quadratic mean, and " + mean(displacement + least_increase) + " for the next one";
  return result;
}

// Returns the points of the vertices of a surface for the vertices of a mesh that they are, and none for the others.
inline Read_targets targets_of_vertices(const std::vector<std::size_t>& vertices, const std::vector<std::size_t>& vertex_of_mesh,
                                        const Points& points, const std::size_t number_of_vertices)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Read_targets result = { Points(number_of_vertices, { nan, nan, nan }) };
  for(const std::size_t v : vertices)
    result.points[vertex_of_mesh[v]] = points[v];
  return result;
}

// Finds the point of a surface for each vertex on the boundary of a mesh, or on a part of it, and none for the others. The
// vertices of the surface are those of the mesh, or those of the boundary in the order of the mesh; or triangles identify them.
inline Read_targets targets_of_surface(const Points& points, const Triangles& triangles, const Tetrahedron_soup_3& mesh,
                                       const Budget& budget)
{
  const Triangles facets = boundary_facets_3(mesh.cells);
  std::set<std::array<std::size_t, 3> > set_of_facets;
  for(const auto& facet : facets)
    set_of_facets.insert(sorted(facet));
  Boundary_to_match boundary = { mesh.points, { Triangulated_surface(facets), Triangulated_surface(reversed(facets)) } };
  const Triangulated_surface surface(triangles);
  const std::vector<std::size_t> vertices = surface.vertices(), boundary_vertices = boundary.surfaces[0].vertices();
  const bool is_whole = triangles.size() == facets.size() && vertices.size() == boundary_vertices.size();

  std::vector<std::size_t> same(points.size()), in_order(points.size(), no_vertex);
  std::iota(same.begin(), same.end(), std::size_t(0));
  for(std::size_t i = 0; i < vertices.size() && is_whole; ++i)
    in_order[vertices[i]] = boundary_vertices[i];
  const auto are_facets = [&](const std::vector<std::size_t>& vertex)
  {
    return std::all_of(triangles.begin(), triangles.end(), [&](const auto& t)
    { return set_of_facets.count(sorted(std::array{ vertex[t[0]], vertex[t[1]], vertex[t[2]] })) != 0; });
  };
  if((is_whole || points.size() == mesh.points.size()) && are_facets(same))
    return targets_of_vertices(vertices, same, points, mesh.points.size());
  if(is_whole && are_facets(in_order))
    return targets_of_vertices(vertices, in_order, points, mesh.points.size());
  if(triangles.empty() || !surface.is_oriented() || !boundary.surfaces[0].is_oriented())
    throw Input_error("the triangles of the surface are not an oriented manifold, and do not identify the vertices of the "
                      "source. Write the surface with the vertices in the order of the source");
  return targets_by_triangles(points, triangles, boundary, budget);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_TARGETS_OF_SURFACE_H
