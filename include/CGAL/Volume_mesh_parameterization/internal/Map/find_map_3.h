// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_FIND_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_FIND_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Boundary_approach_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Infeasibility/diagnose_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/check_input_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/find_splits_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/untangle_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/minimize_map_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The initial map with an image for each vertex: a prescribed vertex without one is on its target, and the others
// without one, as those that a refinement has inserted, are where they minimize the Dirichlet energy. No images at all if
// none are given.
inline Matrix3Xd completed_initial_map_3(const Numbered_mesh_3& mesh, Linear_solver_3& solver, Progress_3& progress)
{
  Matrix3Xd result = mesh.initial;
  const auto is_missing = [&](const int v) { return mesh.initial.col(v).array().isNaN().any(); };
  for(int v = 0; v < result.cols(); ++v)
    if(is_missing(v))
      result.col(v) = mesh.target.col(v);
  const Unknowns_3 unknowns(static_cast<int>(result.cols()), [&](const int v) { return mesh.is_free(v) && is_missing(v); });
  if(unknowns.size() == 0)
    return result;
  Newton_system_3 system(mesh, unknowns, solver);
  harmonic_map_3(system, result, progress);
  return result;
}

// Moves the prescribed vertices from these images of all to their targets, the others by the harmonic extension of the
// displacements, and untangles. One point for all becomes the harmonic map, which recovers affine maps. If it inverts
// cells, so may that with respect to regular cells, but mostly fewer, so that patches suffice.
inline void untangle_from_3(Newton_system_3& system, const Matrix3Xd& initial, const bool may_split,
                            Progress_3& progress, Found_map_3& found)
{
  const Numbered_mesh_3& mesh = system.mesh();
  constexpr double energy_tolerance = 1e-6; // of what is a start only
  progress.begin_stage();
  Matrix3Xd displacements = snapped(mesh, initial) - initial;
  const auto image = [&]() -> Matrix3Xd { return snapped(mesh, initial + displacements); };
  Newton_direction_3 direction = harmonic_map_3(system, displacements, progress, energy_tolerance);
  const Map_3 start = judged(mesh, image());
  found.number_of_inverted_cells_at_start = start.number_of_inverted_cells;
  if(direction.is_usable() && !start.is_valid() && !progress.is_interrupted())
  {
    system.set_references(true);
    direction = harmonic_map_3(system, displacements, progress, energy_tolerance);
  }
  progress.reach_flip_free();
  if(direction.is_usable())
    untangle_3(system, start, image(), may_split, progress, found);
  else if(progress.is_interrupted())
    found.take(ERROR_INTERRUPTED, "", start);
  else
    found.take(ERROR_LINEAR_SOLVER_FAILED, describe_failure(direction), start);
}

// Untangles and, unless vertices are going to slide anyway, minimizes: with the prescribed vertices on their targets.
// Goes on from the given images. If there are none, starts from the initial map, and where this fails or there is none
// either, from the harmonic map.
inline void find_map_with_fixed_boundary_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy,
                                           Linear_solver_3& solver, const Map_options_3& options,
                                           const Matrix3Xd& start, Progress_3& progress, Found_map_3& found)
{
  progress.begin_stage();
  const bool goes_on = start.cols() > 0, may_split = options.untangling.most_inverted_cells_to_split > 0;
  const Matrix3Xd initial = goes_on ? start : completed_initial_map_3(mesh, solver, progress);
  const Matrix3Xd one_point = mesh.base_point.replicate(1, mesh.number_of_vertices());
  const bool has_initial = !goes_on && initial.cols() > 0;
  Newton_system_3 system(mesh, free_vertices(mesh), solver);
  if(goes_on)
    untangle_on_3(system, start, progress, found);
  else
    untangle_from_3(system, has_initial ? initial : one_point, may_split, progress, found);
  // then the full Hessian is tried first
  const bool may_be_near_minimum = has_initial && found.status == OK && progress.number_of_steps() == 0;
  if(has_initial && found.status == ERROR_NOT_FLIP_FREE)
    untangle_from_3(system, one_point, may_split, progress, found);
  if(found.untangling_method.empty())
    found.untangling_method = goes_on ? "soft boundary" : "harmonic extension";
  if(found.status == OK && !options.do_slide)
    minimize_map_3(system, energy, options, progress, found, Negative_curvature(may_be_near_minimum ? 1 : 0));
}

// No inverted cell from the beginning: the boundary approaches its targets. As soon as it can be put
// there without inverting a cell, the minimization continues with fixed boundary.
inline void find_map_with_soft_boundary_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy,
                                          Linear_solver_3& solver, const Map_options_3& options, Progress_3& progress,
                                          Found_map_3& found)
{
  std::optional<Matrix3Xd> snapped_positions;
  {
    Boundary_approach_3 approach(mesh, energy, solver, options.soft, options.constraints, options.approach);
    progress.begin_stage();
    progress.begin_attempt("soft boundary");
    progress.reach_flip_free();
    progress.end_start();
    while(approach.is_running() && progress.goes_on())
    {
      approach.step();
      progress.after_step(approach.last_step());
    }
    found.take(approach.status().value_or(progress.status_of_end(true)), approach.reason(), approach.map());
    found.untangling_method = "soft boundary";
    found.number_of_raises = approach.number_of_raises();
    if(approach.can_snap() && progress.is_interrupted())
      found.status = ERROR_INTERRUPTED;
    else if(approach.can_snap())
      snapped_positions = approach.snapped_positions();
  }
  if(snapped_positions)
    find_map_with_fixed_boundary_3(mesh, energy, solver, options, *snapped_positions, progress, found);
}

// From numbered arrays to the images of their vertices, by the stages that are allowed, one after the other.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Found_map_3 find_map_3(const Numbered_mesh_3& mesh, const Input_check_3& check, const Cell_energy_3& energy,
                       Linear_solver_3& solver, const Map_options_3& options, Progress_3& progress)
{
  Found_map_3 found;
  found.status = check.status;
  found.reason = check.message;
  const bool goes_on = options.approach.positions.cols() > 0;
  if(check.allows_fixed_boundary() && options.mode != Boundary_mode::SOFT && !goes_on)
  {
    find_map_with_fixed_boundary_3(mesh, energy, solver, options, options.untangling.positions, progress, found);
    found.is_stuck = found.status == ERROR_NOT_FLIP_FREE
      && found.map.number_of_inverted_cells <= options.untangling.most_inverted_cells_to_split;
    if(found.is_stuck)
    {
      progress.begin_stage();
      progress.begin_attempt("splits");
      found.splits = find_splits_3(mesh, solver, found.map, progress);
    }
    else if(found.status == ERROR_NOT_FLIP_FREE && mesh.is_whole())
      found.diagnosis = diagnose_3(mesh, found.map.inverted_cells, progress.budget());
    if(found.status == ERROR_NOT_FLIP_FREE && progress.is_interrupted())
    {
      found.status = ERROR_INTERRUPTED;
      found.is_stuck = false;
    }
    if(found.is_stuck)
      return found;
  }
  const bool needs_soft_boundary
    = check.allows_soft_boundary() && options.mode != Boundary_mode::FIXED && !found.map.is_valid();
  if(needs_soft_boundary && progress.is_interrupted())
    found.status = ERROR_INTERRUPTED;
  else if(needs_soft_boundary)
    find_map_with_soft_boundary_3(mesh, energy, solver, options, progress, found);
  if(found.map.is_solution() && found.status != ERROR_LINEAR_SOLVER_FAILED && options.improve != nullptr)
    options.improve(mesh, energy, solver, options, progress, found);
  return found;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_FIND_MAP_3_H
