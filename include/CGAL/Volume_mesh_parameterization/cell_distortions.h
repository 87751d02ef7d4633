// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_CELL_DISTORTIONS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_CELL_DISTORTIONS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_arithmetic_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/check_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <Eigen/Dense>

#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

The distortions of one cell by a map with the differential \f$J\f$ there, as in `Distortion_3`. They have no unit; for
inverted cells, where \f$\det J\f$ is negative, those of angles and volumes are not defined.
*/
struct Cell_distortion_3
{
  double angle;  ///< the distortion of angles, 2 at least
  double volume; ///< the distortion of volumes, 2 at least
  double det_J;  ///< the volume of the image relative to that of the cell
};

namespace internal {

// Returns the distortion of a cell; `source(i)` and `image(i)` return the points of its vertices.
template <typename Source, typename Image>
Cell_distortion_3 distortion_of_cell(const Source& source, const Image& image)
{
  Eigen::Matrix3d X, U;
  for(int i = 0; i < 3; ++i)
  {
    X.col(i) = source(i + 1) - source(0);
    U.col(i) = image(i + 1) - image(0);
  }
  const Eigen::Vector3d s = signed_singular_values_3(U * X.inverse());
  const double ratio = s.maxCoeff() / s.minCoeff(), determinant = s.prod();
  return { ratio + 1 / ratio, determinant + 1 / determinant, determinant };
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

computes the distortions of one cell of a complex, in constant time.

\tparam C3t3 a model of `MeshComplex_3InTriangulation_3`
\tparam VertexUVWMap a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
        `C3t3::Triangulation::Geom_traits::Point_3` as value type

\param c3t3 the complex
\param cell the cell, which must be positive
\param uvw_map the image of each vertex of the cell

\sa `measure_distortion()`
*/
template <typename C3t3, typename VertexUVWMap>
Cell_distortion_3 cell_distortion(const C3t3& c3t3, const typename C3t3::Cell_handle cell, const VertexUVWMap uvw_map)
{
  return internal::distortion_of_cell(
    [&](const int i) { return internal::to_vector(internal::point_of_vertex(c3t3.triangulation(), cell->vertex(i))); },
    [&](const int i) { return internal::to_vector(get(uvw_map, cell->vertex(i))); });
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

computes the distortions of all cells of a mesh that is given by arrays, in linear time.

\param points the points
\param cells four indices of points each, such that all cells are positive
\param images the image of each point

\return the distortions, in the order of the cells

\exception Input_error names a cell with an index that does not exist.

\pre There are as many images as points; otherwise `CGAL::Precondition_exception` is thrown, in every build.
*/
inline std::vector<Cell_distortion_3> cell_distortions(const std::vector<std::array<double, 3> >& points,
                                                       const std::vector<std::array<std::size_t, 4> >& cells,
                                                       const std::vector<std::array<double, 3> >& images)
{
  internal::require(images.size() == points.size(), "images must have an element for each point.");
  internal::check_cells(cells, points.size());
  std::vector<Cell_distortion_3> result;
  result.reserve(cells.size());
  for(const std::array<std::size_t, 4>& cell : cells)
    result.push_back(internal::distortion_of_cell([&](const int i) { return internal::to_vector(points[cell[i]]); },
                                                  [&](const int i) { return internal::to_vector(images[cell[i]]); }));
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_CELL_DISTORTIONS_H
