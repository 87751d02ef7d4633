// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_MAPPED_SOUP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_MAPPED_SOUP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/arguments.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Map of a complex or of arrays.
struct Mapped_soup_3 : Tetrahedron_soup_3
{
  Mapped_soup_3(Tetrahedron_soup_3 soup, std::vector<std::array<double, 3> > images_of_points)
    : Tetrahedron_soup_3(std::move(soup)), images(std::move(images_of_points))
  { require(images.size() == points.size(), "images must have an element for each point."); }

  template <typename C3t3, typename VertexUVWMap>
  Mapped_soup_3(const C3t3& c3t3, const VertexUVWMap uvw_map)
  {
    static_assert(Is_complex<C3t3>::value, "c3t3 must be a complex: a triangulation has no subset of cells.");
    static_assert(Is_map_of<VertexUVWMap, typename C3t3::Vertex_handle>::value,
                  "uvw_map must be a property map of vertices: for a container, pass make_vertex_point_map(container).");
    std::vector<typename C3t3::Triangulation::Vertex_handle> vertices;
    mesh_complex_3_to_tetrahedron_soup(c3t3, *this, vertices);
    images = points_of(vertices, uvw_map);
  }

  std::vector<std::array<double, 3> > images;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_MAPPED_SOUP_3_H
