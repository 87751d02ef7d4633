// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_EVALUATION_VOLUMES_OF_SUBDOMAINS_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_EVALUATION_VOLUMES_OF_SUBDOMAINS_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Hexahedral_mesh_result.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_with_domain_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Quadrangle_of_hexahedron.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/scaled_jacobians.h>

#include <map>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the volume of the trilinear image of a cube, by the divergence theorem: the part of a bilinear quadrangle is the mean
// of those of its two cuts into triangles.
inline double volume_of_hexahedron(const Hexahedra_3& mesh, const std::size_t c)
{
  const Eigen::Vector3d& origin = mesh.points[mesh.cells[c][0]]; // less rounding than by the origin of the axes
  double sum = 0;
  for(std::size_t side = 0; side < 6; ++side)
  {
    const std::array<std::size_t, 4> v = vertices_of(mesh, { c, side });
    const auto point = [&](const std::size_t i) -> Eigen::Vector3d { return mesh.points[v[i % 4]] - origin; };
    for(std::size_t i = 0; i < 4; ++i)
      sum += point(i).dot(point(i + 1).cross(point(i + 2))) / 12;
  }
  return sum;
}

inline double volume_of_tetrahedron(const Body_with_domain_3& body, const std::size_t c)
{
  const Eigen::Matrix3d edges = edge_matrix(body.points, body.soup.cells[c]);
  return edges.col(0).cross(edges.col(1)).dot(edges.col(2)) / 6;
}

inline std::vector<Subdomain_volumes> volumes_of_subdomains(const Body_with_domain_3& body, const Hexahedra_3& mesh)
{
  std::map<int, Subdomain_volumes> volumes;
  for(std::size_t c = 0; c < body.soup.cells.size(); ++c)
    volumes[body.soup.cell_references[c]].of_tetrahedra += volume_of_tetrahedron(body, c);
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

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_EVALUATION_VOLUMES_OF_SUBDOMAINS_H
