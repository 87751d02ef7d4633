// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MAP_SEARCH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MAP_SEARCH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Map_options_3.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// What the stages have come to.
struct Found_map_3
{
  Map_3 map;
  Error_code status = ERROR_NOT_CONVERGED;
  std::string reason;                   // for the status; empty if there is nothing to add
  std::string untangling_method;        // that has found the first map
  std::size_t number_of_sliding_vertices = 0;
  std::size_t number_of_inverted_cells_at_start = 0;
  bool is_stuck = false;                // with so few inverted cells that they are to be split
  std::vector<std::array<int, 2> > splits; // edges, if some were found with which fewer cells stay inverted
  std::optional<Diagnosis_3> diagnosis; // why there is no map with fixed boundary
  std::size_t number_of_raises = 0;     // of the weight of the soft boundary
  double unavoidable_angle_distortion = 0; // forced by the prescribed vertices; known where the largest one is minimized
  double missed_angle_distortion = 0;      // the largest bound that was not reached

  void take(const Error_code status_of_map, const std::string& reason_of_status, Map_3 found_map)
  {
    status = status_of_map;
    reason = reason_of_status;
    map = std::move(found_map);
  }

  // Is there a map, but not with the prescribed boundary, although nothing has interrupted the search?
  bool is_blocked() const
  {
    return is_stuck || status == ERROR_BOUNDARY_NOT_REACHED || (status == ERROR_NOT_CONVERGED && !map.meets_boundary);
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MAP_SEARCH_3_H
