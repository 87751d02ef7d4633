// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MINIMIZER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MINIMIZER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Linear_solver_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distortion_derivatives_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energy_sum_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Step_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/largest_step_3.h>

#include <Eigen/Dense>

#include <algorithm>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Minimizes an energy by Newton steps that never invert a cell: with the positive semi-definite
// Hessian far from the optimum, with the full one near it, where it converges quadratically.
template <typename Newton, typename Energy, typename ConcurrencyTag>
class Minimizer_3
{
public:
  Minimizer_3(Newton& newton, Eigen::Matrix3Xd& u, const Energy& energy)
    : m_newton(newton), m_u(u), m_energy(energy), m_evaluation(newton.evaluate(energy, u))
  {}

  const Energy_evaluation& evaluation() const { return m_evaluation; }
  double step_length() const { return m_step_length; }

  Step_status step()
  {
    const Linear_solver_status status = compute_direction();
    if(status != Linear_solver_status::SUCCESS && status != Linear_solver_status::TRUNCATED)
      return Step_status::SOLVER_FAILED;

    constexpr double safety = 0.9;
    const double largest = largest_step_3<ConcurrencyTag>(m_newton.packs(), m_u, m_newton.direction());
    const typename Newton::Step step
      = m_newton.line_search(m_energy, m_u, m_evaluation.energy, largest < 1 ? safety * largest : 1., true);
    m_step_length = step.length;
    if(step.length == 0)
      return is_converged() ? Step_status::DONE : Step_status::STUCK;

    m_evaluation = step.evaluation;
    return is_converged() ? Step_status::DONE : Step_status::CONTINUE;
  }

private:
  Linear_solver_status compute_direction()
  {
    constexpr double solver_tolerance = 1e-2;
    if(is_near_optimum() && m_steps_to_wait-- <= 0)
    {
      const Linear_solver_status status
        = m_newton.compute_direction(m_energy, m_u, Hessian_kind::FULL, solver_tolerance);
      // each failure doubles the number of steps before the next attempt
      m_waiting_time = status == Linear_solver_status::SUCCESS ? 1 : (std::min)(2 * m_waiting_time, 16);
      m_steps_to_wait = status == Linear_solver_status::SUCCESS ? 0 : m_waiting_time;
      if(status != Linear_solver_status::NOT_POSITIVE_DEFINITE)
        return status;
    }
    return m_newton.compute_direction(m_energy, m_u, Hessian_kind::POSITIVE_SEMIDEFINITE, solver_tolerance);
  }

  // did the last step, a full one, hardly change the energy?
  bool is_near_optimum() const
  {
    return m_step_length == 1 && -m_newton.slope() < 1e-2 * m_evaluation.energy;
  }

  // the squared Newton decrement bounds what a step can gain
  bool is_converged() const
  {
    return -m_newton.slope() <= 1e-8 * (std::max)(1., m_evaluation.energy);
  }

  Newton& m_newton;
  Eigen::Matrix3Xd& m_u;
  const Energy& m_energy;
  Energy_evaluation m_evaluation;
  double m_step_length = 0;
  int m_waiting_time = 1;
  int m_steps_to_wait = 0;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MINIMIZER_3_H
