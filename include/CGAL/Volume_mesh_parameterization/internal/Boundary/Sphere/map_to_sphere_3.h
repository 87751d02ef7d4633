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
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/inline.h>

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Radial_map_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Spherical_map_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/coarsen_surface_3.h>
#endif

#include <Eigen/Core>

#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Maps a topological sphere onto the unit sphere. It is a template, of `Numbered_surface_3`, for the sake of those who
// include the default boundary but call another one.
template <typename Surface>
Error_code map_to_sphere_3(const Surface& surface, std::vector<Eigen::Vector3d>& images, const Budget& budget);

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE
template <typename Mesh>
Error_code map_mesh_to_sphere_3(const Mesh& mesh, std::vector<Eigen::Vector3d>& images, const Budget& budget)
{
  const Error_code status = check_sphere(mesh);
  if(status != OK)
    return status;

  const std::vector<Eigen::Vector3d> points = unit_points(mesh);
  Spherical_map_3<> map(points, Vertex_rings_3(mesh), budget);
  if(!map.run())
    return ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
  images = map.images();
  return is_radially_bijective_3(mesh, images) ? OK : ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
}

template <typename Surface>
Error_code map_to_sphere_3(const Surface& surface, std::vector<Eigen::Vector3d>& images, const Budget& budget)
{
  Boundary_mesh_3 mesh;
  const Error_code status = build_boundary_mesh_3(surface, mesh);
  return status == OK ? map_mesh_to_sphere_3(mesh, images, budget) : status;
}
#endif

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SPHERE_3_H
