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
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/inline.h>

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Normal_labels_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Polycube_map_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/repair_labels_3.h>
#endif

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Maps a surface onto a polycube. Without labels of the facets, which are the axes that their images are normal to, some
// are proposed such that there are as many details as possible. The coordinates of the faces are multiples of the
// spacing, or any if that is 0.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Error_code map_to_polycube_3(const Numbered_surface_3& surface, const std::vector<std::size_t>& labels, double spacing,
                             std::vector<Eigen::Vector3d>& images, const Budget& budget);

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE
// Proposes labels with more and more smoothing, and takes those whose map has the least distortion. Where the boundary
// is too coarse, faces for which there is no place are given to neighbouring charts.
inline Error_code map_to_proposed_polycube_3(const Boundary_mesh_3& mesh, const Eigen::AlignedBox3d& box,
                                             const double spacing, std::vector<Eigen::Vector3d>& images, const Budget& budget)
{
  Error_code status = ERROR_NO_POLYCUBE;
  double least_distortion = (std::numeric_limits<double>::infinity)();
  std::set<std::vector<std::size_t> > tried;
  for(double smoothing = 0.001; smoothing < 0.1 && !budget.is_exhausted(); smoothing *= 2)
  {
    Normal_labels_3 costs(mesh, smoothing, budget);
    std::vector<std::size_t> labels = costs.minimize();
    for(int attempt = 0; attempt < 10 && !budget.is_exhausted(); ++attempt)
    {
      if(!repair_labels_3(mesh, costs, labels, budget) || !tried.insert(labels).second)
        break;
      Polycube_map_3 map(mesh, box, labels, spacing, budget);
      const Error_code status_of_map = map.run();
      const double distortion = status_of_map == OK ? map.distortion() : least_distortion;
      if(status_of_map == OK && (status != OK || distortion < least_distortion))
      {
        images = map.images();
        least_distortion = distortion;
      }
      if(status_of_map == OK || status == ERROR_NO_POLYCUBE)
        status = status_of_map;
      if(!give_away_faces(mesh, map.flipped_faces(), costs, labels))
        break;
    }
  }
  return status;
}

inline Error_code map_mesh_to_polycube_3(const Boundary_mesh_3& mesh, const Eigen::AlignedBox3d& box,
                                         const std::vector<std::size_t>& labels, const double spacing,
                                         std::vector<Eigen::Vector3d>& images, const Budget& budget)
{
  if(labels.empty())
    return map_to_proposed_polycube_3(mesh, box, spacing, images, budget);
  Polycube_map_3 map(mesh, box, labels, spacing, budget);
  const Error_code status = map.run();
  if(status == OK)
    images = map.images();
  return status;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Error_code map_to_polycube_3(const Numbered_surface_3& surface, const std::vector<std::size_t>& labels,
                             const double spacing, std::vector<Eigen::Vector3d>& images, const Budget& budget)
{
  Boundary_mesh_3 mesh;
  Error_code status = build_boundary_mesh_3(surface, mesh);
  if(status != OK)
    return status;
  const Eigen::AlignedBox3d box = bounding_box(mesh);
  set_points(mesh, unit_points(mesh));
  status = map_mesh_to_polycube_3(mesh, box, labels, spacing, images, budget);
  std::vector<Eigen::Vector3d> any;
  if(status != OK && spacing > 0 && map_mesh_to_polycube_3(mesh, box, labels, 0, any, budget) == OK)
    return ERROR_SPACING_TOO_COARSE;
  return status;
}
#endif

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_MAP_TO_POLYCUBE_3_H
