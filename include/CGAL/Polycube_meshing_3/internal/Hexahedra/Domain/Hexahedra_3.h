// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_HEXAHEDRA_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_HEXAHEDRA_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Hexahedral_mesh_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>

#include <Eigen/Core>

#include <utility>

namespace CGAL::Polycube_meshing_3::internal {

// Hexahedra while they are made; the arrays are those of Hexahedron_soup_3.
struct Hexahedra_3
{
  std::vector<Eigen::Vector3d> points, images;
  std::vector<std::array<std::size_t, 8> > cells;
  std::vector<std::size_t> cell_blocks;
  std::vector<std::array<std::size_t, 3> > cell_indices;
  std::vector<int> cell_references;
  std::vector<std::array<std::size_t, 4> > facets;
  std::vector<std::size_t> facet_cells, polycube_faces;
};

inline std::vector<Eigen::Vector3d> vectors_of(const std::vector<std::array<double, 3> >& points)
{
  std::vector<Eigen::Vector3d> result;
  for(const auto& [x, y, z] : points)
    result.emplace_back(x, y, z);
  return result;
}

inline std::vector<std::array<double, 3> > arrays_of(const std::vector<Eigen::Vector3d>& points)
{
  std::vector<std::array<double, 3> > result;
  for(const Eigen::Vector3d& p : points)
    result.push_back({ p[0], p[1], p[2] });
  return result;
}

// Returns the soup of the hexahedra, still without references of quadrangles and interfaces.
inline Hexahedron_soup_3 hexahedron_soup_of(Hexahedra_3 mesh)
{
  Hexahedron_soup_3 result;
  result.points = arrays_of(mesh.points);
  result.images = arrays_of(mesh.images);
  result.cells = std::move(mesh.cells);
  result.cell_blocks = std::move(mesh.cell_blocks);
  result.cell_indices = std::move(mesh.cell_indices);
  result.cell_references = std::move(mesh.cell_references);
  result.facets = std::move(mesh.facets);
  result.facet_cells = std::move(mesh.facet_cells);
  result.polycube_faces = std::move(mesh.polycube_faces);
  return result;
}

// Returns for each vertex whether it is on the boundary.
template <typename Hexahedra>
std::vector<bool> is_on_boundary(const Hexahedra& mesh) { return used_points(mesh.facets, mesh.points.size()); }

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_HEXAHEDRA_3_H
