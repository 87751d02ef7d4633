// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MAKE_PARAMETERIZABLE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MAKE_PARAMETERIZABLE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Entry/map_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Simplex_removal_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Vertex_insertion_3.h>

#include <CGAL/iterator.h>

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_NAMED_PARAMETERS
#  error "The include directory of Volume_mesh_parameterization must precede the one of CGAL."
#endif

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

A vertex that refinement has inserted into a complex, with the vertices of the edge, facet or cell it was inserted into. Up to
rounding, it lies at their centroid. Therefore, the mean of values at these vertices is the value of the linear interpolation at
the new vertex.

\tparam VertexHandle `C3t3::Vertex_handle`
*/
template <typename VertexHandle>
struct Inserted_vertex_3
{
  VertexHandle vertex;               ///< the new vertex
  std::vector<VertexHandle> simplex; ///< the two, three or four vertices of the edge, facet or cell
};

namespace internal {

template <typename Vertex, typename NamedParameters, typename VertexOfPoint>
std::vector<Insertion_3> make_parameterizable_3(Body_3& body, const NamedParameters& np, const VertexOfPoint& vertex)
{
  check_named_parameters<internal_np::boundary_map_t, internal_np::vertex_is_constrained_t, internal_np::output_iterator_t>(np);
  Limits<NamedParameters> limits(np);
  const Budget budget = limits.budget();
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::boundary_map_t>::value)
  {
    const auto no_target = [](std::size_t) { return Exact_point_3(); };
    const Prescription_3 prescription = prescription_3<Vertex>(body, np, no_target, vertex);
    const std::vector<bool> is_prescribed = prescription.prescribed_points();
    const auto is_bad = [&](const Simplex_3& simplex) { return is_prescribed_simplex(is_prescribed, simplex); };
    return Simplex_removal_3(body, is_bad).run(is_prescribed, budget);
  }
  else
  {
    const auto boundary_map = parameters::get_parameter(np, internal_np::boundary_map);
    const Prescription_3 prescription
      = prescription_3<Vertex>(body, np, [&](const std::size_t p) { return get(boundary_map, vertex(p)); }, vertex);
    return remove_degenerate_simplices(body, prescription, budget);
  }
}

template <typename NamedParameters, typename VertexOfPoint>
std::size_t write_insertions(const std::vector<Insertion_3>& insertions, const NamedParameters& np,
                             const VertexOfPoint& vertex)
{
  using Vertex = decltype(vertex(0));
  auto out = parameter_or(np, internal_np::output_iterator, Emptyset_iterator());
  for(const Insertion_3& insertion : insertions)
  {
    Inserted_vertex_3<Vertex> inserted = { vertex(insertion.point), {} };
    for(const std::size_t v : insertion.simplex)
      inserted.simplex.push_back(vertex(v));
    *out++ = inserted;
  }
  return insertions.size();
}

