// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_MAP_TO_POLYCUBE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_MAP_TO_POLYCUBE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Normal_labels_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Polycube_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/repair_labels_3.h>

#include <Eigen/Dense>

#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Maps a surface onto a polycube for given labels. The coordinates of its faces are multiples of the spacing, or any if
// that is 0.
inline Error_code map_to_polycube_3(Boundary_mesh_3 mesh, const std::vector<std::size_t>& labels, const double spacing,
                                    std::vector<Eigen::Vector3d>& images)
{
  const Eigen::AlignedBox3d box = bounding_box(mesh);
  set_points(mesh, unit_points(mesh));
  Polycube_map_3 map(mesh, box, labels, spacing);
  const Error_code status = map.run();
  if(status == OK)
    images = map.images();
  return status;
}

// Maps a surface onto a polycube whose faces are close to it, with as many details as possible: proposes
// labels with more and more smoothing until there is a polycube for them.
inline Error_code map_to_polycube_3(Boundary_mesh_3 mesh, const double spacing, std::vector<Eigen::Vector3d>& images)
{
  const Eigen::AlignedBox3d box = bounding_box(mesh);
  set_points(mesh, unit_points(mesh));
  const Normal_labels_3 costs(mesh);
  Error_code status = ERROR_NO_POLYCUBE;
  for(double smoothing = 0.001; smoothing < 0.1; smoothing *= 2)
  {
    std::vector<std::size_t> labels = costs.minimize(smoothing);
    for(int attempt = 0; attempt < 10 && repair_labels_3(mesh, costs, smoothing, labels); ++attempt)
    {
      Polycube_map_3 map(mesh, box, labels, spacing);
      const Error_code status_of_map = map.run();
      if(status_of_map == OK)
      {
        images = map.images();
        return OK;
      }
      if(status == ERROR_NO_POLYCUBE)
        status = status_of_map;
      if(!give_away_faces(mesh, map.flipped_faces(), costs, labels))
        break;
    }
  }
  return status;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_MAP_TO_POLYCUBE_3_H
