// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_TURNED_SURFACE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_TURNED_SURFACE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Unit_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>

#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// Surface that is turned about the center of its bounding box, as it is in space and in the unit box.
struct Turned_surface_3 : Unit_surface_3
{
  Eigen::Matrix3d rotation;
  Numbered_surface_3 surface;

  // Takes a surface with its mesh, and the rotation.
  Turned_surface_3(const Numbered_surface_3& given, Boundary_mesh_3 mesh_of_given, const Eigen::Matrix3d& rotation)
    : rotation(rotation), surface(given)
  {
    mesh = std::move(mesh_of_given);
    is_sharp = are_among(mesh, surface.sharp_edges);
    if(rotation != Eigen::Matrix3d::Identity()) // which would round
      turn(bounding_box(mesh).center());
    box = bounding_box(mesh);
    set_points(mesh, unit_points(mesh));
  }

private:
  void turn(const Eigen::Vector3d& center)
  {
    for(Eigen::Vector3d& p : surface.points)
      p = center + rotation * (p - center);
    set_points(mesh, surface.points);
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_TURNED_SURFACE_3_H
