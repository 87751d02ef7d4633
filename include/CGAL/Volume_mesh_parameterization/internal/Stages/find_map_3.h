// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_FIND_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_FIND_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_mode.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/diagnose_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Input_check_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Scaled_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Boundary_approach_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Map_options_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Minimization_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Stage_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling_3.h>

#include <optional>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// Untangles and, unless vertices are going to slide anyway, minimizes: with the prescribed vertices on their targets.
// Starts from the harmonic map, or from the given images.
inline void find_map_with_fixed_boundary_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy,
                                           Linear_solver_3& solver, const Map_options_3& options,
                                           const Eigen::Matrix3Xd* const start, Progress_3& progress,
                                           Found_map_3& found)
{
  const double begin = progress.seconds();
  const Scaled_cells_3 scaled = cells_scaled_to_target(mesh);
  Newton_system_3 system(mesh, scaled, free_vertices(mesh), solver, options.is_parallel);
  Untangling_3 untangling = start == nullptr ? Untangling_3(mesh, system) : Untangling_3(mesh, system, *start);
  if(start == nullptr)
  {
    progress.reach_flip_free();
    found.number_of_inverted_cells_at_start = untangling.number_of_inverted_cells_at_start();
  }
  const Error_code status = progress.run(untangling, begin);
  if(status != OK || options.do_slide)
  {
    take_over(untangling, status, judged(mesh, untangling.positions()), found);
    return;
  }
  Minimization_3 minimization(system, energy, untangling.positions());
  const Error_code end = progress.run(minimization, progress.seconds(), untangling.last_step().iteration);
  take_over(minimization, end, judged(mesh, snapped(mesh, minimization.positions())), found);
}

// No inverted cell from the beginning: the boundary approaches its targets. As soon as it can be put
// there without inverting a cell, the minimization continues with fixed boundary.
inline void find_map_with_soft_boundary_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy,
                                          Linear_solver_3& solver, const Map_options_3& options, Progress_3& progress,
                                          Found_map_3& found)
{
  std::optional<Eigen::Matrix3Xd> snapped_positions;
  {
    const double begin = progress.seconds();
    Boundary_approach_3 approach(mesh, energy, solver, options.is_parallel, options.soft, options.constraints,
                                 options.approach);
    progress.reach_flip_free();
    const Error_code status = progress.run(approach, begin);
    take_over(approach, status, judged(mesh, approach.positions()), found);
    found.number_of_raises = approach.number_of_raises();
    if(approach.can_snap() && !progress.is_interrupted())
      snapped_positions = approach.snapped_positions();
  }
  if(snapped_positions)
    find_map_with_fixed_boundary_3(mesh, energy, solver, options, &*snapped_positions, progress, found);
}

// From numbered arrays to the images of their vertices, by the stages that are allowed, one after the other.
inline Found_map_3 find_map_3(const Numbered_mesh_3& mesh, const Input_check_3& check, const Cell_energy_3& energy,
                              Linear_solver_3& solver, const Map_options_3& options, Progress_3& progress)
{
  Found_map_3 found;
  found.status = check.status;
  found.reason = check.message;
  const bool goes_on = options.approach.positions.cols() > 0;
  if(check.allows_fixed_boundary() && options.mode != Boundary_mode::SOFT && !goes_on)
  {
    find_map_with_fixed_boundary_3(mesh, energy, solver, options, nullptr, progress, found);
    if(found.status == ERROR_NOT_FLIP_FREE)
      found.diagnosis = diagnose_3(mesh, found.map.positions);
  }
  if(check.allows_soft_boundary() && options.mode != Boundary_mode::FIXED && !found.map.is_valid()
     && !progress.is_interrupted())
    find_map_with_soft_boundary_3(mesh, energy, solver, options, progress, found);
  if(found.map.is_solution() && found.status != ERROR_LINEAR_SOLVER_FAILED && !progress.is_interrupted()
     && options.improve != nullptr)
    options.improve(mesh, energy, solver, options, progress, found);
  return found;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_FIND_MAP_3_H
