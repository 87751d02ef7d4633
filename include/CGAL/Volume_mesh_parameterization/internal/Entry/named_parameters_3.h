// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENTRY_NAMED_PARAMETERS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENTRY_NAMED_PARAMETERS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <CGAL/property_map.h>

#include <cmath>
#include <limits>
#include <unordered_map>

// The only place that reads the named parameters of a map.
namespace CGAL::Volume_mesh_parameterization::internal {

template <typename NamedParameters>
constexpr bool has_conditions = !parameters::is_default_parameter<NamedParameters, internal_np::vertex_condition_t>::value;

// Returns the points that are vertices of cells.
inline std::vector<std::size_t> points_of_cells(const Body_3& body)
{
  const std::vector<bool> has_cell = used_points(body.cells, body.points.size());
  std::vector<std::size_t> result;
  for(std::size_t p = 0; p < has_cell.size(); ++p)
    if(has_cell[p])
      result.push_back(p);
  return result;
}

// Reads the named parameters of a map that are not about vertices.
template <typename ConcurrencyTag, typename NamedParameters>
Map_options_3 map_options_3(const NamedParameters& np)
{
  Map_options_3 options;
  options.verbose = parameter_or(np, internal_np::verbose, false);
  options.mode = parameter_or(np, internal_np::boundary_mode, Boundary_mode::AUTO);
  options.soft = parameter_or(np, internal_np::soft_boundary_parameters,
    options.mode == Boundary_mode::SOFT ? Soft_boundary_parameters() : approaching_soft_boundary_parameters());
  options.refinement = parameter_or(np, internal_np::refinement_mode, options.refinement);
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::reference_scale_t>::value)
    options.reference_scale = parameters::get_parameter(np, internal_np::reference_scale);
  const double scale = options.reference_scale.value_or(found_reference_scale);
  require(scale == found_reference_scale || (scale > 0 && std::isfinite(scale)),
          "reference_scale must be positive and finite, or found_reference_scale.");
  options.use_volume_weights = parameter_or(np, internal_np::use_volume_weights, options.use_volume_weights);
  options.use_regular_references = parameter_or(np, internal_np::use_regular_references, options.use_regular_references);
  if(options.use_regular_references)
    options.mode = Boundary_mode::FIXED; // a soft boundary starts from the source
  options.is_parallel = is_parallel<ConcurrencyTag>();
  options.energy_tolerance = parameter_or(np, internal_np::energy_tolerance, options.energy_tolerance);
  const double bound = parameter_or(np, internal_np::maximum_angle_distortion, options.maximum_angle_distortion);
  options.minimize_maximum_angle_distortion = bound == least_angle_distortion;
  if(!options.minimize_maximum_angle_distortion)
    options.maximum_angle_distortion = bound;
  if constexpr(has_conditions<NamedParameters>
               || !parameters::is_default_parameter<NamedParameters, internal_np::do_slide_boundary_t>::value
               || !parameters::is_default_parameter<NamedParameters, internal_np::maximum_angle_distortion_t>::value)
    options.improve = &slide_and_bound_angles_3;
  require(options.energy_tolerance >= 0, "energy_tolerance must not be negative.");
  require(bound >= least_angle_distortion, "maximum_angle_distortion must be least_angle_distortion, which is 2, or larger.");
  require(options.soft.weight > 0 && std::isfinite(options.soft.weight),
          "weight of soft_boundary_parameters must be positive and finite.");
  require(options.soft.weight_factor > 1 && std::isfinite(options.soft.weight_factor),
          "weight_factor of soft_boundary_parameters must be finite and larger than 1.");
  for(const double tolerance : { options.soft.residual_tolerance, options.soft.energy_tolerance,
                                 options.soft.relative_energy_tolerance, options.soft.step_tolerance,
                                 options.soft.gradient_tolerance })
    require(tolerance >= 0, "The tolerances of soft_boundary_parameters must not be negative.");
  return options;
}

