// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_FORCES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_FORCES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <Eigen/Dense>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns the force that holds each vertex of an elastic body: the gradient of the integral of \f$\psi\f$ over the source, with
respect to the image of the vertex. After a map with `use_volume_weights(true)` and `reference_scale(1)`, the forces at free
vertices vanish, and those at prescribed vertices are the reactions of a static analysis.

\param points the points of the source
\param cells four indices of points each, positive in the source
\param images the images of the points; those of points without a cell are not read
\param energy a model of `DistortionEnergy_3`

\exception Input_error names a wrong index.
*/
template <typename PointRange, typename CellRange, typename ImageRange, typename Energy>
std::vector<std::array<double, 3> > measure_forces(const PointRange& points, const CellRange& cells, const ImageRange& images,
                                                   const Energy& energy)
{
  const internal::Body_3 body = internal::body_of(points, cells);
  const std::vector<std::array<double, 3> > image = internal::coordinates_of(images);
  internal::require(image.size() == body.points.size(), "images must have an element for each point.");
  std::vector<std::array<double, 3> > result(body.points.size(), { 0, 0, 0 });
  for(const std::array<std::size_t, 4>& cell : body.cells)
  {
    const auto edges = [&](const std::vector<std::array<double, 3> >& of)
    {
      Eigen::Matrix3d matrix;
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j)
          matrix(j, i) = of[cell[i + 1]][j] - of[cell[0]][j];
      return matrix;
    };
    const Eigen::Matrix3d X = edges(body.points), inverse = X.inverse();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(edges(image) * inverse, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Vector3d slopes = energy.gradient(Eigen::Vector3d(svd.singularValues()));
    const Eigen::Matrix3d stress = svd.matrixU() * slopes.asDiagonal() * svd.matrixV().transpose();
    const Eigen::Matrix3d forces = X.determinant() / 6 * stress * inverse.transpose(); // at the last three vertices
    for(int j = 0; j < 3; ++j)
    {
      for(int i = 0; i < 3; ++i)
        result[cell[i + 1]][j] += forces(j, i);
      result[cell[0]][j] -= forces.row(j).sum();
    }
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_FORCES_H
