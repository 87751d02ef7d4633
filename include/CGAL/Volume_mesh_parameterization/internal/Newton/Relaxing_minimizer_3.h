// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_RELAXING_MINIMIZER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_RELAXING_MINIMIZER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Linear_solver_status.h>
#include <CGAL/Volume_mesh_parameterization/Soft_boundary_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Energy_sum_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Negative_curvature.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Quadratic_penalty_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Step_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/largest_step_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Minimizes an energy plus the penalty of the constraints, for one weight, by Newton steps that never
// invert a cell (Jin et al., section 4.2). A step must decrease the energy and the norm of its
// gradient. Where none does, the vertices are relaxed: for some steps, the current positions take the
// place of the target. If it fails again after that, a decrease of the energy suffices.
template <typename Newton, typename Energy, typename ConcurrencyTag>
class Relaxing_minimizer_3
{
public:
  // `diameter` is the unit of the tolerances for energy and step.
  Relaxing_minimizer_3(Newton& newton, Quadratic_penalty_3& penalty, Eigen::Matrix3Xd& u, const Energy& energy,
                       const Soft_boundary_parameters& parameters, const double diameter)
    : m_newton(newton), m_penalty(penalty), m_u(u), m_energy(energy), m_parameters(parameters),
      m_diameter(diameter), m_evaluation(newton.evaluate(energy, u)), m_last_energy(m_evaluation.energy)
  {}

  // During a relaxation, of the energy with the temporary target.
  const Energy_evaluation& evaluation() const { return m_evaluation; }
  double step_length() const { return m_step_length; }
  bool is_relaxing() const { return m_relaxations_left > 0; }

  Step_status step()
  {
    if(is_relaxing())
      return relax();

    bool has_moved = update();
    if(!has_moved && m_can_relax && !has_solver_failed())
    {
      begin_relaxation();
      return relax();
    }
    if(!has_moved && uses_relaxation())
      has_moved = move(0, false);
    if(has_solver_failed())
      return Step_status::SOLVER_FAILED;
    if(m_step_length >= 1)
      m_negative_curvature.raise();
    // a relaxation has to pay off before there is another one
    m_can_relax = uses_relaxation() && m_evaluation.energy < m_lowest_energy;
    m_lowest_energy = (std::min)(m_lowest_energy, m_evaluation.energy);
    if(!has_moved)
      return is_gradient_small() ? Step_status::DONE : Step_status::STUCK;
    return is_converged() ? Step_status::DONE : Step_status::CONTINUE;
  }

private:
  bool uses_relaxation() const { return m_parameters.maximal_number_of_relaxations > 0; }

  // The step proper. Without relaxation, the energy alone decides.
  bool update()
  {
    if(m_parameters.use_full_hessian)
      return move(1, uses_relaxation()) || (!uses_relaxation() && move(0, false));
    while(!move(m_negative_curvature.part(), uses_relaxation()))
    {
      if(m_negative_curvature.part() == 0)
        return false;
      m_negative_curvature.lower();
    }
    return true;
  }

  // One Newton step. Returns whether there was an acceptable one.
  bool move(const double negative_curvature, const bool must_decrease_gradient)
  {
    constexpr double safety = 0.9; // stays away from flat cells
    m_step_length = 0;
    m_solver_status = m_newton.compute_direction(m_energy, m_u, negative_curvature, solver_tolerance());
    const bool has_direction = m_solver_status == Linear_solver_status::SUCCESS
      || (m_solver_status == Linear_solver_status::TRUNCATED && negative_curvature == 0);
    if(!has_direction)
      return false;

    const double largest = largest_step_3<ConcurrencyTag>(m_newton.packs(), m_u, m_newton.direction());
    const typename Newton::Step step
      = m_newton.line_search(m_energy, m_u, m_evaluation.energy, largest < 1 ? safety * largest : 1., true,
                             must_decrease_gradient ? m_newton.gradient_norm()
                                                    : std::numeric_limits<double>::infinity());
    m_step_length = step.length;
    if(step.length == 0)
      return false;
    m_evaluation = step.evaluation;
    return true;
  }

  // the energy without the penalty
  double distortion() const { return m_evaluation.energy - m_penalty.value(m_u); }

  // What remains of the residual is small against the distortion, even where the penalty is much larger.
  double solver_tolerance() const { return 1e-2 * std::sqrt(distortion() / m_evaluation.energy); }

  bool has_solver_failed() const
  {
    return m_solver_status == Linear_solver_status::OUT_OF_MEMORY
        || m_solver_status == Linear_solver_status::FAILED;
  }

  void begin_relaxation()
  {
    m_can_relax = false;
    m_relaxations_left = m_parameters.maximal_number_of_relaxations;
    m_penalty.hold(m_u);
    m_evaluation = m_newton.evaluate(m_energy, m_u);
  }

  Step_status relax()
  {
    --m_relaxations_left;
    if(!move(0, false))
      m_relaxations_left = 0;
    if(!is_relaxing())
    {
      m_penalty.release();
      m_evaluation = m_newton.evaluate(m_energy, m_u);
    }
    return has_solver_failed() ? Step_status::SOLVER_FAILED : Step_status::CONTINUE;
  }

  bool is_converged()
  {
    const double change = std::abs(m_evaluation.energy - m_last_energy);
    m_last_energy = m_evaluation.energy;
    const double largest_move = m_step_length * m_newton.direction().colwise().norm().maxCoeff();
    return change < m_parameters.energy_tolerance * m_diameter
        || change < m_parameters.relative_energy_tolerance * distortion()
        || largest_move < m_parameters.step_tolerance * m_diameter
        || is_gradient_small();
  }

  bool is_gradient_small() const
  {
    return m_newton.gradient_norm() < m_parameters.gradient_tolerance * m_evaluation.energy;
  }

  Newton& m_newton;
  Quadratic_penalty_3& m_penalty;
  Eigen::Matrix3Xd& m_u;
  const Energy& m_energy;
  const Soft_boundary_parameters& m_parameters;
  double m_diameter;
  Energy_evaluation m_evaluation;
  double m_last_energy;        // after the last step that was not a relaxation
  double m_step_length = 0;
  Negative_curvature m_negative_curvature;
  double m_lowest_energy = std::numeric_limits<double>::infinity();
  bool m_can_relax = m_parameters.maximal_number_of_relaxations > 0;
  std::size_t m_relaxations_left = 0;
  Linear_solver_status m_solver_status = Linear_solver_status::SUCCESS;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_RELAXING_MINIMIZER_3_H