// Returns the maximal number of Newton steps of each stage.
template <typename NamedParameters>
std::size_t number_of_iterations_3(const NamedParameters& np)
{
  const auto number_of_iterations = parameter_or(np, internal_np::number_of_iterations, 1000);
  const double number = static_cast<double>(number_of_iterations);
  require(number >= 0 && std::isfinite(number), "number_of_iterations must be finite and not negative.");
  constexpr std::size_t largest = (std::numeric_limits<std::size_t>::max)();
  return number < static_cast<double>(largest) ? static_cast<std::size_t>(number_of_iterations) : largest;
}

// The problem of a map that named parameters describe, with what it refers to: energy, solver and limits. The time begins here.
template <typename ConcurrencyTag, typename NamedParameters>
class Named_problem_3
{
public:
  explicit Named_problem_3(const NamedParameters& np, const Communicator_3& communicator = single_process())
    : m_options(map_options_3<ConcurrencyTag>(np)),
      m_energy(parameters::choose_parameter<Energy>(parameters::get_parameter(np, internal_np::energy))),
      m_cell_energy(cell_energy_3(m_energy)),
      m_solver(parameters::choose_parameter(parameters::get_parameter_reference(np, internal_np::solver_traits),
                                            m_default_solver)),
      m_linear_solver(m_solver), m_limits(np),
      m_progress(m_limits.budget(), number_of_iterations_3(np),
                 [this](const Parameterization_step& step) { return after_step(step); }, communicator)
  {
    check_named_parameters<internal_np::boundary_map_t, internal_np::boundary_mode_t, internal_np::boundary_parameterizer_t,
                           internal_np::do_slide_boundary_t, internal_np::energy_t, internal_np::energy_tolerance_t,
                           internal_np::initial_map_t, internal_np::maximum_angle_distortion_t,
                           internal_np::number_of_iterations_t, internal_np::positional_constraints_t,
                           internal_np::reference_scale_t, internal_np::refinement_mode_t, internal_np::soft_boundary_parameters_t,
                           internal_np::solver_traits_t, internal_np::use_regular_references_t,
                           internal_np::use_volume_weights_t, internal_np::verbose_t, internal_np::vertex_condition_t,
                           internal_np::vertex_is_constrained_t>(np);
    if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::verbose_t>::value)
      if(m_options.verbose)
        print(check_derivatives(m_energy));
  }

  Named_problem_3(const Named_problem_3&) = delete;
  Named_problem_3& operator=(const Named_problem_3&) = delete;

  Map_problem_3 problem() { return { m_options, m_cell_energy, m_linear_solver, m_progress }; }

private:
  using Energy = typename internal_np::Lookup_named_param_def<internal_np::energy_t, NamedParameters, Stretch_energy_3>::type;
  using Default_solver = Conjugate_gradient_solver_traits_3<ConcurrencyTag>;
  using Solver = Mutable_parameter<typename internal_np::Lookup_named_param_def<
    internal_np::solver_traits_t, NamedParameters, Default_solver>::reference>;

  bool after_step(const Parameterization_step& step)
  {
    if(m_options.verbose)
      print(step);
    return m_limits.visitor().after_step(step);
  }

  const Map_options_3 m_options;
  const Energy m_energy;
  decltype(cell_energy_3(std::declval<const Energy&>())) m_cell_energy;
  Default_solver m_default_solver;
  Solver m_solver;
  Linear_solver_of<std::remove_reference_t<Solver> > m_linear_solver;
  Limits<NamedParameters> m_limits;
  Progress_3 m_progress;
};

// The functions below read the named parameters about vertices. `points` are those of cells, and `vertex(p)` is what the user
// calls the point p.

