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

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE
#  include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>
#endif

#include <limits>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE Numbered_surface_3 surface_of(const Body_3& body);

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::vector<std::size_t> non_manifold_points(const Body_3& body);

// Returns a sentence that tells where the boundary of a body is not a manifold; an empty one for other errors.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::string where_boundary_fails(const Body_3& body, Error_code status);

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE

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
  return sentence(" It is none at ", points.size(), " vertices, among them the one at ",
                  describe(to_vector(body.soup.points[points.front()])), ".");
}

#endif

} // namespace internal

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

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_VERTICES_H
