// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_DISTORTION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_DISTORTION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/cell_quality_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_of_complex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Facet_matching_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

measures the distortions of any map of a complex that is linear on its cells, as
`Parameterization_result::distortion` does for the result of a parameterization.

\tparam C3t3 a model of `MeshComplex_3InTriangulation_3`
\tparam VertexUVWMap a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
        `C3t3::Triangulation::Geom_traits::Point_3` as value type

\param c3t3 the complex; its cells must be positive
\param uvw_map the image of each vertex of a cell

\return the means and maxima over the cells. If rounding leaves no number for a flat cell, a value is infinite. For inverted
        cells, distortions are not defined.

The time is O(n log n) for n vertices, linear in the number of cells.

\sa `CGAL::stretch_minimizing_volume_parameterization()`
*/
template <typename C3t3, typename VertexUVWMap>
Distortion_3 measure_distortion(const C3t3& c3t3, const VertexUVWMap uvw_map)
{
  const internal::Body_of_complex_3<C3t3> body(c3t3);
  return internal::distortion_of_body_3(body, internal::points_of(body.vertices, uvw_map));
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

measures the distortions of a map of a mesh that is given by arrays, in the same way.

\param points the points, a random access range as `CGAL::stretch_minimizing_volume_parameterization()` takes it
\param cells four indices of points each, such that all cells are positive
\param images the image of each point
*/
template <typename PointRange, typename CellRange, typename ImageRange>
Distortion_3 measure_distortion(const PointRange& points, const CellRange& cells, const ImageRange& images)
{
  internal::Body_3 body;
  body.points = internal::coordinates_of(points);
  body.cells = internal::indices_of(cells);
  return internal::distortion_of_body_3(body, internal::coordinates_of(images));
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

computes the distortions of each cell of a complex.

\tparam C3t3 a model of `MeshComplex_3InTriangulation_3`
\tparam VertexUVWMap a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
        `C3t3::Triangulation::Geom_traits::Point_3` as value type

\param c3t3 the complex; its cells must be positive
\param uvw_map the image of each vertex of a cell

\return the distortions, in the order of `cells_in_complex_begin()`

The time is O(n log n) for n vertices, linear in the number of cells.

\sa `measure_distortion()`
*/
template <typename C3t3, typename VertexUVWMap, typename = typename C3t3::Triangulation>
std::vector<Cell_distortion_3> cell_distortions(const C3t3& c3t3, const VertexUVWMap uvw_map)
{
  const internal::Body_of_complex_3<C3t3> body(c3t3);
  return internal::distortions_of_cells_3(body.points, body.cells, internal::points_of(body.vertices, uvw_map));
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

computes the distortions of each cell of a mesh that is given by arrays, in linear time.

\param points the points, a range as `CGAL::stretch_minimizing_volume_parameterization()` takes it
\param cells four indices of points each, such that all cells are positive
\param images the image of each point

\return the distortions, in the order of the cells

\exception Input_error names a cell with an index that does not exist.

\pre There are as many images as points; otherwise `CGAL::Precondition_exception` is thrown, in every build.
*/
template <typename PointRange, typename CellRange, typename ImageRange, typename = internal::If_range<PointRange> >
std::vector<Cell_distortion_3> cell_distortions(const PointRange& points, const CellRange& cells, const ImageRange& images)
{
  const std::vector<std::array<double, 3> > source = internal::coordinates_of(points), image = internal::coordinates_of(images);
  const std::vector<std::array<std::size_t, 4> > indices = internal::indices_of(cells);
  internal::require(image.size() == source.size(), "images must have an element for each point.");
  internal::check_cells(indices, source.size());
  return internal::distortions_of_cells_3(source, indices, image);
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

measures the shapes of tetrahedra that are given by arrays: the cells of a mesh, or, with images for the points, those of
its image.

\tparam PointRange a range of points as `CGAL::stretch_minimizing_volume_parameterization()` takes it
\tparam CellRange a range of cells as `CGAL::stretch_minimizing_volume_parameterization()` takes it

\param points the points, or their images
\param cells four indices of points each

\return the worst values of all cells. An inverted cell has a negative scaled Jacobian.

The time is linear in the number of cells.

\sa `Parameterization_result::quality`
\sa `measure_distortion()`
*/
template <typename PointRange, typename CellRange, typename = internal::If_range<PointRange> >
Cell_quality_3 measure_quality(const PointRange& points, const CellRange& cells)
{
  const std::vector<std::array<double, 3> > coordinates = internal::coordinates_of(points);
  std::vector<Cell_quality_3> qualities;
  for(const std::array<std::size_t, 4>& cell : internal::indices_of(cells))
  {
    const auto corner = [&](const int i) { return internal::to_vector(coordinates.at(cell[i])); };
    qualities.push_back(internal::quality_of_cell({ corner(0), corner(1), corner(2), corner(3) }));
  }
  return qualities.empty() ? Cell_quality_3() : internal::worst_quality(qualities);
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

measures the shapes of the cells of the image of a complex.

\tparam C3t3 a model of `MeshComplex_3InTriangulation_3`
\tparam VertexUVWMap a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
        `C3t3::Triangulation::Geom_traits::Point_3` as value type

\param c3t3 the complex
\param uvw_map the image of each vertex of a cell
*/
template <typename C3t3, typename VertexUVWMap, typename = typename C3t3::Triangulation, typename = void>
Cell_quality_3 measure_quality(const C3t3& c3t3, const VertexUVWMap uvw_map)
{
  const internal::Body_of_complex_3<C3t3> body(c3t3);
  return measure_quality(internal::points_of(body.vertices, uvw_map), body.cells);
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_DISTORTION_H
