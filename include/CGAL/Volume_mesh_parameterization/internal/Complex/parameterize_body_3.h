// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PARAMETERIZE_BODY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PARAMETERIZE_BODY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Numbered_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Prescription_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/mistakes.h>

#include <CGAL/Named_function_parameters.h>

#include <iomanip>
#include <iostream>

namespace CGAL::Volume_mesh_parameterization::internal {

// Says what is going to be solved, and by which linear solver.
inline void print(const Numbered_mesh_3& mesh, const Linear_solver_3& solver)
{
  std::cout << mesh.cells.size() << " cells, " << mesh.number_of_vertices() << " vertices, "
            << mesh.number_of_free_vertices << " of them free; linear solver " << solver.name() << std::endl;
}

inline void print(const Parameterization_step& step)
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

// What is asked for, and with what means.
struct Map_problem_3
{
  Map_options_3 options;
  bool use_volume_weights;
  bool verbose;
  const Cell_energy_3& energy;
  Linear_solver_3& solver;
  Progress_3& progress;
};

// A body with its numbers, and what the check of these has found.
struct Checked_body_3
{
  Numbered_body_3 numbered;
  Input_check_3 check;

  Checked_body_3(const Body_3& body, const Prescription_3& prescription, const Map_problem_3& problem)
    : numbered(body.soup, prescribed_points(body, prescription.is_constrained), prescription.targets,
               problem.use_volume_weights)
  {
    if(!prescription.initial.empty())
      numbered.mesh.initial = numbered.columns(prescription.initial);
    check = check_input_3(numbered.mesh);
    problem.progress.end_numbering();
  }

  bool allows(const Boundary_mode mode) const
  {
    return check.allows_fixed_boundary() || (check.allows_soft_boundary() && mode != Boundary_mode::FIXED);
  }
};

// The stages that are allowed, one after the other.
inline Found_map_3 find_map_of_body_3(const Checked_body_3& body, const Prescription_3& prescription,
                                      const Map_problem_3& problem, const Untangling_start_3& untangling,
                                      const Approach_start_3& approach)
{
  const Numbered_body_3& numbered = body.numbered;
  if(problem.verbose)
    print(numbered.mesh, problem.solver);
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

// The result where the check does not allow a search, without counts.
inline Parameterization_result refused_result(const Input_check_3& check, const Progress_3& progress)
{
  Parameterization_result result;
  result.status = check.status;
  result.message = check.message;
  result.seconds_numbering = result.seconds_total = progress.seconds();
  return result;
}

// The result of a search, if there was one; writes the images of the points if they are a map.
inline Parameterization_result written_result(const Body_3& body, const Checked_body_3& checked,
                                              const Map_problem_3& problem, const std::optional<Found_map_3>& found,
                                              std::vector<std::array<double, 3> >& images)
{
  const auto& [numbered, check] = checked;
  Parameterization_result result
    = found ? make_result_3(numbered.mesh, check, *found, problem.energy, problem.solver, problem.progress)
            : refused_result(check, problem.progress);
  result.number_of_vertices = numbered.points.size();
  result.number_of_cells = numbered.mesh.cells.size();
  const std::vector<bool> is_on_boundary = prescribed_points(body);
  result.number_of_boundary_vertices = std::count(is_on_boundary.begin(), is_on_boundary.end(), true);
  if(result.has_valid_map)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    images.assign(numbered.vertices.size(), { nan, nan, nan });
    for(std::size_t v = 0; v < numbered.points.size(); ++v)
      images[numbered.points[v]] = coordinates(found->map.positions.col(v));
  }
  return result;
}

// From a body to the images of its points.
inline Parameterization_result parameterize_body_3(const Body_3& body, const Prescription_3& prescription,
                                                   const Map_problem_3& problem,
                                                   std::vector<std::array<double, 3> >& images)
{
  const Checked_body_3 checked(body, prescription, problem);
  Approach_start_3 approach;
  approach.patience = 2; // where nothing can be refined, larger weights get a chance
  std::optional<Found_map_3> found;
  if(checked.allows(problem.options.mode))
    found = find_map_of_body_3(checked, prescription, problem, Untangling_start_3(), approach);
  return written_result(body, checked, problem, found, images);
}

// Reads the named parameters that are not about vertices, and returns `run(problem)`.
template <typename ConcurrencyTag, typename NamedParameters, typename Run>
Parameterization_result run_problem(const NamedParameters& np, const Run& run,
                                    const Communicator_3& communicator = single_process())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;

