// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PARAMETERIZE_BODY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PARAMETERIZE_BODY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/check_derivatives.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Map_problem_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <cmath>
#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// The seam of the map: all between arrays and the images of points. It knows no complex, an energy only as `Cell_energy_3`, and
// a solver only as `Linear_solver_3`, so that it can be compiled once.

// Maps a body: finds the images of its points. Whoever moves the body there does not keep a second copy of the cells.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Parameterization_result parameterize_body_3(Body_3 body, const Prescription_3& prescription, const Map_problem_3& problem,
                                            std::vector<std::array<double, 3> >& images);

// Maps a body and refines it; the insertions are appended as they are made.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Parameterization_result refine_and_parameterize_body_3(Body_3& body, Prescription_3 prescription,
                                                       const Map_problem_3& problem, std::vector<Insertion_3>& insertions,
                                                       std::vector<std::array<double, 3> >& images);

// Returns the distortion of the map from the points of a soup to images.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Distortion_3 distortion_of_soup_3(const Tetrahedron_soup_3& soup, const std::vector<std::array<double, 3> >& images);

// A line of `verbose`.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE void print(const Parameterization_step& step);

// Prints which derivatives of the energy are wrong. An energy that is not finite where it is tried cannot be compared.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE void print(const Derivative_errors_3& errors);

// Reads the named parameters that are not about vertices, and returns `run(problem)`.
template <typename ConcurrencyTag, typename NamedParameters, typename Run>
Parameterization_result run_problem(const NamedParameters& np, const Run& run,
                                    const Communicator_3& communicator = single_process())
{
  check_named_parameters<internal_np::boundary_map_t, internal_np::boundary_mode_t, internal_np::boundary_parameterizer_t,
                         internal_np::do_slide_boundary_t, internal_np::energy_t, internal_np::energy_tolerance_t,
                         internal_np::initial_map_t, internal_np::maximum_angle_distortion_t,
                         internal_np::number_of_iterations_t,
                         internal_np::positional_constraints_t, internal_np::refinement_mode_t,
                         internal_np::soft_boundary_parameters_t,
                         internal_np::solver_traits_t, internal_np::use_regular_references_t, internal_np::use_volume_weights_t,
                         internal_np::verbose_t, internal_np::vertex_condition_t,
                         internal_np::vertex_is_constrained_t>(np);
  using Energy = typename internal_np::Lookup_named_param_def<
    internal_np::energy_t, NamedParameters, Stretch_energy_3>::type;
  const Energy energy = parameters::choose_parameter<Energy>(parameters::get_parameter(np, internal_np::energy));

  using Default_solver = Conjugate_gradient_solver_traits_3<ConcurrencyTag>;
  using Solver = Mutable_parameter<typename internal_np::Lookup_named_param_def<
    internal_np::solver_traits_t, NamedParameters, Default_solver>::reference>;
  Default_solver default_solver;
  Solver solver
    = parameters::choose_parameter(parameters::get_parameter_reference(np, internal_np::solver_traits), default_solver);

  Limits<NamedParameters> limits(np);
  Map_options_3 options;
  options.verbose = parameter_or(np, internal_np::verbose, false);
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::verbose_t>::value)
    if(options.verbose)
      print(check_derivatives(energy));
  const auto after_step = [&](const Parameterization_step& step)
  {
    if(options.verbose)
      print(step);
    return limits.visitor().after_step(step);
  };
  const auto number_of_iterations = parameter_or(np, internal_np::number_of_iterations, 1000);
  const double number = static_cast<double>(number_of_iterations);
  require(number >= 0 && std::isfinite(number), "number_of_iterations must be finite and not negative.");
  constexpr std::size_t largest = (std::numeric_limits<std::size_t>::max)();
  Progress_3 progress(limits.budget(),
                      number < static_cast<double>(largest) ? static_cast<std::size_t>(number_of_iterations) : largest,
                      after_step, communicator);

  options.mode = parameter_or(np, internal_np::boundary_mode, Boundary_mode::AUTO);
  options.soft = parameter_or(np, internal_np::soft_boundary_parameters,
    options.mode == Boundary_mode::SOFT ? Soft_boundary_parameters() : approaching_soft_boundary_parameters());
  options.refinement = parameter_or(np, internal_np::refinement_mode, options.refinement);
  options.do_slide = parameter_or(np, internal_np::do_slide_boundary, options.do_slide);
  options.use_volume_weights = parameter_or(np, internal_np::use_volume_weights, options.use_volume_weights);
  options.use_regular_references = parameter_or(np, internal_np::use_regular_references, options.use_regular_references);
  if(options.use_regular_references)
    options.mode = Boundary_mode::FIXED; // a soft boundary starts from the source
  options.is_parallel = is_parallel<ConcurrencyTag>();
  options.energy_tolerance = parameter_or(np, internal_np::energy_tolerance, options.energy_tolerance);
  const double bound = parameter_or(np, internal_np::maximum_angle_distortion, options.maximum_angle_distortion);
  require(bound >= least_angle_distortion, "maximum_angle_distortion must be least_angle_distortion, which is 2, or larger.");
  options.minimize_maximum_angle_distortion = bound == least_angle_distortion;
  if(!options.minimize_maximum_angle_distortion)
    options.maximum_angle_distortion = bound;
  if constexpr(has_conditions<NamedParameters>
               || !parameters::is_default_parameter<NamedParameters, internal_np::do_slide_boundary_t>::value
               || !parameters::is_default_parameter<NamedParameters, internal_np::maximum_angle_distortion_t>::value)
    options.improve = &slide_and_bound_angles_3;
  require(options.energy_tolerance >= 0, "energy_tolerance must not be negative.");
  require(options.soft.weight > 0 && std::isfinite(options.soft.weight),
          "weight of soft_boundary_parameters must be positive and finite.");
  require(options.soft.weight_factor > 1 && std::isfinite(options.soft.weight_factor),
          "weight_factor of soft_boundary_parameters must be finite and larger than 1.");
  for(const double tolerance : { options.soft.residual_tolerance, options.soft.energy_tolerance,
                                 options.soft.relative_energy_tolerance, options.soft.step_tolerance,
                                 options.soft.gradient_tolerance })
    require(tolerance >= 0, "The tolerances of soft_boundary_parameters must not be negative.");

  const Cell_energy_3& cell_energy = cell_energy_3(energy);
  Linear_solver_of<std::remove_reference_t<Solver> > linear_solver(solver);
  return run(Map_problem_3{ options, cell_energy, linear_solver, progress });
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PARAMETERIZE_BODY_3_H
