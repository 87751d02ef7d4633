// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_INTERFACE_DISTANCE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_INTERFACE_DISTANCE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Covered_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/Interface_positions_3.h>

namespace CGAL::Polycube_meshing_3::internal {

// Measures the distances of the vertices, the middles of edges and the centers of quadrangles from the interface of their
// subdomains, and those of the vertices of interfaces from the quadrangles.
inline Largest_distance_3 interface_distance_3(const Hexahedra_3& mesh, Body_interfaces_3& interfaces)
{
  Largest_distance_3 result;
  std::map<Body_interfaces_3::Pair, Triangles_of_boundary> triangles;
  for(const Interface_quadrangle_3& q : interface_quadrangles_3(mesh))
  {
    const Body_surface_3& surface = interfaces.surface_of_pair(pair_of(mesh, q));
    const auto point = [&](const std::size_t i) { return mesh.points[q.vertices[i % 4]]; };
    const auto take = [&](const Eigen::Vector3d& p) { result.take(p, surface.nearest(p, Freedom_3::SURFACE)); };
    take(center_of(mesh.points, q.vertices));
    for(std::size_t i = 0; i < 4; ++i)
    {
      take(point(i));
      take((point(i) + point(i + 1)) / 2);
    }
    for(const std::size_t k : { 1, 2 })
      triangles[pair_of(mesh, q)].push_back({ static_cast<int>(q.vertices[0]), static_cast<int>(q.vertices[k]),
                                              static_cast<int>(q.vertices[k + 1]) });
  }
  for(const auto& [pair, patches] : interfaces.patches_of_pairs())
    if(const auto found = triangles.find(pair); found != triangles.end()) // otherwise a subdomain lacks hexahedra
      for_each_nearest(interfaces.surface(patches).vertices(), found->second, columns_of(mesh.points),
                       [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const std::array<int, 3>&) { result.take(p, q); });
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_INTERFACE_DISTANCE_3_H
