// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_PAD_HEXAHEDRA_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_PAD_HEXAHEDRA_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/to_vector.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/hexahedron_corners_3.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Adds a layer along the boundary: each vertex of the boundary stays where it is, and the hexahedra around it get a
// copy further inside; a hexahedron is put between each quadrangle of the boundary and its copy. So no hexahedron has
// more than one quadrangle on the boundary, and each of its corners has a vertex inside.
inline Hexahedron_soup_3 padded(const Hexahedron_soup_3& mesh)
{
  constexpr double depth = 0.5; // on the way to the mean center of the hexahedra around the vertex
  std::vector<Eigen::Vector3d> sum(mesh.points.size(), Eigen::Vector3d::Zero());
  std::vector<int> number(mesh.points.size(), 0);
  for(const std::array<std::size_t, 8>& cell : mesh.cells)
  {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for(const std::size_t v : cell)
      center += to_vector(mesh.points[v]) / 8;
    for(const std::size_t v : cell)
    {
      sum[v] += center;
      ++number[v];
    }
  }

  Hexahedron_soup_3 result = mesh;
  std::vector<std::size_t> inner(mesh.points.size());
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    inner[v] = v;
    if(!is_outer[v])
      continue;
    const Eigen::Vector3d p = (1 - depth) * to_vector(mesh.points[v]) + depth * sum[v] / number[v];
    inner[v] = result.points.size();
    result.points.push_back({ p[0], p[1], p[2] });
  }
  for(std::array<std::size_t, 8>& cell : result.cells)
    for(std::size_t& v : cell)
      v = inner[v];
  for(const auto& [a, b, c, d] : boundary_quadrangles_3(mesh))
    result.cells.push_back({ inner[a], inner[b], inner[c], inner[d], a, b, c, d });
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_PAD_HEXAHEDRA_3_H
