// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_RUN_PROBLEM_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_RUN_PROBLEM_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Limits.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/parameterize_complex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/require.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

namespace CGAL::Volume_mesh_parameterization::internal {

// Tells what is no property map, and whether a map takes what is put into it, for errors of the compiler that can be
// read.
template <typename Map, typename = void>
struct Is_property_map : std::false_type {};

template <typename Map>
struct Is_property_map<Map, std::void_t<typename boost::property_traits<Map>::value_type> > : std::true_type {};

template <typename Map, typename Value, typename = void>
struct Can_hold : std::false_type {};

template <typename Map, typename Value>
struct Can_hold<Map, Value, std::void_t<typename boost::property_traits<Map>::value_type> >
  : std::is_convertible<Value, typename boost::property_traits<Map>::value_type>
{};

// Reads the named parameters that do not depend on where the cells come from, and returns `run(problem)`.
template <typename ConcurrencyTag, typename Vertex, typename NamedParameters, typename BoundaryMap, typename Run>
Parameterization_result run_problem(const NamedParameters& np, const BoundaryMap& boundary_map, const Run& run,
                                    const Communicator_3& communicator = single_process())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;

  const auto is_constrained = choose_parameter(get_parameter(np, internal_np::vertex_is_constrained),
                                               Static_boolean_property_map<Vertex, false>());

  std::function<Eigen::Vector3d(const Vertex&)> initial;
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::initial_map_t>::value)
  {
    const auto initial_map = get_parameter(np, internal_np::initial_map);
    static_assert(Is_property_map<std::remove_const_t<decltype(initial_map)> >::value,
                  "initial_map must be a property map: for a container, pass make_vertex_point_map(container).");
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
  options.minimize_maximal_angle_distortion
    = choose_parameter(get_parameter(np, internal_np::minimize_maximal_angle_distortion), false);
  options.maximal_angle_distortion = choose_parameter(get_parameter(np, internal_np::maximal_angle_distortion),
                                                      (std::numeric_limits<double>::infinity)());
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::do_slide_boundary_t>::value
               || !parameters::is_default_parameter<NamedParameters, internal_np::maximal_angle_distortion_t>::value
               || !parameters::is_default_parameter<NamedParameters, internal_np::minimize_maximal_angle_distortion_t>::value)
    options.improve = &engine::improve_map;
  options.is_parallel = is_parallel<ConcurrencyTag>();
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

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_RUN_PROBLEM_H
