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

#include <CGAL/Volume_mesh_parameterization/internal/Map/Soft_boundary_search_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Infeasibility/diagnose_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Input_check_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Staged_targets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/open_motions_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/untangle_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/minimize_map_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Does an energy not change if all singular values grow alike?
inline bool is_scale_invariant(const Cell_energy_3& energy)
{
  const Vector_3 s(1.1, 1, 0.9);
  const std::vector<double> psi = energies_of_cells_3({ s, 2 * s }, energy, 1);
  return std::abs(psi[1] - psi[0]) <= 1e-10 * std::abs(psi[0]);
}

// Moves an image as a whole, as far as conditions and energy leave that open, to where it is nearest to the source.
inline Found_map_3 nearest_to_source_3(const Numbered_mesh_3& mesh, const Map_problem_3& problem, Found_map_3 found)
{
  const Open_motions_3 motions(mesh, is_scale_invariant(problem.energy));
  const int number = motions.number(found.map.positions);
  if(number == 0)
    return found;
  if(Map_3 map = evaluated_map(mesh, snapped(mesh, motions.nearest_to_source(found.map.positions))); map.is_solution())
  {
    found.map = std::move(map);
    found.number_of_open_motions = number;
  }
  return found;
}

// Untangles with the prescribed vertices on their targets, and minimizes, unless vertices will slide in the boundary. If cells are
// too flat for the linear solver, their vertices move before all others.
inline Found_map_3 find_map_from_start_3(const Numbered_mesh_3& mesh, const Map_problem_3& problem, const Search_start_3& start)
{
  Newton_system_3 system(mesh, free_vertices(mesh), problem.solver);
  Found_map_3 found = untangle_mesh_3(system, start, problem.progress);
  if(are_some_in_boundary(mesh.sliding_conditions))
    return found;
  if(found.status == OK)
    found = minimize_map_3(system, problem, std::move(found));
  const auto are_cells_too_flat = [&] { return found.status == ERROR_LINEAR_SOLVER_FAILED && found.map.is_valid(); };
  constexpr int maximum_number_of_rounds = 3; // a guess
  for(int round = 0; round < maximum_number_of_rounds && are_cells_too_flat(); ++round)
  {
    found.map = evaluated_map(mesh, relaxed_flat_cells_3(mesh, problem.solver, found.map.positions, problem.progress.budget()));
    found = minimize_map_3(system, problem, std::move(found));
  }
  return found;
}

// Is a map of a body with free boundary missing, or crumpled, such that it may have a better minimum?
inline bool is_crumpled(const Numbered_mesh_3& mesh, const Found_map_3& found)
{
  constexpr double large_distortion = 3; // a guess
  return !found.map.is_solution() || largest_angle_distortion_3(mesh, found.map.positions) > large_distortion;
}

// Moves handles to their targets in stages, each from the last map. Returns nothing if a stage has no map. If there is a map
// without stages, none before the last one takes more steps than that did.
inline std::optional<Found_map_3> find_map_in_stages_3(const Numbered_mesh_3& mesh, const Map_problem_3& problem,
                                                       const bool has_map)
{
  constexpr double coarse = 0.1; // a guess for the tolerance of stages before the last one
  const Staged_targets_3 targets(mesh);
  const int number_of_stages = targets.number_of_stages();
  if(number_of_stages == 1)
    return std::nullopt;
  const std::size_t number_of_steps = problem.progress.effort().number_of_iterations;
  Progress_3 some_steps(problem.progress.budget(), number_of_steps, [&](const Parameterization_step& step)
  {
    problem.progress.after_step(step);
    return true;
  }, *mesh.communicator);
  std::optional<Found_map_3> found;
  for(int stage = 1; stage <= number_of_stages; ++stage)
  {
    const bool is_last = stage == number_of_stages;
    Numbered_mesh_3 at_stage = is_last ? mesh : targets.mesh_at(double(stage) / number_of_stages);
    at_stage.initial = found ? found->map.positions : moved(*mesh.alignment, mesh.source);
    Map_options_3 options = problem.options;
    if(!is_last)
      options.energy_tolerance = (std::max)(coarse, options.energy_tolerance);
    Progress_3& progress = has_map && !is_last ? some_steps : problem.progress;
    found = find_map_from_start_3(at_stage, { options, problem.energy, problem.solver, progress }, Search_start_3());
    if(!found->map.is_solution() || (problem.progress.is_interrupted() && !is_last))
      return std::nullopt;
  }
  found->untangling_method = "stages";
  return found;
}

