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
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Linear_solver_3.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Moves the vertices inside such that corners become positive and their angles right; those on the boundary stay.
inline void improve_hexahedra_3(Hexahedron_soup_3& mesh, Linear_solver_3& solver, const bool is_parallel)
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

  Numbered_mesh_3 numbered;
  const std::vector<std::size_t> order = engine::set_numbered_mesh(corners, points, is_on_boundary(mesh), numbered);
  numbered.target = numbered.source;
  const double mean_length = sum_of_lengths / (3. * static_cast<double>(corners.size()));
  const Map_3 map = engine::improve_corners(numbered, mean_length, solver, is_parallel);
  for(std::size_t i = 0; i < order.size(); ++i)
    mesh.points[order[i]] = { map.positions(0, i), map.positions(1, i), map.positions(2, i) };
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_IMPROVE_HEXAHEDRA_3_H
