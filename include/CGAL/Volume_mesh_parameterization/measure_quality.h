// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_QUALITY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_QUALITY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/cell_quality_3.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>

namespace CGAL::Volume_mesh_parameterization {

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
  const Tetrahedron_soup_3 soup = internal::soup_of(points, cells);
  std::vector<Cell_quality_3> qualities;
  for(const std::array<std::size_t, 4>& cell : soup.cells)
  {
    const auto corner = [&](const int i) { return internal::to_vector(soup.points.at(cell[i])); };
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
  return measure_quality(internal::points_of(body.vertices, uvw_map), body.soup.cells);
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_QUALITY_H
