// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_REFINE_AND_FIND_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_REFINE_AND_FIND_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Carried_search_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Simplex_removal_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3.h>

#include <iomanip>
#include <iostream>

namespace CGAL::Volume_mesh_parameterization::internal {

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE void print(const Parameterization_step& step)
{
  std::cout << std::setw(5) << step.iteration
            << (step.phase == Phase::UNTANGLING ? " untangling  " : " minimization")
            << "  energy " << std::setw(12) << step.energy
            << "  inverted " << std::setw(6) << step.number_of_inverted_cells
            << "  gradient " << std::setw(11) << step.gradient_norm
            << "  decrement " << std::setw(11) << step.decrement
            << "  step " << std::setw(9) << step.step_length
            << "  seconds " << step.seconds << "  " << step.attempt << std::endl;
}

// A body with its numbers, and what the check of these has found.
struct Checked_body_3
{
  Numbered_body_3 numbered;
  Input_check_3 check;

  Checked_body_3(const Body_3& body, const Prescription_3& prescription, const Map_problem_3& problem, const Budget& budget)
    : numbered(body.soup, prescribed_points(body, prescription.is_constrained), prescription.targets,
               problem.use_volume_weights, problem.is_parallel)
  {
    if(!prescription.initial.empty())
      numbered.mesh.initial = numbered.columns(prescription.initial);
    check = check_input_3(numbered.mesh, budget);
    problem.progress.end_numbering();
  }

