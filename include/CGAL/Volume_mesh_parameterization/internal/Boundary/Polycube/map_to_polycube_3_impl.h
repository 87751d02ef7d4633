// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_MAP_TO_POLYCUBE_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_MAP_TO_POLYCUBE_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Normal_labels_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Polycube_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/map_to_polycube_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/repair_labels_3.h>

#include <Eigen/Dense>

#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Labels that cost little, with valid charts, for more and more smoothing; the best ones first.
inline std::vector<std::vector<std::size_t> > propose_labels_3(const Boundary_mesh_3& mesh)
{
  const Normal_labels_3 judge(mesh, 0.01);
  std::multimap<double, std::vector<std::size_t> > proposals;
  for(double smoothing = 0.001; smoothing < 0.1; smoothing *= 2)
  {
    Normal_labels_3 costs(mesh, smoothing);
    std::vector<std::size_t> labels = costs.minimize();
    if(repair_labels_3(mesh, costs, labels))
      proposals.emplace(judge.cost(labels), labels);
  }
  std::vector<std::vector<std::size_t> > result;
  for(const auto& [cost, labels] : proposals)
    if(result.empty() || result.back() != labels)
      result.push_back(labels);
  return result;
}

// Gives faces for which there is no place to neighbouring charts, a few times.
inline Error_code map_to_similar_polycube_3(const Boundary_mesh_3& mesh, const Eigen::AlignedBox3d& box,
                                            std::vector<std::size_t> labels, const double spacing,
                                            std::vector<Eigen::Vector3d>& images)
{
  const Normal_labels_3 costs(mesh, 0.01);
  Error_code status = ERROR_NO_POLYCUBE;
  for(int attempt = 0; attempt < 10; ++attempt)
  {
    Polycube_map_3 map(mesh, box, labels, spacing);
    status = map.run();
    if(status == OK)
      images = map.images();
    if(status == OK || !give_away_faces(mesh, map.flipped_faces(), costs, labels)
       || !repair_labels_3(mesh, costs, labels))
      break;
  }
  return status;
}

inline Error_code map_to_proposed_polycube_3(const Boundary_mesh_3& mesh, const Eigen::AlignedBox3d& box,
                                             const double spacing, std::vector<Eigen::Vector3d>& images)
{
  Error_code status = ERROR_NO_POLYCUBE;
  for(const std::vector<std::size_t>& labels : propose_labels_3(mesh))
  {
    const Error_code status_of_proposal = map_to_similar_polycube_3(mesh, box, labels, spacing, images);
    if(status_of_proposal == OK || status == ERROR_NO_POLYCUBE)
      status = status_of_proposal;
    if(status == OK)
      break;
  }
  return status;
}

inline Error_code map_mesh_to_polycube_3(const Boundary_mesh_3& mesh, const Eigen::AlignedBox3d& box,
                                         const std::vector<std::size_t>& labels, const double spacing,
                                         std::vector<Eigen::Vector3d>& images)
{
  if(labels.empty())
    return map_to_proposed_polycube_3(mesh, box, spacing, images);
  Polycube_map_3 map(mesh, box, labels, spacing);
  const Error_code status = map.run();
  if(status == OK)
    images = map.images();
  return status;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Error_code map_to_polycube_3(const Numbered_surface_3& surface, const std::vector<std::size_t>& labels,
                             const double spacing, std::vector<Eigen::Vector3d>& images)
{
  Boundary_mesh_3 mesh;
  Error_code status = build_boundary_mesh_3(surface, mesh);
  if(status != OK)
    return status;
  const Eigen::AlignedBox3d box = bounding_box(mesh);
  set_points(mesh, unit_points(mesh));
  status = map_mesh_to_polycube_3(mesh, box, labels, spacing, images);
  std::vector<Eigen::Vector3d> any;
  if(status != OK && spacing > 0 && map_mesh_to_polycube_3(mesh, box, labels, 0, any) == OK)
    return ERROR_SPACING_TOO_COARSE;
  return status;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_MAP_TO_POLYCUBE_3_IMPL_H
