// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SPHERE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SPHERE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Spherical_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/is_radially_bijective_3.h>

#include <Eigen/Dense>

#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Maps a closed surface onto the unit sphere, if it is a topological sphere. Compiled only where it is used: the header
// of the entry function includes it.
template <typename Boundary_mesh>
Error_code map_to_sphere_3(const Boundary_mesh& mesh, std::vector<Eigen::Vector3d>& images)
{
  const Error_code status = check_sphere(mesh);
  if(status != OK)
    return status;

  const std::vector<Eigen::Vector3d> points = unit_points(mesh);
  Spherical_map_3<> map(points, Vertex_rings_3(mesh));
  if(!map.run())
    return ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
  images = map.images();
  return is_radially_bijective_3(mesh, images) ? OK : ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SPHERE_3_H
