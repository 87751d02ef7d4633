// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_IMPROVE_HEXAHEDRA_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_IMPROVE_HEXAHEDRA_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/to_vector.h>
#include <CGAL/Volume_mesh_parameterization/internal/Engine/engine.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/hexahedron_corners_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Moves vertices such that corners become positive and their angles right: each in the directions onto which its
// projector projects, and not at all if that is zero.
inline void improve_hexahedra_3(Hexahedron_soup_3& mesh, const std::vector<Eigen::Matrix3d>& projectors,
                                Linear_solver_3& solver, const bool is_parallel)
{
  Eigen::Matrix3Xd points(3, mesh.points.size());
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    points.col(v) = to_vector(mesh.points[v]);
  std::vector<std::array<int, 4> > corners;
  double sum_of_lengths = 0;
  for_each_corner(mesh, [&](const std::array<std::size_t, 4>& corner)
  {
    corners.push_back({ static_cast<int>(corner[0]), static_cast<int>(corner[1]), static_cast<int>(corner[2]),
                        static_cast<int>(corner[3]) });
    sum_of_lengths += edge_matrix(points, corners.back()).colwise().norm().sum();
  });

  std::vector<bool> is_fixed;
  for(const Eigen::Matrix3d& projector : projectors)
    is_fixed.push_back(projector.isZero(0));
  Numbered_mesh_3 numbered;
  const std::vector<std::size_t> order = engine::set_numbered_mesh(corners, points, is_fixed, numbered);
  numbered.target = numbered.source;
  std::vector<Eigen::Matrix3d> ordered;
  for(const std::size_t v : order)
    ordered.push_back(projectors[v]);
  const double mean_length = sum_of_lengths / (3. * static_cast<double>(corners.size()));
  const Map_3 map = engine::improve_corners(numbered, ordered, mean_length, solver, is_parallel, Budget());
  for(std::size_t i = 0; i < order.size(); ++i)
    mesh.points[order[i]] = { map.positions(0, i), map.positions(1, i), map.positions(2, i) };
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_IMPROVE_HEXAHEDRA_3_H
