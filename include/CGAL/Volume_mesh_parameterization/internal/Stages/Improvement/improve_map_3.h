// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_IMPROVEMENT_IMPROVE_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_IMPROVEMENT_IMPROVE_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Scaled_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Sliding_boundary_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Improvement/bound_angle_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Improvement/minimize_angle_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Map_options_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Minimization_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Stage_3.h>

#include <cmath>
#include <optional>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// Goes on from a map that meets the boundary: vertices of planar patches slide, and the distortion of angles is bounded.
inline void improve_map_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy, Linear_solver_3& solver,
                          const Map_options_3& options, Progress_3& progress, Found_map_3& found)
{
  const double bound = options.maximal_angle_distortion;
  const auto exceeds_bound = [&]()
  {
    return std::isfinite(bound) && !(largest_angle_distortion_3(mesh, found.map.positions) < bound);
  };
  if(!options.do_slide && !options.minimize_maximal_angle_distortion && !exceeds_bound())
    return;
  std::optional<Sliding_boundary_3> sliding;
  if(options.do_slide)
  {
    sliding.emplace(mesh, [&](const int v) { return !options.is_held.empty() && options.is_held[v]; });
    found.number_of_sliding_vertices = sliding->number_of_sliding_vertices();
  }
  double begin = progress.seconds();
  const Scaled_cells_3 scaled = cells_scaled_to_target(mesh);
  Newton_system_3 system(mesh, scaled, sliding ? Unknowns_3(sliding->projectors()) : free_vertices(mesh), solver,
                         options.is_parallel);
  const auto minimize = [&](const Cell_energy_3& psi)
  {
    Minimization_3 minimization(system, psi, found.map.positions);
    const Error_code status = progress.run(minimization, begin);
    take_over(minimization, status, sliding ? judged(mesh, *sliding, sliding->restored(minimization.positions()))
                                            : judged(mesh, snapped(mesh, minimization.positions())), found);
    begin = progress.seconds();
  };
  if(sliding)
    minimize(energy);
  if(found.map.is_solution() && !progress.is_interrupted() && std::isfinite(bound))
    bound_angle_distortion_3(mesh, energy, bound, sliding.has_value(), minimize, progress, found);
  if(found.map.is_solution() && !progress.is_interrupted() && options.minimize_maximal_angle_distortion)
    minimize_angle_distortion_3(mesh, energy, sliding.has_value(), minimize, progress, found);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_IMPROVEMENT_IMPROVE_MAP_3_H
