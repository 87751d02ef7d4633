// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_NUMBERED_SURFACE_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_NUMBERED_SURFACE_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

namespace CGAL::Volume_mesh_parameterization::internal {

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE Numbered_surface_3 surface_of(const Body_3& body)
{
  const Numbered_points numbered(body.boundary, body.points.size());
  Numbered_surface_3 surface;
  surface.vertices = numbered.points;
  surface.cells = &body.cells;
  for(const std::size_t v : surface.vertices)
    surface.points.push_back(to_vector(body.points[v]));
  surface.facets = body.boundary;
  for(std::array<std::size_t, 3>& facet : surface.facets)
    for(std::size_t& v : facet)
      v = static_cast<std::size_t>(numbered.numbers[v]);
  std::vector<std::array<std::size_t, 2> > marked;
  for(const auto& [v, w] : body.edges)
    if(numbered.numbers[v] >= 0 && numbered.numbers[w] >= 0)
      marked.push_back({ static_cast<std::size_t>(numbered.numbers[v]), static_cast<std::size_t>(numbered.numbers[w]) });
  surface.sharp_edges = sharp_edges_3(surface.facets, std::move(marked), [&](const std::size_t v) { return surface.points[v]; });
  return surface;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::vector<std::size_t> non_manifold_points(const Body_3& body)
{
  const Numbered_surface_3 surface = surface_of(body);
  std::vector<std::size_t> result;
  for(const std::size_t v : non_manifold_vertices(surface.vertices.size(), surface.facets))
    result.push_back(surface.vertices[v]);
  return result;
}

// Returns the box around the smallest part of the boundary.
inline Box_3 box_of_smallest_part(const Body_3& body)
{
  Disjoint_sets sets(body.points.size());
  std::map<std::size_t, Box_3> boxes;
  for(const auto& [u, v, w] : body.boundary)
  {
    sets.unite(u, v);
    sets.unite(v, w);
  }
  for(const auto& facet : body.boundary)
    for(const std::size_t v : facet)
      boxes[sets.find(v)].extend(to_vector(body.points[v]));
  return std::min_element(boxes.begin(), boxes.end(), [](const auto& a, const auto& b)
                          { return a.second.diagonal().norm() < b.second.diagonal().norm(); })->second;
}

// Returns the midpoint of the edge of the boundary where two facets turn most: the vertices are fewest there for the shape.
inline Vector_3 middle_of_sharpest_edge(const Body_3& body)
{
  const auto position = [&](const std::size_t v) { return to_vector(body.points[v]); };
  double least_cosine = 2;
  Vector_3 result = position(body.boundary[0][0]);
  for_each_edge(body.boundary, [&](const auto begin, const auto end)
  {
    const double cosine = cosine_between_facets(body.boundary[begin->second[0] / 3], body.boundary[(end - 1)->second[0] / 3],
                                                position);
    if(!(cosine < least_cosine))
      return;
    least_cosine = cosine;
    result = (position(begin->first[0]) + position(begin->first[1])) / 2;
  });
  return result;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::string where_boundary_fails(const Body_3& body, const Error_code status)
{
  if(status == ERROR_SEVERAL_BOUNDARY_COMPONENTS)
  {
    const Box_3 box = box_of_smallest_part(body);
    return sentence(" The smallest one is around ", describe(box.center()), ", and the diagonal of its box is ",
                    box.diagonal().norm(), ".");
  }
  if(status == ERROR_BOUNDARY_TOO_COARSE)
    return " It turns most around " + describe(middle_of_sharpest_edge(body)) + ".";
  if(status != ERROR_NON_MANIFOLD_BOUNDARY)
    return "";
  const std::vector<std::size_t> points = non_manifold_points(body);
  return sentence(" The boundary is not a manifold at ",
                  counted(points.size(), "vertex, the one at ", "vertices, among them the one at "),
                  describe(to_vector(body.points[points.front()])), ".");
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_NUMBERED_SURFACE_3_IMPL_H
