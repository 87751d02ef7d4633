// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_BALANCE_INTERFACES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_BALANCE_INTERFACES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/Interface_positions_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/scaled_jacobians.h>

namespace CGAL::Polycube_meshing_3::internal {

// Moves vertices inside of curved patches off the interface, towards the outside of their curvature, such that quadrangles are
// on both sides of the interface alike: with all vertices on a sphere its volume would be lost to the chords. No hexahedron
// around them gets worse by more than a part of its scaled Jacobian.
inline void balance_interfaces_3(Body_interfaces_3& interfaces, Hexahedra_3& mesh)
{
  constexpr double part = 2. / 3; // mean distance of a bilinear quadrangle, whose vertices are on a sphere, by that of its center
  constexpr double largest_loss = 0.1; // a guess
  std::vector<Interface_quadrangle_3> quadrangles = interface_quadrangles_3(mesh);
  set_patches(mesh, interfaces, quadrangles);
  std::vector<std::set<std::size_t> > patches(mesh.points.size());
  std::vector<Eigen::Vector3d> way(mesh.points.size(), Eigen::Vector3d::Zero());
  std::vector<int> number(mesh.points.size(), 0);
  for(const Interface_quadrangle_3& q : quadrangles)
  {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for(const std::size_t v : q.vertices)
      center += mesh.points[v] / 4;
    for(const std::size_t v : q.vertices)
    {
      patches[v].insert(q.patch);
      ++number[v];
      if(q.patch != 0)
        way[v] += interfaces.surface({ q.patch }).nearest(center, Freedom_3::SURFACE) - center;
    }
  }
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  const std::vector<Eigen::Vector3d> before = mesh.points;
  const std::vector<double> quality = scaled_jacobians(mesh);
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    if(patches[v].size() == 1 && !is_outer[v])
      mesh.points[v] += part / number[v] * way[v];
  for(bool is_final = false; !is_final; )
  {
    is_final = true;
    const std::vector<double> next = scaled_jacobians(mesh);
    for(std::size_t c = 0; c < mesh.cells.size(); ++c)
      if(next[c] < (1 - largest_loss) * quality[c] || !is_positive_hexahedron(mesh, c))
        for(const std::size_t v : mesh.cells[c])
          if(mesh.points[v] != before[v])
          {
            mesh.points[v] = before[v];
            is_final = false;
          }
  }
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_BALANCE_INTERFACES_3_H
