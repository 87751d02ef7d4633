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
#include <CGAL/Volume_mesh_parameterization/internal/Energy_sum_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Step_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/largest_step_3.h>

#include <Eigen/Dense>

#include <algorithm>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Minimizes an energy by Newton steps that never invert a cell. The part of the negative curvature
// that the Hessian keeps is raised after each full step, and lowered when the Hessian proves
// indefinite: far from the optimum the Hessian is positive semi-definite, near it the full one, which
// converges quadratically.
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
    Linear_solver_status status = move();
    while(m_negative_curvature > 0 && (m_step_length == 0 || status != Linear_solver_status::SUCCESS))
    {
      lower_negative_curvature();
      status = move();
    }
    if(status != Linear_solver_status::SUCCESS && status != Linear_solver_status::TRUNCATED)
      return Step_status::SOLVER_FAILED;
    if(is_converged())
      return Step_status::DONE;
    if(m_step_length >= 1)
      raise_negative_curvature();
    return m_step_length > 0 ? Step_status::CONTINUE : Step_status::STUCK;
  }

private:
  Linear_solver_status move()
  {
    constexpr double solver_tolerance = 1e-2;
    m_step_length = 0;
    const Linear_solver_status status
      = m_newton.compute_direction(m_energy, m_u, m_negative_curvature, solver_tolerance);
    if(status == Linear_solver_status::SUCCESS
       || (status == Linear_solver_status::TRUNCATED && m_negative_curvature == 0))
    {
      const typename Newton::Step step = search();
      m_step_length = step.length;
      if(step.length > 0)
        m_evaluation = step.evaluation;
    }
    return status;
  }

  typename Newton::Step search()
  {
    constexpr double safety = 0.9; // stays away from flat cells
    const double largest = largest_step_3<ConcurrencyTag>(m_newton.packs(), m_u, m_newton.direction());
    const Eigen::Matrix3Xd origin = m_u;
    typename Newton::Step step = m_newton.line_search(m_energy, m_u, m_evaluation.energy,
                                                      largest < 1 ? safety * largest : 1., true);
    // A gain above half of the slope shows less curvature than the Hessian had.
    if(step.length == 1 && step.evaluation.energy < m_evaluation.energy + 0.6 * m_newton.slope())
      m_newton.extrapolate(m_energy, origin, m_u, step);
    return step;
  }

  // A failure also slows down the next rises.
  void lower_negative_curvature()
  {
    m_negative_curvature = m_negative_curvature > 0.01 ? m_negative_curvature / 4 : 0;
    m_growth = 1.5;
  }

  void raise_negative_curvature()
  {
    m_negative_curvature = (std::min)(1., (std::max)(0.1, m_growth * m_negative_curvature));
    m_growth = (std::min)(4., 1.2 * m_growth);
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
  double m_negative_curvature = 0; // the part of it that the Hessian keeps
  double m_growth = 4;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MINIMIZER_3_H
