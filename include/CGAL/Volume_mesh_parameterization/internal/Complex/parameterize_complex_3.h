// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PARAMETERIZE_COMPLEX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PARAMETERIZE_COMPLEX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Engine/engine.h>
#include <CGAL/Volume_mesh_parameterization/internal/mistakes.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

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

// What is asked for, and with what means: the engine's options, and what depends on the type of the complex.
template <typename Vertex, typename VertexIsConstrainedMap, typename BoundaryMap>
struct Complex_problem_3
{
  VertexIsConstrainedMap is_constrained;
  BoundaryMap target;
  std::function<Eigen::Vector3d(const Vertex&)> initial; // image of a vertex to start from; empty if there are none
  std::vector<Linear_constraint_3<Vertex> > constraints;
  Map_options_3 options;
  bool use_volume_weights;
  bool verbose;
  const Cell_energy_3& energy;
  Linear_solver_3& solver;
  Progress_3& progress;
};

// A complex or a soup with its numbers, and what the check of these has found.
template <typename Numbered>
struct Checked_complex_3
{
  Numbered numbered;
  Input_check_3 check;

  template <typename Mesh, typename Problem>
  Checked_complex_3(const Mesh& mesh, const Problem& problem)
    : numbered(mesh, problem.is_constrained, problem.target, problem.use_volume_weights)
  {
    if(problem.initial)
      numbered.set_initial(problem.initial);
    check = check_input_3(numbered.mesh());
    problem.progress.end_numbering();
  }

  bool allows(const Boundary_mode mode) const
  {
    return check.allows_fixed_boundary() || (check.allows_soft_boundary() && mode != Boundary_mode::FIXED);
  }
};

// The stages that are allowed, one after the other.
template <typename Numbered, typename Problem>
Found_map_3 find_map_of_complex_3(const Checked_complex_3<Numbered>& complex, const Problem& problem,
                                  const Untangling_start_3& untangling, const Approach_start_3& approach)
{
  const Numbered& numbered = complex.numbered;
  if(problem.verbose)
    print(numbered.mesh(), problem.solver);
  Map_options_3 options = problem.options;
  options.untangling = untangling;
  options.approach = approach;
  options.constraints = numbered.constraints(problem.constraints);
  if(options.do_slide)
    for(const auto v : numbered.vertices())
      options.is_held.push_back(get(problem.is_constrained, v));
  return find_map_3(numbered.mesh(), complex.check, problem.energy, problem.solver, options, problem.progress);
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

// The result of a search, if there was one; writes the images of the vertices if they are a map.
template <typename Numbered, typename Problem, typename Images>
Parameterization_result written_result(const Checked_complex_3<Numbered>& complex, const Problem& problem,
                                       const std::optional<Found_map_3>& found, Images& images)
{
  const auto& [numbered, check] = complex;
  Parameterization_result result
    = found ? make_result_3(numbered.mesh(), check, *found, problem.energy, problem.solver, problem.progress)
            : refused_result(check, problem.progress);
  result.number_of_vertices = numbered.vertices().size();
  result.number_of_cells = numbered.mesh().cells.size();
  result.number_of_boundary_vertices = numbered.number_of_boundary_vertices();
  if(result.has_valid_map)
    numbered.write(found->map.positions, images);
  return result;
}

// From a complex to the images of its vertices.
template <typename Numbered, typename Mesh, typename Problem, typename Images>
Parameterization_result parameterize_complex_3(const Mesh& mesh, const Problem& problem, Images& images)
{
  const Checked_complex_3<Numbered> complex(mesh, problem);
  Approach_start_3 approach;
  approach.patience = 2; // where nothing can be refined, larger weights get a chance
  std::optional<Found_map_3> found;
  if(complex.allows(problem.options.mode))
    found = find_map_of_complex_3(complex, problem, Untangling_start_3(), approach);
  return written_result(complex, problem, found, images);
}

// Reads the named parameters that do not depend on where the cells come from, and returns `run(problem)`.
template <typename ConcurrencyTag, typename Vertex, typename NamedParameters, typename BoundaryMap, typename Run>
Parameterization_result run_problem(const NamedParameters& np, const BoundaryMap& boundary_map, const Run& run,
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
  const auto is_constrained = choose_parameter(get_parameter(np, internal_np::vertex_is_constrained),
                                               Static_boolean_property_map<Vertex, false>());

  std::function<Eigen::Vector3d(const Vertex&)> initial;
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::initial_map_t>::value)
  {
    const auto initial_map = get_parameter(np, internal_np::initial_map);
    static_assert(Is_map_of<std::remove_const_t<decltype(initial_map)>, Vertex>::value,
                  "initial_map must be a property map of vertices: for a container, pass make_vertex_point_map(container).");
    initial = [initial_map](const Vertex& v) { return to_vector(get(initial_map, v)); };
  }

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
  const Complex_problem_3<Vertex, std::remove_const_t<decltype(is_constrained)>, BoundaryMap> problem = {
    is_constrained, boundary_map, initial,
    choose_parameter(get_parameter(np, internal_np::positional_constraints),
                     std::vector<Linear_constraint_3<Vertex> >()),
    options, choose_parameter(get_parameter(np, internal_np::use_volume_weights), false), verbose,
    cell_energy, linear_solver, progress
  };
  return run(problem);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PARAMETERIZE_COMPLEX_3_H