// Finds a map with the prescribed vertices on their targets. If the map of a body with free boundary is crumpled, handles move in
// stages, and the map with less energy is taken.
inline Found_map_3 find_map_with_fixed_boundary_3(const Numbered_mesh_3& mesh, const Map_problem_3& problem,
                                                  const Search_start_3& start)
{
  Found_map_3 found = find_map_from_start_3(mesh, problem, start);
  if(!mesh.alignment || are_some_in_boundary(mesh.sliding_conditions))
    return found;
  const auto energy = [&](const Found_map_3& f) { return mean_energy_3(mesh, f.map.positions, problem.energy); };
  if(mesh.initial.cols() == 0 && start.stage == Search_start_3::Stage::NONE && is_crumpled(mesh, found))
  {
    const bool has_map = found.map.is_solution();
    const double seconds = problem.progress.effort().seconds_to_flip_free;
    if(std::optional<Found_map_3> staged = find_map_in_stages_3(mesh, problem, has_map); staged
       && (!has_map || energy(*staged) < energy(found)))
      found = std::move(*staged);
    if(has_map)
      problem.progress.reach_flip_free(seconds);
  }
  return found.map.is_solution() ? nearest_to_source_3(mesh, problem, std::move(found)) : found;
}

// Finds a map whose boundary approaches its targets, and inverts no cell from the beginning. As soon as the boundary can be put on
// its targets without an inverted cell, the minimization continues with fixed boundary.
inline Found_map_3 find_map_with_soft_boundary_3(const Numbered_mesh_3& mesh, const Map_problem_3& problem,
                                                 const Search_start_3& start)
{
  Progress_3& progress = problem.progress;
  Found_map_3 found;
  Search_start_3 at_targets;
  {
    Soft_boundary_search_3 search(mesh, problem.energy, problem.solver, problem.options.soft, mesh.constraints, start);
    progress.begin_stage();
    progress.begin_attempt("soft boundary");
    progress.reach_flip_free();
    progress.end_start();
    const auto step = [&]
    {
      search.step();
      return search.last_step();
    };
    found.status = search.is_running() ? progress.make_steps(true, step, [&] { return search.status(); })
                                         : *search.status();
    found.map = search.map();
    found.reason = search.reason();
    found.untangling_method = "soft boundary";
    found.number_of_raises = search.number_of_raises();
    if(found.status == OK && !found.map.meets_boundary)
    {
      found.status = OK_WITHIN_TOLERANCE;
      found.reason = sentence("If the target has volume 1, the norm of all residuals is ", search.residual(),
                              ", and the tolerance is ", problem.options.soft.residual_tolerance, ".");
    }
    if(search.can_snap() && !progress.is_interrupted())
      at_targets = { Search_start_3::Stage::UNTANGLING, search.snapped_positions(), "soft boundary" };
  }
  if(at_targets.stage == Search_start_3::Stage::UNTANGLING)
  {
    const std::size_t number_of_raises = found.number_of_raises;
    found = find_map_with_fixed_boundary_3(mesh, problem, at_targets);
    found.number_of_raises = number_of_raises;
  }
  return found;
}

// Calls the allowed stages one after the other. Decides alone whether the search was interrupted: it was if the limit of time
// has ended a loop, or if time is over and more is wanted.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Found_map_3 find_map_3(const Numbered_mesh_3& mesh, const Input_check_3& check, const Map_problem_3& problem,
                       const Search_start_3& start)
{
  const Boundary_mode mode = problem.options.mode;
  Progress_3& progress = problem.progress;
  Found_map_3 found;
  found.status = check.status;
  found.reason = check.message;
  if(check.allows_fixed_boundary() && mode != Boundary_mode::SOFT && start.stage != Search_start_3::Stage::SOFT_BOUNDARY)
    found = find_map_with_fixed_boundary_3(mesh, problem, start);
  if(found.status == ERROR_NOT_FLIP_FREE && !found.is_stuck() && mesh.is_whole())
    found.diagnosis = diagnose_3(mesh, found.map.inverted_cells, progress.budget());
  if(check.allows_soft_boundary() && mode != Boundary_mode::FIXED && !found.map.is_valid() && !found.is_stuck()
     && !progress.is_interrupted())
  {
    const Found_map_3 fixed = std::move(found);
    found = find_map_with_soft_boundary_3(mesh, problem, start);
    found.number_of_inverted_cells_at_start = fixed.number_of_inverted_cells_at_start;
    found.diagnosis = fixed.diagnosis;
  }
  if(found.map.is_solution() && found.status != ERROR_LINEAR_SOLVER_FAILED && problem.options.improve != nullptr)
    found = problem.options.improve(mesh, problem, std::move(found));
  const bool is_more_wanted = !found.map.is_valid() || (start.may_split && found.is_blocked());
  if(progress.has_ended_a_loop() || (is_more_wanted && progress.is_interrupted()))
  {
    found.status = ERROR_INTERRUPTED;
    found.reason.clear(); // of a stage that was ended
    found.splits = {};
  }
  return found;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_FIND_MAP_3_H
