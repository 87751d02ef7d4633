// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_VERTICES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_VERTICES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/surface_of_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/check_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

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
template <typename C3t3, typename OutputIterator, typename = typename C3t3::Triangulation>
OutputIterator boundary_vertices(const C3t3& c3t3, OutputIterator out)
{
  const internal::Body_of_complex_3<C3t3> body(c3t3);
  for(const std::size_t v : internal::surface_of(body).vertices)
    *out++ = body.vertices[v];
  return out;
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns the points on the boundary of a mesh that is given by arrays, as indices. Throws `Input_error` as
`CGAL::stretch_minimizing_volume_parameterization()` does.
*/
template <typename PointRange, typename CellRange, typename = internal::If_range<PointRange> >
std::vector<std::size_t> boundary_vertices(const PointRange& points, const CellRange& cells)
{ return internal::surface_of(internal::body_of(points, cells)).vertices; }

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

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
template <typename C3t3, typename OutputIterator, typename = typename C3t3::Triangulation>
OutputIterator non_manifold_boundary_vertices(const C3t3& c3t3, OutputIterator out)
{
  const internal::Body_of_complex_3<C3t3> body(c3t3);
  for(const std::size_t v : internal::non_manifold_points(body))
    *out++ = body.vertices[v];
  return out;
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns the points where the boundary of a mesh that is given by arrays is not a manifold, as indices.
*/
template <typename PointRange, typename CellRange, typename = internal::If_range<PointRange> >
std::vector<std::size_t> non_manifold_boundary_vertices(const PointRange& points, const CellRange& cells)
{ return internal::non_manifold_points(internal::body_of(points, cells)); }

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns the sharp edges of the boundary of a mesh that is given by arrays, which polycubes and hexahedra follow: those among marked
edges, or if no edge of the boundary is marked, those whose facets have normals with an angle of more than 60 degrees.

\param points the points
\param cells four indices of points for each cell, such that all cells are positive
\param marked_edges two indices of points for each edge

\return two indices of points for each edge, the smaller one first, in ascending order. The time is O(n log n) for n cells.
*/
inline std::vector<std::array<std::size_t, 2> >
sharp_boundary_edges(const std::vector<std::array<double, 3> >& points, const std::vector<std::array<std::size_t, 4> >& cells,
                     const std::vector<std::array<std::size_t, 2> >& marked_edges = {})
{
  internal::check_cells(cells, points.size());
  return internal::sharp_edges_3(internal::boundary_facets_3(cells), marked_edges,
                                 [&](const std::size_t v) { return internal::to_vector(points[v]); });
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_VERTICES_H
