// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_CELL_DISTORTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_CELL_DISTORTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_arithmetic_3.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

struct Cell_distortion_3
{
  double angle, volume, det_J;
};

inline Eigen::Matrix3d edge_matrix(const std::vector<std::array<double, 3> >& points,
                                   const std::array<std::size_t, 4>& cell)
{
  Eigen::Matrix3d edges;
  for(int i = 0; i < 3; ++i)
    for(int k = 0; k < 3; ++k)
      edges(k, i) = points[cell[static_cast<std::size_t>(i + 1)]][static_cast<std::size_t>(k)]
                    - points[cell[0]][static_cast<std::size_t>(k)];
  return edges;
}

// the distortions of the map that takes `soup.points` to `uvw`, in each cell
inline std::vector<Cell_distortion_3> cell_distortions(const Tetrahedron_soup_3& soup,
                                                       const std::vector<std::array<double, 3> >& uvw)
{
  std::vector<Cell_distortion_3> distortions;
  distortions.reserve(soup.cells.size());
  for(const std::array<std::size_t, 4>& cell : soup.cells)
  {
    const Eigen::Matrix3d J = edge_matrix(uvw, cell) * edge_matrix(soup.points, cell).inverse();
    const Eigen::Vector3d stretches = signed_singular_values_3(J);
    const double ratio = stretches.maxCoeff() / stretches.minCoeff();
    const double det_J = stretches.prod();
    distortions.push_back({ratio + 1 / ratio, det_J + 1 / det_J, det_J});
  }
  return distortions;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_CELL_DISTORTION_3_H
