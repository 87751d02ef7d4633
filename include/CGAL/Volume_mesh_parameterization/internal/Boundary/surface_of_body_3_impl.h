// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SURFACE_OF_BODY_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SURFACE_OF_BODY_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/surface_of_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE Numbered_surface_3 surface_of(const Body_3& body)
{
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  Numbered_surface_3 surface;
  surface.facets = body.boundary;
  surface.cells = &body.soup.cells;
  std::vector<std::size_t> numbers(body.soup.points.size(), none);
  for(std::array<std::size_t, 3>& facet : surface.facets)
    for(std::size_t& v : facet)
    {
      if(numbers[v] == none)
      {
        numbers[v] = surface.vertices.size();
        surface.vertices.push_back(v);
        surface.points.push_back(to_vector(body.soup.points[v]));
      }
      v = numbers[v];
    }
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

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::string where_boundary_fails(const Body_3& body, const Error_code status)
{
  if(status != ERROR_NON_MANIFOLD_BOUNDARY)
    return "";
  const std::vector<std::size_t> points = non_manifold_points(body);
  return sentence(" It is no manifold at ", points.size(), points.size() == 1 ? " vertex, the one at "
                                                                              : " vertices, among them the one at ",
                  describe(to_vector(body.soup.points[points.front()])), ".");
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SURFACE_OF_BODY_3_IMPL_H
