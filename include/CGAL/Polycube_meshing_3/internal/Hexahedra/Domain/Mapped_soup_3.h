// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_MAPPED_SOUP_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_MAPPED_SOUP_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>

namespace CGAL::Polycube_meshing_3::internal {

// Tetrahedra of a complex or of arrays, and the image of each point under a map.
struct Mapped_soup_3 : Tetrahedron_soup_3
{
  Mapped_soup_3(Tetrahedron_soup_3 soup, std::vector<std::array<double, 3> > images_of_points)
    : Tetrahedron_soup_3(std::move(soup)), images(std::move(images_of_points))
  { require(images.size() == points.size(), "images must have an element for each point."); }

  template <typename C3t3, typename VertexUVWMap>
  Mapped_soup_3(const C3t3& c3t3, const VertexUVWMap uvw_map)
  {
    std::vector<typename C3t3::Triangulation::Vertex_handle> vertices;
    mesh_complex_3_to_tetrahedron_soup(c3t3, *this, vertices);
    images = points_of(vertices, uvw_map);
  }

  std::vector<std::array<double, 3> > images;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_MAPPED_SOUP_3_H
