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
#include <set>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Labels with valid charts, each once. The cheapest are taken first, whatever they were found with.
class Proposed_labels_3
{
public:
  using Labels = Normal_labels_3::Labels;

  explicit Proposed_labels_3(const Boundary_mesh_3& mesh) : m_costs(mesh, 0.01)
  {
    for(double smoothing = 0.001; smoothing < 0.1; smoothing *= 2)
    {
      Normal_labels_3 costs(mesh, smoothing);
      Labels labels = costs.minimize();
      if(repair_labels_3(mesh, costs, labels))
        insert(labels);
    }
  }

  const Normal_labels_3& costs() const { return m_costs; }
  bool empty() const { return m_waiting.empty(); }

  void insert(const Labels& labels)
  {
    if(m_all.insert(labels).second)
      m_waiting.emplace(m_costs.cost(labels), labels);
  }

  Labels take_cheapest()
  {
    const Labels result = m_waiting.begin()->second;
    m_waiting.erase(m_waiting.begin());
    return result;
  }

private:
  Normal_labels_3 m_costs;
  std::multimap<double, Labels> m_waiting;
  std::set<Labels> m_all;
};

// Where the boundary is too coarse, faces for which there is no place are given to neighbouring charts.
inline Error_code map_to_proposed_polycube_3(const Boundary_mesh_3& mesh, const Eigen::AlignedBox3d& box,
                                             const double spacing, std::vector<Eigen::Vector3d>& images)
{
  Proposed_labels_3 proposals(mesh);
  Error_code status = ERROR_NO_POLYCUBE;
  for(int attempt = 0; attempt < 50 && !proposals.empty(); ++attempt)
  {
    std::vector<std::size_t> labels = proposals.take_cheapest();
    Polycube_map_3 map(mesh, box, labels, spacing);
    const Error_code status_of_map = map.run();
    if(status_of_map == OK)
    {
      images = map.images();
      return OK;
    }
    if(status == ERROR_NO_POLYCUBE)
      status = status_of_map;
    if(give_away_faces(mesh, map.flipped_faces(), proposals.costs(), labels)
       && repair_labels_3(mesh, proposals.costs(), labels))
      proposals.insert(labels);
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
