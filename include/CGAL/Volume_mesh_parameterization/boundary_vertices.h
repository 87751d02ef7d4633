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
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/boundary_facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_point_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/sentence.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

namespace internal {

// The facets with a cell of a complex on one side and none on the other, as triples of indices of their vertices, which
// turn counterclockwise as seen from outside.
template <typename C3t3>
struct Boundary_facets
{
  using Vertex_handle = typename C3t3::Vertex_handle;

  std::vector<Vertex_handle> vertices;
  std::unordered_map<Vertex_handle, std::size_t> indices;
  std::vector<std::array<std::size_t, 3> > facets;
  std::vector<typename C3t3::Facet> facets_of_complex; // on the side of the cell

  explicit Boundary_facets(const C3t3& c3t3)
  {
    for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    {
      const typename C3t3::Cell_handle c = it;
      for(int i = 0; i < 4; ++i)
        if(!c3t3.is_in_complex(c->neighbor(i)))
          add_facet(c3t3, c, i);
    }
  }

private:
  // The vertex triple of a facet turns counterclockwise as seen from inside the cell.
  void add_facet(const C3t3& c3t3, const typename C3t3::Cell_handle c, const int i)
  {
    std::array<std::size_t, 3> facet;
    for(int k = 0; k < 3; ++k)
    {
      const Vertex_handle v = c->vertex(c3t3.triangulation().vertex_triple_index(i, 2 - k));
      const auto inserted = indices.emplace(v, vertices.size());
      if(inserted.second)
        vertices.push_back(v);
      facet[k] = inserted.first->second;
    }
    facets.push_back(facet);
    facets_of_complex.emplace_back(c, i);
  }
};

} // namespace internal

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

namespace internal {

// Where the boundary of a complex is not a manifold, as a sentence; empty for other errors.
template <typename C3t3>
std::string place_of_boundary_error(const C3t3& c3t3, const Error_code status)
{
  if(status != ERROR_NON_MANIFOLD_BOUNDARY)
    return "";
  std::vector<typename C3t3::Vertex_handle> vertices;
  non_manifold_boundary_vertices(c3t3, std::back_inserter(vertices));
  const auto p = point_of_vertex(c3t3.triangulation(), vertices.front());
  return sentence(" It is none at ", vertices.size(), " vertices, among them the one at ", describe(to_vector(p)), ".");
}

} // namespace internal

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_VERTICES_H
