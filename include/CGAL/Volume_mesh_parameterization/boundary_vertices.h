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

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_of_complex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Facet_matching_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

template <typename C3t3>
std::vector<typename C3t3::Vertex_handle> handles_of(const Body_of_complex_3<C3t3>& body, const std::vector<std::size_t>& points)
{
  std::vector<typename C3t3::Vertex_handle> result;
  for(const std::size_t p : points)
    result.push_back(body.vertices[p]);
  return result;
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns the vertices of the boundary of a complex. These vertices need a target. A facet of the boundary has a cell of the
complex on one side only.

\tparam C3t3 a model of `MeshComplex_3InTriangulation_3`

\param c3t3 the complex

\return the vertices, each once, in the order of the cells

The time is linear in the number of cells.

\sa `non_manifold_boundary_vertices()`
*/
template <typename C3t3>
std::vector<typename C3t3::Vertex_handle> boundary_vertices(const C3t3& c3t3)
{
  const internal::Body_of_complex_3<C3t3> body(c3t3);
  return internal::handles_of(body, internal::Numbered_points(body.boundary, body.points.size()).points);
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns the points on the boundary of a mesh that is given by arrays, as indices in the order of the cells.

\exception Input_error is thrown as by CGAL::stretch_minimizing_volume_parameterization().
*/
template <typename PointRange, typename CellRange, typename = internal::If_range<PointRange> >
std::vector<std::size_t> boundary_vertices(const PointRange& points, const CellRange& cells)
{
  const internal::Body_3 body = internal::body_of(points, cells);
  return internal::Numbered_points(body.boundary, body.points.size()).points;
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns the vertices at which the boundary of a complex is not a manifold. At such a vertex, an edge has more than two boundary
facets, or edges do not connect all boundary facets of the vertex. If a complex has such vertices, the models of
`BoundaryParameterizer_3` return `ERROR_NON_MANIFOLD_BOUNDARY`.

\tparam C3t3 a model of `MeshComplex_3InTriangulation_3`

\param c3t3 the complex

\return the vertices, each once, in the order of the cells

The time is linear in the number of cells, and O(n log n) for n facets of the boundary.

\sa `boundary_vertices()`
*/
template <typename C3t3>
std::vector<typename C3t3::Vertex_handle> non_manifold_boundary_vertices(const C3t3& c3t3)
{
  const internal::Body_of_complex_3<C3t3> body(c3t3);
  return internal::handles_of(body, internal::non_manifold_points(body));
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns the points at which the boundary of a mesh in arrays is not a manifold, as indices.
*/
template <typename PointRange, typename CellRange, typename = internal::If_range<PointRange> >
std::vector<std::size_t> non_manifold_boundary_vertices(const PointRange& points, const CellRange& cells)
{ return internal::non_manifold_points(internal::body_of(points, cells)); }

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns the sharp edges of the boundary of a mesh that is given by arrays. Polycubes and hexahedra follow them. Marked edges of the
boundary are sharp. If no edge of the boundary is marked, edges with 60 degrees or more between the normals on both sides are
sharp.

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