  bool allows(const Boundary_mode mode) const
  { return check.allows_fixed_boundary() || (check.allows_soft_boundary() && mode != Boundary_mode::FIXED); }
};

// The stages that are allowed, one after the other.
inline Found_map_3 find_map_of_body_3(const Checked_body_3& body, const Prescription_3& prescription,
                                      const Map_problem_3& problem, const Untangling_start_3& untangling,
                                      const Approach_start_3& approach)
{
  const Numbered_body_3& numbered = body.numbered;
  if(problem.verbose)
    std::cout << numbered.mesh.cells.size() << " cells, " << numbered.points.size() << " vertices, "
              << numbered.mesh.number_of_free_vertices << " of them free; linear solver " << problem.solver.name()
              << std::endl;
  Map_options_3 options = problem.options;
  options.untangling = untangling;
  options.approach = approach;
  for(const Linear_constraint_3<std::size_t>& constraint : prescription.constraints)
  {
    options.constraints.emplace_back();
    options.constraints.back().value = constraint.value;
    for(const auto& term : constraint.terms)
      options.constraints.back().terms.push_back({ numbered.vertices[term.vertex], term.coefficient });
  }
  if(options.do_slide)
    for(const std::size_t p : numbered.points)
      options.is_held.push_back(prescription.is_constrained[p]);
  return find_map_3(numbered.mesh, body.check, problem.energy, problem.solver, options, problem.progress);
}

// Counts what the user has given.
inline Parameterization_result counted(Parameterization_result result, const Body_3& body)
{
  const auto number = [](const std::vector<bool>& is_point) { return std::count(is_point.begin(), is_point.end(), true); };
  result.number_of_vertices = number(used_points(body.soup.cells, body.soup.points.size()));
  result.number_of_cells = body.soup.cells.size();
  result.number_of_boundary_vertices = number(prescribed_points(body));
  return result;
}

// The result where the time was over before the numbering, which takes about as long as a step.
inline Parameterization_result interrupted_result(const Body_3& body, const Progress_3& progress)
{ return counted(refused_result(failed_check(ERROR_INTERRUPTED, get_error_message(ERROR_INTERRUPTED)), progress), body); }

// The result of a search, if there was one; writes the images of the points if they are a map.
inline Parameterization_result written_result(const Body_3& body, const Checked_body_3& checked,
                                              const Map_problem_3& problem, const std::optional<Found_map_3>& found,
                                              std::vector<std::array<double, 3> >& images)
{
  const auto& [numbered, check] = checked;
  Parameterization_result result
    = found ? make_result_3(numbered.mesh, check, *found, problem.energy, problem.solver, problem.progress)
            : refused_result(check, problem.progress);
  if(result.has_valid_map)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    images.assign(numbered.vertices.size(), { nan, nan, nan });
    for(std::size_t v = 0; v < numbered.points.size(); ++v)
      images[numbered.points[v]] = coordinates(found->map.positions.col(v));
    result.boundary_distortion = facet_distortion_3(body.boundary, [&](const std::size_t p) { return to_vector(body.soup.points[p]); },
                                                    [&](const std::size_t p) { return to_vector(images[p]); });
  }
  return counted(std::move(result), body);
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Parameterization_result parameterize_body_3(const Body_3& body, const Prescription_3& prescription,
                                            const Map_problem_3& problem, std::vector<std::array<double, 3> >& images)
{
  if(problem.progress.is_interrupted())
    return interrupted_result(body, problem.progress);
  const Checked_body_3 checked(body, prescription, problem, problem.progress.budget());
  Approach_start_3 approach;
  approach.patience = 2; // where nothing can be refined, larger weights get a chance
  std::optional<Found_map_3> found;
  if(checked.allows(problem.options.mode))
    found = find_map_of_body_3(checked, prescription, problem, Untangling_start_3(), approach);
  return written_result(body, checked, problem, found, images);
}

// From a body to the images of its points: refines it where the targets make cells degenerate, and then where a search was
// blocked, and searches again. More new points than a tenth would mean that this does not help; a small body may need many
// in proportion. What limits of time leave undone is refined no more.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Parameterization_result refine_and_parameterize_body_3(Body_3& body, Prescription_3 prescription,
                                                       const Map_problem_3& problem, std::vector<Insertion_3>& insertions,
                                                       std::vector<std::array<double, 3> >& images)
{
  if(problem.progress.is_interrupted())
    return interrupted_result(body, problem.progress);
  const Budget& budget = problem.progress.budget();
  std::size_t number_of_splits = 0;
  Carried_search_3 carried;
  for(bool is_first = true; ; is_first = false)
  {
    prescription.extend_to(body.soup.points.size());
    // later, there may be a map to be returned
    Checked_body_3 checked(body, prescription, problem, is_first ? budget : Budget());
    const auto take = [&](const std::vector<Insertion_3>& made)
    { insertions.insert(insertions.end(), made.begin(), made.end()); };
    if(is_first && checked.check.allows_soft_boundary() && checked.check.is_refinable)
    {
      take(remove_degenerate_simplices(body, prescription, budget));
      if(!insertions.empty())
        continue;
    }
    const std::size_t limit = (std::max)(checked.numbered.points.size() / 10, std::size_t(1000));
    const bool may_split = checked.check.is_refinable && number_of_splits <= limit;

    std::optional<Found_map_3> found;
    if(checked.allows(problem.options.mode))
    {
      found = find_map_of_body_3(checked, prescription, problem, carried.untangling_start(checked.numbered, may_split),
                                 carried.approach_start(checked.numbered, may_split ? 1 : 2));
      if(found->is_blocked() && may_split && budget.is_exhausted())
        found->status = ERROR_INTERRUPTED;
      else if(found->is_blocked() && may_split)
      {
        const Refinement_plan_3 plan = carried.plan(checked.numbered.mesh, *found);
        std::vector<std::array<std::size_t, 2> > edges;
        for(const auto& [v, w] : plan.edges)
          edges.push_back({ checked.numbered.points[v], checked.numbered.points[w] });
        const std::vector<Insertion_3> splits = split_edges_3(body, edges);
        number_of_splits += splits.size();
        take(splits);
        carried = Carried_search_3(checked.numbered, found->map.positions, splits, plan);
        if(!splits.empty() || found->is_stuck)
          continue;
      }
    }
    const bool is_refinable = checked.check.is_refinable;
    checked.check.is_refinable = false; // by more than what has been refined
    Parameterization_result result = written_result(body, checked, problem, found, images);
    if(!found && result.status == ERROR_PRESCRIBED_CELL_INVERTED && is_refinable && budget.is_exhausted())
      result.status = ERROR_INTERRUPTED;
    result.number_of_added_vertices = insertions.size();
    return result;
  }
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_REFINE_AND_FIND_MAP_3_H
