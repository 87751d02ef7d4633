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

#include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>

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

\return the means and maxima over the cells; infinite where a cell is so flat that rounding leaves no number. For inverted
        cells, distortions are not defined.

The time is O(n log n) for n vertices, linear in the number of cells.

\sa `CGAL::stretch_minimizing_volume_parameterization()`
*/
template <typename C3t3, typename VertexUVWMap>
Distortion_3 measure_distortion(const C3t3& c3t3, const VertexUVWMap uvw_map)
{
  const internal::Body_of_complex_3<C3t3> body(c3t3);
  return internal::distortion_of_soup_3(body.soup, internal::points_of(body.vertices, uvw_map));
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
  const Tetrahedron_soup_3 soup = internal::soup_of(points, cells);
  return internal::distortion_of_soup_3(soup, internal::coordinates_of(images));
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_DISTORTION_H
