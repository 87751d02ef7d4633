// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_TO_MESH_COMPLEX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_TO_MESH_COMPLEX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Soups/Mesh_complex_3_builder.h>

namespace CGAL::Volume_mesh_parameterization {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// builds a mesh complex from a tetrahedron soup.
///
/// All cells are in the complex; their subdomain indices are the references of the soup.
/// The complex also contains the facets of cells that the soup lists, with their references as patch indices. It contains the
/// other facets of the boundary, and the facets between different subdomains. So are the marked edges and corners, as features,
/// if the complex is a model of `MeshComplexWithFeatures_3InTriangulation_3`; corners are numbered from 1. Index 0 means outside
/// the complex. Therefore, reference 0 of cells, facets and edges is replaced by the smallest positive number that is not used
/// as a reference. Facets without reference get this number, too.
///
/// The cells may have several connected components and a non-manifold boundary. They are oriented positively
/// if all are negative in the soup. A point without a cell gets no vertex: it keeps its index in
/// the soup, and its handle is `Vertex_handle()`.
///
/// \tparam C3t3 a model of `MeshComplex_3InTriangulation_3` whose types `Subdomain_index` and `Surface_patch_index`
///         can be constructed from `int`, and `Index` from both. An example has
///         `CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3` as triangulation
///
/// \param soup the mesh
/// \param c3t3 the complex; former contents are removed
/// \param vertices gets the vertex handle of each point, in the order of the soup
/// \param cells gets the cell handle of each cell, in the order of the soup
///
/// \exception Input_error is thrown for a coordinate that is not finite, or an index out of range. No cell may have a vertex twice
///            or zero volume. A facet must not have more than two cells, or two cells on one side. It is also thrown if some
///            cells are positive and others negative, by exact predicates on the coordinates in the number type of the kernel.
///            The other parameters are then unchanged.
template <typename C3t3>
void tetrahedron_soup_to_mesh_complex_3(const Tetrahedron_soup_3& soup, C3t3& c3t3,
                                        std::vector<typename C3t3::Triangulation::Vertex_handle>& vertices,
                                        std::vector<typename C3t3::Triangulation::Cell_handle>& cells)
{
  using Point_3 = typename C3t3::Triangulation::Geom_traits::Point_3;
  const internal::Coordinate_type type = internal::coordinate_type<internal::Coordinate_of<Point_3> >();
  Tetrahedron_soup_3 rounded;
  if(type.is_narrow())
  {
    rounded = soup;
    for(std::array<double, 3>& p : rounded.points)
      p = type.rounded_point(p);
  }
  const Tetrahedron_soup_3& stored = type.is_narrow() ? rounded : soup;
  internal::check_points(stored);
  internal::check_simplices(stored);
  const bool has_negative_cells = internal::has_negative_cells(stored);
  const internal::Facet_matching_3 matching(stored.cells, false, stored.facets);

  internal::Mesh_complex_3_builder<C3t3>(stored, matching, c3t3, vertices, cells).build(has_negative_cells);
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// builds a mesh complex from a tetrahedron soup, as above, for callers that do not need the cell handles.
template <typename C3t3>
void tetrahedron_soup_to_mesh_complex_3(const Tetrahedron_soup_3& soup, C3t3& c3t3,
                                        std::vector<typename C3t3::Triangulation::Vertex_handle>& vertices)
{
  std::vector<typename C3t3::Triangulation::Cell_handle> cells;
  tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// builds a mesh complex from a tetrahedron soup, as above, for callers that need no handles.
template <typename C3t3>
void tetrahedron_soup_to_mesh_complex_3(const Tetrahedron_soup_3& soup, C3t3& c3t3)
{
  std::vector<typename C3t3::Triangulation::Vertex_handle> vertices;
  tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices);
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_TO_MESH_COMPLEX_3_H
