// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_IMPROVEMENT_MINIMIZE_ANGLE_DISTORTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_IMPROVEMENT_MINIMIZE_ANGLE_DISTORTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/measure_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/unavoidable_angle_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Improvement/bound_angle_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Progress_3.h>

#include <cmath>

namespace CGAL::Volume_mesh_parameterization::internal {

// The least bound of the distortion of angles, by bisection between what the prescribed vertices force and what the map
// has. A map below one bound is the start for the next one; after a vain attempt, the search goes on from the best map.
template <typename Minimize>
void minimize_angle_distortion_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy, const bool is_sliding,
                                 const Minimize& minimize, const Progress_3& progress, Found_map_3& found)
{
  constexpr double precision = 0.02; // relative
  found.unavoidable_angle_distortion = is_sliding ? 2 : unavoidable_angle_distortion_3(mesh);
  found.missed_angle_distortion = found.unavoidable_angle_distortion;
  double reached = largest_angle_distortion_3(mesh, found.map.positions);
  while(reached > (1 + precision) * found.missed_angle_distortion && !progress.is_interrupted())
  {
    const Found_map_3 best = found;
    const double bound = std::sqrt(found.missed_angle_distortion * reached);
    bound_angle_distortion_3(mesh, energy, bound, is_sliding, minimize, progress, found);
    const double largest = found.map.is_solution() ? largest_angle_distortion_3(mesh, found.map.positions) : reached;
    if(largest < bound)
      reached = largest;
    else
    {
      const Error_code status = found.status;
      found = best;
      if(progress.is_interrupted())
        found.status = status;
      else
        found.missed_angle_distortion = bound;
    }
  }
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_IMPROVEMENT_MINIMIZE_ANGLE_DISTORTION_3_H