// Refines arrays, or a soup.
template <typename Source, typename NamedParameters>
std::size_t make_parameterizable_arrays_3(const Source& source, const NamedParameters& np)
{
  const auto point = [](const std::size_t v) { return v; };
  Body_3 body = source.body(false);
  const std::vector<Insertion_3> insertions = make_parameterizable_3<std::size_t>(body, np, point);
  if(!insertions.empty())
    source.refine(std::move(body), insertions);
  return write_insertions(insertions, np, point);
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

refines a complex so that no interior edge, facet or cell has all its vertices on the boundary.

If this part of the boundary is mapped into a plane, such simplices become degenerate for all images of the interior
vertices. Meshes made by \ref PkgMesh3 "Mesh_3" have many of them.

A vertex is inserted into such simplices, at the midpoint of an edge or at the centroid of a facet or cell. Edges come first, and
among edges those that the boundary map degenerates. The next criterion is the number of simplices to be removed that contain the
edge, each counted once for each cell around the edge. The last criterion is the length. Facets and cells get a vertex only if
none of their edges can be split. Without a boundary map, all interior edges between two boundary vertices must be split, and the
number of insertions is minimal. With a boundary map, this rule is a heuristic for a small number.

The boundary, that is the facets between cells of the complex and cells outside, does not change. The volume of each
subdomain stays the same up to rounding. New cells, facets and feature edges belong to the complex with the index of their
origins. New vertices have the dimension and the index of the face of the complex they lie in. All new cells are positive, by
exact predicates on the stored coordinates. If the rounded midpoint does not allow this, another point near it is taken. If there
is no such point, the simplex is not changed, an extreme case for cells as thin as rounding errors.

The triangulation is no longer Delaunay or regular: use only its combinatorial structure afterwards.
Handles to cells around inserted vertices become invalid, handles to vertices remain valid.

\tparam C3t3 a model of `MeshComplexWithFeatures_3InTriangulation_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param c3t3 the complex; its cells must be positive
\param np a sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{boundary_map}
    \cgalParamDescription{If given, only simplices that cannot be mapped well with these images are removed, by exact predicates.
                          These are edges with coincident, facets with collinear, and cells with coplanar or negatively oriented
                          images. Edges and facets that are mapped into the boundary are also removed, such as an edge between
                          two vertices of a side of a cube.}
    \cgalParamType{a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
                   `C3t3::Triangulation::Geom_traits::Point_3` as value type}
    \cgalParamDefault{not given: all simplices with all vertices on the boundary are removed}
    \cgalParamExtra{Simplices of a vertex with a coordinate that is not finite are not removed.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{the vertices inside the complex that count as vertices of the boundary}
    \cgalParamType{a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and `bool` as value type}
    \cgalParamDefault{a constant property map returning `false`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{a limit for the running time in seconds; what is left to refine then is left as it is}
    \cgalParamType{`double`}
    \cgalParamDefault{no limit}
    \cgalParamPrecondition{The value is a number, and not negative.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{may end the refinement, if it has the function `goes_on()`; it receives no steps}
    \cgalParamType{a model of `ParameterizationVisitor_3`, passed by `std::ref()` if it keeps a state of interest}
    \cgalParamDefault{`Volume_mesh_parameterization::Default_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{output_iterator}
    \cgalParamDescription{receives the inserted vertices, in the order of their insertion}
    \cgalParamType{a model of `OutputIterator` that accepts `Inserted_vertex_3<C3t3::Vertex_handle>`}
    \cgalParamDefault{`Emptyset_iterator()`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of inserted vertices. If a limit ends the refinement, the complex is valid, and another call continues it.

The time is O(n + m d (d + log m)) for n cells, m removed simplices and at most d cells around an edge.

\sa `CGAL::stretch_minimizing_volume_parameterization()`
*/
template <typename C3t3, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t make_parameterizable(C3t3& c3t3, const CGAL_NP_CLASS& np = parameters::default_values())
{
  using Vertex_handle = typename C3t3::Vertex_handle;
  internal::Body_of_complex_3<C3t3> body(c3t3);
  const std::vector<internal::Insertion_3> insertions = internal::make_parameterizable_3<Vertex_handle>(
    body, np, [&](const std::size_t v) { return body.vertices[v]; });
  internal::insert_vertices(c3t3, body, insertions);
  return internal::write_insertions(insertions, np, [&](const std::size_t v) { return body.vertices[v]; });
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

refines a mesh that is given by arrays in the same way: the same points are inserted.

\param points the points, a range as `CGAL::stretch_minimizing_volume_parameterization()` takes it; new ones are appended
\param cells four indices of points each, such that all cells are positive. A cell that is split becomes one of its parts,
       the other parts are appended.
\param np the same as for a complex, with `std::size_t` for `C3t3::Vertex_handle`, and an array or another property map as
       `boundary_map`

\return the number of new points
*/
template <typename PointRange, typename CellRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          typename = internal::If_range<CellRange> > // other types are for other overloads
std::size_t make_parameterizable(PointRange& points, CellRange& cells,
                                 const CGAL_NP_CLASS& np = parameters::default_values())
{ return internal::make_parameterizable_arrays_3(internal::Arrays_3<PointRange, CellRange>{ points, cells }, np); }

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

refines a soup in the same way. New cells and marked facets have the references of their origins.
*/
template <typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t make_parameterizable(Tetrahedron_soup_3& soup, const CGAL_NP_CLASS& np = parameters::default_values())
{ return internal::make_parameterizable_arrays_3(internal::Arrays_of_soup_3<Tetrahedron_soup_3>{ soup }, np); }

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MAKE_PARAMETERIZABLE_H
