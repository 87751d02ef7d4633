// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_PENALTY_MINIMIZER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_PENALTY_MINIMIZER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Linear_solver_status.h>
#include <CGAL/Volume_mesh_parameterization/Soft_boundary_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Negative_curvature.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Quadratic_penalty_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Step_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_direction_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/line_search_3.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// Minimizes an energy plus the penalty of the constraints, for one weight, by Newton steps that never invert a cell. Ends
// by the three criteria of Jin et al., section 4.2: energy, positions or gradient have become stationary.
class Penalty_minimizer_3
{
public:
  // `diameter` is the unit of the tolerances for energy and step.
  Penalty_minimizer_3(Newton_system_3& system, Quadratic_penalty_3& penalty, const Cell_energy_3& energy,
                      Eigen::Matrix3Xd u, const Soft_boundary_parameters& parameters, const double diameter)
    : m_system(system), m_penalty(penalty), m_energy(energy), m_parameters(parameters), m_diameter(diameter),
      m_u(std::move(u)), m_evaluation(system.evaluate(energy, m_u)), m_last_energy(m_evaluation.energy)
  {}

  virtual ~Penalty_minimizer_3() = default;

  const Eigen::Matrix3Xd& positions() const { return m_u; }
  const Energy_evaluation& evaluation() const { return m_evaluation; }
  const Newton_direction_3& direction() const { return m_direction; } // of the last step
  double step_length() const { return m_step_length; }
  virtual bool is_relaxing() const { return false; }

  virtual Step_status step()
  {
    return conclude(m_parameters.use_full_hessian ? move(1, false) || move(0, false) : move_with_some_curvature(false));
  }

protected:
  // A Newton step with as much negative curvature of the Hessian as serves.
  bool move_with_some_curvature(const bool must_decrease_gradient)
  {
    while(!move(m_negative_curvature.part(), must_decrease_gradient))
    {
      if(m_negative_curvature.part() == 0 || m_direction.status == Linear_solver_status::OUT_OF_MEMORY)
        return false;
      m_negative_curvature.lower();
    }
    return true;
  }

  // One Newton step. Returns whether there was an acceptable one.
  bool move(const double negative_curvature, const bool must_decrease_gradient)
  {
    m_step_length = 0;
    m_direction = m_system.direction(m_energy, m_u, negative_curvature, solver_tolerance());
    if(!m_direction.is_usable())
      return false;
    Line_search_step_3 step
      = safe_line_search_3(m_system, m_energy, m_u, m_evaluation.energy, m_direction,
                           must_decrease_gradient ? m_direction.gradient_norm : std::numeric_limits<double>::infinity());
    m_step_length = step.length;
    if(step.length == 0)
      return false;
    m_u = std::move(step.positions);
    m_evaluation = step.evaluation;
    return true;
  }

  Step_status conclude(const bool has_moved)
  {
    if(m_direction.has_solver_failed())
      return Step_status::SOLVER_FAILED;
    if(m_step_length >= 1)
      m_negative_curvature.raise();
    if(!has_moved)
      return is_gradient_small() ? Step_status::DONE : Step_status::STUCK;
    return is_converged() ? Step_status::DONE : Step_status::CONTINUE;
  }

  Newton_system_3& m_system;
  Quadratic_penalty_3& m_penalty;
  const Cell_energy_3& m_energy;
  const Soft_boundary_parameters& m_parameters;
  double m_diameter;
  Eigen::Matrix3Xd m_u;
  Energy_evaluation m_evaluation;
  Newton_direction_3 m_direction;
  double m_step_length = 0;
  Negative_curvature m_negative_curvature;

private:
  // the energy without the penalty
  double distortion() const { return m_evaluation.energy - m_penalty.value(m_u); }

  // What remains of the residual is small against the distortion, even where the penalty is much larger.
  double solver_tolerance() const { return 1e-2 * std::sqrt(distortion() / m_evaluation.energy); }

  bool is_converged()
  {
    const double change = std::abs(m_evaluation.energy - m_last_energy);
    m_last_energy = m_evaluation.energy;
    const double largest_move = m_step_length * m_direction.vectors.colwise().norm().maxCoeff();
    return change < m_parameters.energy_tolerance * m_diameter
        || change < m_parameters.relative_energy_tolerance * distortion()
        || largest_move < m_parameters.step_tolerance * m_diameter
        || is_gradient_small();
  }

  bool is_gradient_small() const
  {
    return m_direction.gradient_norm < m_parameters.gradient_tolerance * m_evaluation.energy;
  }

  double m_last_energy; // after the last step that has been concluded
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_PENALTY_MINIMIZER_3_H
