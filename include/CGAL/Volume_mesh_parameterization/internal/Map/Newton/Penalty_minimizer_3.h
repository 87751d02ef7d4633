// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_PENALTY_MINIMIZER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_PENALTY_MINIMIZER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/line_search_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Negative_curvature.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Minimizes an energy plus the penalty of the constraints, for one weight, by Newton steps that never invert a cell. Ends
// by the three criteria of Jin et al., section 4.2: energy, positions or gradient have become stationary.
//
// With their relaxation, a step must decrease the energy and the norm of its gradient. Where none does, the vertices are
// relaxed: for some steps, the current positions replace the target. If it fails again after that, a decrease of
// the energy suffices.
class Penalty_minimizer_3
{
public:
  // `diameter` is the unit of the tolerances for energy and step.
  Penalty_minimizer_3(Newton_system_3& system, Quadratic_penalty_3& penalty, const Cell_energy_3& energy,
                      const Matrix3Xd& positions, const Soft_boundary_parameters& parameters, const double diameter)
    : m_system(system), m_penalty(penalty), m_energy(energy), m_parameters(parameters), m_diameter(diameter),
      m_iterate{ system.scale(), system.scale() * positions }
  {
    m_iterate.evaluation = system.evaluate(energy, m_iterate.u);
    m_last_energy = m_iterate.evaluation.energy;
  }

  const Newton_iterate_3& iterate() const { return m_iterate; }
  bool is_relaxing() const { return m_relaxations_left > 0; } // then the evaluation is for the temporary target

  // Takes a step. Returns the status with which to end, or none to go on.
  std::optional<Error_code> step()
  {
    if(is_relaxing())
      return relax();
    bool has_moved = move_with_hessian(allows_relaxation());
    if(allows_relaxation() && !has_moved && m_has_paid_off && !m_iterate.direction.has_solver_failed())
    {
      begin_relaxation();
      return relax();
    }
    if(!has_moved && (allows_relaxation() || m_parameters.use_full_hessian))
      has_moved = move(0, false);
    if(allows_relaxation())
    {
      m_has_paid_off = m_iterate.evaluation.energy < m_lowest_energy;
      m_lowest_energy = (std::min)(m_lowest_energy, m_iterate.evaluation.energy);
    }
    return conclude(has_moved);
  }

private:
  bool allows_relaxation() const { return m_parameters.maximum_number_of_relaxations > 0; } // the target, as in the paper

  // A Newton step with the full Hessian, or with as much of its negative curvature as serves.
  bool move_with_hessian(const bool must_decrease_gradient)
  {
    if(m_parameters.use_full_hessian)
      return move(1, must_decrease_gradient);
    return step_with_some_curvature(m_negative_curvature, m_iterate,
                                    [&](const double part) { return move(part, must_decrease_gradient); });
  }

  // One Newton step. Returns whether there was an acceptable one.
  bool move(const double negative_curvature, const bool must_decrease_gradient)
  {
    return m_iterate.move(m_system.direction(m_energy, m_iterate.u, negative_curvature, solver_tolerance()), [&]
    {
      if(!allows_relaxation())
        return far_line_search_3(m_system, m_energy, m_iterate);
      return safe_line_search_3(m_system, m_energy, m_iterate, must_decrease_gradient
                                ? m_iterate.direction.gradient_norm : std::numeric_limits<double>::infinity());
    });
  }

  void begin_relaxation()
  {
    m_has_paid_off = false;
    m_relaxations_left = m_parameters.maximum_number_of_relaxations;
    m_penalty.hold(m_iterate.u);
    m_iterate.evaluation = m_system.evaluate(m_energy, m_iterate.u);
  }

  std::optional<Error_code> relax()
  {
    --m_relaxations_left;
    if(!move(0, false))
      m_relaxations_left = 0;
    if(!is_relaxing())
    {
      m_penalty.release();
      m_iterate.evaluation = m_system.evaluate(m_energy, m_iterate.u);
    }
    return m_iterate.direction.has_solver_failed() ? std::optional(ERROR_LINEAR_SOLVER_FAILED) : std::nullopt;
  }

  std::optional<Error_code> conclude(const bool has_moved)
  {
    if(m_iterate.direction.has_solver_failed())
      return ERROR_LINEAR_SOLVER_FAILED;
    if(m_iterate.step_length >= 1)
      m_negative_curvature.raise();
    const double change = std::abs(m_iterate.evaluation.energy - m_last_energy);
    m_last_energy = m_iterate.evaluation.energy;
    if(!has_moved)
      return is_gradient_small() ? OK : ERROR_NOT_CONVERGED;
    return is_converged(change) ? std::optional(OK) : std::nullopt;
  }

  // the energy without the penalty
  double distortion() const { return m_iterate.evaluation.energy - m_penalty.value(m_iterate.u); }

  // Asks for a residual that is small against the distortion, even where the penalty is much larger.
  double solver_tolerance() const { return 1e-2 * std::sqrt(distortion() / m_iterate.evaluation.energy); }

  // Takes the change of the energy by the last step.
  bool is_converged(const double change) const
  {
    const double largest_move = m_iterate.step_length * m_iterate.direction.vectors.colwise().norm().maxCoeff();
    return change < m_parameters.energy_tolerance * m_diameter
        || change < m_parameters.relative_energy_tolerance * m_iterate.evaluation.energy
        || largest_move < m_parameters.step_tolerance * m_diameter
        || is_gradient_small();
  }

  bool is_gradient_small() const
  { return m_iterate.direction.gradient_norm < m_parameters.gradient_tolerance * m_iterate.evaluation.energy; }

  Newton_system_3& m_system;
  Quadratic_penalty_3& m_penalty;
  const Cell_energy_3& m_energy;
  const Soft_boundary_parameters& m_parameters;
  double m_diameter;
  Newton_iterate_3 m_iterate;
  Negative_curvature m_negative_curvature;
  double m_last_energy; // after the last step that has been concluded
  double m_lowest_energy = std::numeric_limits<double>::infinity();
  bool m_has_paid_off = true; // the last relaxation, or there was none
  std::size_t m_relaxations_left = 0;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_PENALTY_MINIMIZER_3_H
