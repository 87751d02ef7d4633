// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_TO_MESH_COMPLEX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_TO_MESH_COMPLEX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Facet_matching_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Mesh_complex_3_builder.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Soup/check_tetrahedron_soup.h>

#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// builds a mesh complex from a tetrahedron soup.
///
/// All cells are in the complex; their subdomain indices are the references of the soup.
/// So are the facets of cells that the soup lists, with their references as patch indices,
/// the other facets of the boundary, and those between different subdomains.
/// Since index 0 means outside the complex, cells and facets with reference 0 and facets without reference
/// get the smallest positive number that is not used as a reference.
///
/// The cells may have several connected components and a non-manifold boundary. They are oriented positively
/// if all are negative in the soup. A point without a cell gets no vertex: it keeps its index in
/// the soup, and its handle is `Vertex_handle()`.
///
/// \tparam C3t3 a model of `MeshComplex_3InTriangulation_3` whose types `Subdomain_index` and `Surface_patch_index`
///         can be constructed from `int`, and `Index` from both; for instance with
///         `CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3` as triangulation
///
/// \param soup the mesh
/// \param c3t3 the complex; what it contained before is removed
/// \param vertices gets the vertex handle of each point, in the order of the soup
/// \param cells gets the cell handle of each cell, in the order of the soup
///
/// \exception Input_error if a coordinate is not finite, an index is out of range, a cell has a vertex twice or
///            zero volume, some cells are oriented positively and others negatively (by exact predicates),
///            a facet has more than two cells, or two cells lie on the same side of their common facet;
///            the other parameters are then unchanged.
template <typename C3t3>
void tetrahedron_soup_to_mesh_complex_3(const Tetrahedron_soup_3& soup,
                                        C3t3& c3t3,
                                        std::vector<typename C3t3::Triangulation::Vertex_handle>& vertices,
                                        std::vector<typename C3t3::Triangulation::Cell_handle>& cells)
{
  internal::check_points(soup);
  internal::check_simplices(soup);
  const bool has_negative_cells = internal::has_negative_cells(soup);
  const internal::Facet_matching_3 matching(soup);

  internal::Mesh_complex_3_builder<C3t3>(soup, matching, c3t3, vertices, cells).build(has_negative_cells);
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_TO_MESH_COMPLEX_3_H
