// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MESH_COMPLEX_3_TO_TETRAHEDRON_SOUP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MESH_COMPLEX_3_TO_TETRAHEDRON_SOUP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_of_complex_3.h>

namespace CGAL::Volume_mesh_parameterization {
/// \ingroup PkgVolumeMeshParameterizationIO
///
/// collects the cells of a mesh complex and their vertices in a tetrahedron soup without marked facets, in linear time. The edges
/// of 1-dimensional features and the corners, 0-dimensional ones, are marked, if the complex is a model of
/// `MeshComplexWithFeatures_3InTriangulation_3`. Former contents of the soup are removed.
///
/// \tparam C3t3 a model of `MeshComplex_3InTriangulation_3` whose type `Subdomain_index` is an integer type
///
/// \param c3t3 the complex
/// \param soup gets the mesh, with the subdomain indices as cell references
/// \param vertices gets the vertex handle of each point of the soup
template <typename C3t3>
void mesh_complex_3_to_tetrahedron_soup(const C3t3& c3t3, Tetrahedron_soup_3& soup,
                                        std::vector<typename C3t3::Triangulation::Vertex_handle>& vertices)
{
  internal::Body_of_complex_3<C3t3> body(c3t3);
  soup = {};
  for(const auto cell : body.cells_of_complex)
    soup.cell_references.push_back(static_cast<int>(c3t3.subdomain_index(cell)));
  soup.points = std::move(body.points);
  soup.cells = std::move(body.cells);
  soup.edges = std::move(body.edges);
  soup.edge_references = std::move(body.curves);
  soup.corners = std::move(body.corners);
  vertices = std::move(body.vertices);
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MESH_COMPLEX_3_TO_TETRAHEDRON_SOUP_H