  check_named_parameters<internal_np::boundary_map_t, internal_np::boundary_mode_t, internal_np::do_refine_t,
                         internal_np::do_slide_boundary_t, internal_np::energy_t, internal_np::energy_tolerance_t,
                         internal_np::initial_map_t, internal_np::maximal_angle_distortion_t,
                         internal_np::minimize_maximal_angle_distortion_t, internal_np::number_of_iterations_t,
                         internal_np::positional_constraints_t, internal_np::soft_boundary_parameters_t,
                         internal_np::solver_traits_t, internal_np::use_volume_weights_t, internal_np::verbose_t,
                         internal_np::vertex_is_constrained_t>(np);
  using Energy = typename internal_np::Lookup_named_param_def<
    internal_np::energy_t, NamedParameters, Stretch_energy_3>::type;
  const Energy energy = choose_parameter<Energy>(get_parameter(np, internal_np::energy));

  using Default_solver = Conjugate_gradient_solver_traits_3<ConcurrencyTag>;
  using Solver = Mutable_parameter<typename internal_np::Lookup_named_param_def<
    internal_np::solver_traits_t, NamedParameters, Default_solver>::reference>;
  Default_solver default_solver;
  Solver solver = choose_parameter(get_parameter_reference(np, internal_np::solver_traits), default_solver);

  Limits<NamedParameters> limits(np);
  const bool verbose = choose_parameter(get_parameter(np, internal_np::verbose), false);
  const auto after_step = [&](const Parameterization_step& step)
  {
    if(verbose)
      print(step);
    return limits.visitor().after_step(step);
  };
  const auto number_of_iterations = choose_parameter(get_parameter(np, internal_np::number_of_iterations), 1000);
  require(static_cast<double>(number_of_iterations) >= 0, "A number of iterations is not negative.");
  Progress_3 progress(limits.budget(), static_cast<std::size_t>(number_of_iterations), after_step, communicator);

  Map_options_3 options;
  options.mode = choose_parameter(get_parameter(np, internal_np::boundary_mode), Boundary_mode::AUTO);
  options.soft = choose_parameter(get_parameter(np, internal_np::soft_boundary_parameters),
                                  options.mode == Boundary_mode::SOFT ? Soft_boundary_parameters()
                                                                      : approaching_soft_boundary_parameters());
  options.do_slide = choose_parameter(get_parameter(np, internal_np::do_slide_boundary), false);
  options.energy_tolerance = choose_parameter(get_parameter(np, internal_np::energy_tolerance), options.energy_tolerance);
  options.minimize_maximal_angle_distortion
    = choose_parameter(get_parameter(np, internal_np::minimize_maximal_angle_distortion), false);
  options.maximal_angle_distortion = choose_parameter(get_parameter(np, internal_np::maximal_angle_distortion),
                                                      (std::numeric_limits<double>::infinity)());
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::do_slide_boundary_t>::value
               || !parameters::is_default_parameter<NamedParameters, internal_np::maximal_angle_distortion_t>::value
               || !parameters::is_default_parameter<NamedParameters, internal_np::minimize_maximal_angle_distortion_t>::value)
    options.improve = &improve_map_3;
  options.is_parallel = is_parallel<ConcurrencyTag>();
  require(options.energy_tolerance >= 0, "A tolerance of the energy is not negative.");
  require(options.maximal_angle_distortion > 2, "A bound of the distortion of angles is larger than 2.");

  const Cell_energy_3& cell_energy = cell_energy_3(energy);
  Linear_solver_of<std::remove_reference_t<Solver> > linear_solver(solver);
  const Map_problem_3 problem = { options, choose_parameter(get_parameter(np, internal_np::use_volume_weights), false),
                                  verbose, cell_energy, linear_solver, progress };
  return run(problem);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PARAMETERIZE_BODY_3_H