template <typename Vertex, typename NamedParameters, typename VertexOfPoint>
void set_conditions(Prescription_3& prescription, const Body_3& body, const std::vector<std::size_t>& points,
                    const NamedParameters& np, const VertexOfPoint& vertex)
{
  if constexpr(has_conditions<NamedParameters>)
  {
    const auto conditions = parameters::get_parameter(np, internal_np::vertex_condition_map);
    constexpr bool is_map = Is_map_of<std::remove_const_t<decltype(conditions)>, Vertex>::value;
    static_assert(is_map, "vertex_condition_map must be a property map of vertices: for a container, pass "
                          "make_vertex_condition_map(container), and for arrays, CGAL::make_property_map(vector).");
    static_assert(parameters::is_default_parameter<NamedParameters, internal_np::vertex_is_constrained_t>::value
                  && parameters::is_default_parameter<NamedParameters, internal_np::do_slide_boundary_t>::value,
                  "vertex_condition_map replaces vertex_is_constrained_map and do_slide_boundary: pass one of them.");
    if constexpr(is_map) // otherwise, the compiler would list all functions get()
      for(const std::size_t p : points)
        prescription.conditions[p] = get(conditions, vertex(p));
  }
  else
  {
    const auto is_constrained
      = parameter_or(np, internal_np::vertex_is_constrained, Static_boolean_property_map<Vertex, false>());
    prescription.boundary_condition = parameter_or(np, internal_np::do_slide_boundary, false)
                                      ? Vertex_condition_3::in_boundary() : Vertex_condition_3::at_target();
    const std::vector<bool> is_on_boundary = used_points(body.boundary, body.points.size());
    for(const std::size_t p : points)
      if(get(is_constrained, vertex(p)))
        prescription.conditions[p] = Vertex_condition_3::at_target();
      else if(is_on_boundary[p])
        prescription.conditions[p] = prescription.boundary_condition;
  }
}

template <typename Vertex, typename NamedParameters, typename VertexOfPoint>
void set_initial_images(Prescription_3& prescription, const std::vector<std::size_t>& points, const NamedParameters& np,
                        const VertexOfPoint& vertex)
{
  const auto initial_map = parameters::get_parameter(np, internal_np::initial_map);
  constexpr bool is_map = Is_map_of<std::remove_const_t<decltype(initial_map)>, Vertex>::value;
  static_assert(is_map, "initial_map must be a property map of vertices: for a container, pass make_vertex_point_map(container), "
                        "and for arrays, CGAL::make_property_map(vector).");
  prescription.initial.resize(prescription.targets.size());
  if constexpr(is_map)
    for(const std::size_t p : points)
      prescription.initial[p] = coordinates(get(initial_map, vertex(p)));
}

template <typename Vertex, typename VertexOfPoint>
std::vector<Linear_constraint_3<std::size_t> > constraints_of_points(const std::vector<Linear_constraint_3<Vertex> >& constraints,
                                                                     const std::vector<std::size_t>& points,
                                                                     const VertexOfPoint& vertex)
{
  std::unordered_map<Vertex, std::size_t> point_of;
  for(const std::size_t p : points)
    point_of.emplace(vertex(p), p);
  std::vector<Linear_constraint_3<std::size_t> > result;
  for(const Linear_constraint_3<Vertex>& constraint : constraints)
  {
    result.push_back({ {}, constraint.value });
    for(const auto& term : constraint.terms)
      result.back().terms.push_back({ point_of.at(term.vertex), term.coefficient });
  }
  return result;
}

// Returns the prescription of a body, where `target(p)` is the target of a point.
template <typename Vertex, typename NamedParameters, typename TargetOfPoint, typename VertexOfPoint>
Prescription_3 prescription_3(const Body_3& body, const NamedParameters& np, const TargetOfPoint& target,
                              const VertexOfPoint& vertex)
{
  const std::vector<std::size_t> points = points_of_cells(body);
  Prescription_3 result;
  result.extend_to(body.points.size());
  set_conditions<Vertex>(result, body, points, np, vertex);
  for(const std::size_t p : points)
    if(result.conditions[p].dimension() < 3)
      result.targets[p] = body.image_type.rounded_point(completed_target(coordinates(target(p)), result.conditions[p]));
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::initial_map_t>::value)
    set_initial_images<Vertex>(result, points, np, vertex);
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::positional_constraints_t>::value)
    result.constraints = constraints_of_points<Vertex>(parameters::get_parameter(np, internal_np::positional_constraints), points,
                                                       vertex);
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENTRY_NAMED_PARAMETERS_3_H
