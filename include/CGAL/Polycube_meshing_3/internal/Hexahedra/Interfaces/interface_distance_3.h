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

#include <CGAL/Polycube_meshing_3/Hexahedral_mesh_result.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Covered_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/Interface_positions_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the volume of the trilinear image of a cube, by the divergence theorem: the part of a bilinear quadrangle is the mean
// of those of its two cuts into triangles.
inline double volume_of_hexahedron(const Hexahedron_soup_3& mesh, const std::size_t c)
{
  const Eigen::Vector3d origin = to_vector(mesh.points[mesh.cells[c][0]]); // less rounding than by the origin of the axes
  double sum = 0;
  for(std::size_t side = 0; side < 6; ++side)
  {
    const std::array<std::size_t, 4> v = vertices_of(mesh, { c, side });
    const auto point = [&](const std::size_t i) -> Eigen::Vector3d { return to_vector(mesh.points[v[i % 4]]) - origin; };
    for(std::size_t i = 0; i < 4; ++i)
      sum += point(i).dot(point(i + 1).cross(point(i + 2))) / 12;
  }
  return sum;
}

inline double volume_of_tetrahedron(const Tetrahedron_soup_3& soup, const std::size_t c)
{
  const auto edge = [&](const std::size_t i) -> Eigen::Vector3d
  { return to_vector(soup.points[soup.cells[c][i]]) - to_vector(soup.points[soup.cells[c][0]]); };
  return edge(1).cross(edge(2)).dot(edge(3)) / 6;
}

inline std::vector<Subdomain_volumes> volumes_of_subdomains(const Tetrahedron_soup_3& soup, const Hexahedron_soup_3& mesh)
{
  std::map<int, Subdomain_volumes> volumes;
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    volumes[soup.cell_references[c]].of_tetrahedra += volume_of_tetrahedron(soup, c);
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    volumes[mesh.cell_references[c]].of_hexahedra += volume_of_hexahedron(mesh, c);
  std::vector<Subdomain_volumes> result;
  for(auto& [reference, of_reference] : volumes)
  {
    of_reference.reference = reference;
    result.push_back(of_reference);
  }
  return result;
}

// Measures the distances of the vertices, the middles of edges and the centers of quadrangles from the interface of their
// subdomains, and those of the vertices of interfaces from the quadrangles.
inline Largest_distance_3 interface_distance_3(const Hexahedron_soup_3& mesh, Body_interfaces_3& interfaces)
{
  Largest_distance_3 result;
  Matrix3Xd positions(3, mesh.points.size());
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    positions.col(v) = to_vector(mesh.points[v]);
  std::map<Body_interfaces_3::Pair, Triangles_of_boundary> triangles;
  for(const Interface_quadrangle_3& q : interface_quadrangles_3(mesh))
  {
    const Body_surface_3& surface = interfaces.surface_of_pair(pair_of(mesh, q));
    const auto point = [&](const std::size_t i) -> Eigen::Vector3d { return positions.col(q.vertices[i % 4]); };
    const auto take = [&](const Eigen::Vector3d& p) { result.take(p, surface.nearest(p, Freedom_3::SURFACE)); };
    take((point(0) + point(1) + point(2) + point(3)) / 4);
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
      for_each_nearest(interfaces.surface(patches).vertices(), found->second, positions,
                       [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const std::array<int, 3>&) { result.take(p, q); });
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_INTERFACE_DISTANCE_3_H
