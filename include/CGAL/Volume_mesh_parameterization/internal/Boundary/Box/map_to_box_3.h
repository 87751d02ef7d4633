// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_MAP_TO_BOX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_MAP_TO_BOX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/inline.h>

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Box/Box_map_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Box/cube_corners_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/map_to_sphere_3.h>
#endif

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Maps a topological sphere onto the boundary of a box around the origin. The corners are chosen if they are not given.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Error_code map_to_box_3(const Numbered_surface_3& surface, const Eigen::Vector3d& half_lengths,
                        const std::optional<std::array<int, 8> >& corners, std::vector<Eigen::Vector3d>& images,
                        const Budget& budget);

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Error_code map_to_box_3(const Numbered_surface_3& surface, const Eigen::Vector3d& half_lengths,
                        const std::optional<std::array<int, 8> >& corners, std::vector<Eigen::Vector3d>& images,
                        const Budget& budget)
{
  Boundary_mesh_3 mesh;
  Error_code status = build_boundary_mesh_3(surface, mesh);
  if(status != OK)
    return status;
  if(mesh.number_of_vertices() < 8)
    return ERROR_BOUNDARY_TOO_COARSE;
  std::vector<Eigen::Vector3d> sphere;
  status = map_mesh_to_sphere_3(mesh, sphere, budget);
  if(status != OK)
    return status;

  return map_sphere_to_box_3(mesh, sphere, half_lengths,
                             corners ? *corners : cube_corners_3(unit_points(mesh), sphere, half_lengths), images, budget);
}
#endif

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_MAP_TO_BOX_3_H
