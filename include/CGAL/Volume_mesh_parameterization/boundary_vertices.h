// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_VERTICES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_VERTICES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Complex/Boundary_facets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/non_manifold_vertices.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationRef

writes the vertices of the boundary of a complex, those that need a target: the vertices of facets with a cell of the
complex on one side and none on the other. Each comes once, in the order of the cells.

\tparam C3t3 a model of `MeshComplex_3InTriangulation_3`
\tparam OutputIterator a model of `OutputIterator` that accepts `C3t3::Vertex_handle`

\param c3t3 the complex
\param out receives the vertices

\return `out`, after the last vertex

The time is linear in the number of cells.

\sa `non_manifold_boundary_vertices()`
*/
template <typename C3t3, typename OutputIterator>
OutputIterator boundary_vertices(const C3t3& c3t3, OutputIterator out)
{
  const internal::Boundary_facets<C3t3> boundary(c3t3);
  return std::copy(boundary.vertices.begin(), boundary.vertices.end(), out);
}

/*!
\ingroup PkgVolumeMeshParameterizationRef

writes the vertices where the boundary of a complex is not a manifold: those at an edge of more than two of its
facets, and those whose facets are not all joined by edges at the vertex. The models of `BoundaryParameterizer_3` refuse
complexes that have any with `ERROR_NON_MANIFOLD_BOUNDARY`.

\tparam C3t3 a model of `MeshComplex_3InTriangulation_3`
\tparam OutputIterator a model of `OutputIterator` that accepts `C3t3::Vertex_handle`

\param c3t3 the complex
\param out receives the vertices, each once, in the order of the cells

\return `out`, after the last vertex

The time is linear in the number of cells, and O(n log n) for n facets of the boundary.

\sa `boundary_vertices()`
*/
template <typename C3t3, typename OutputIterator>
OutputIterator non_manifold_boundary_vertices(const C3t3& c3t3, OutputIterator out)
{
  const internal::Boundary_facets<C3t3> boundary(c3t3);
  for(const std::size_t v : internal::non_manifold_vertices(boundary.vertices.size(), boundary.facets))
    *out++ = boundary.vertices[v];
  return out;
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_VERTICES_H
