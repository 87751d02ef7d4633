// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_MINIMIZER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_MINIMIZER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Linear_solver_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Energy_sum_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Negative_curvature.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Step_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/largest_step_3.h>

#include <Eigen/Dense>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Minimizes an energy by Newton steps that never invert a cell.
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
    while(m_negative_curvature.part() > 0 && (m_step_length == 0 || status != Linear_solver_status::SUCCESS))
    {
      m_negative_curvature.lower();
      status = move();
    }
    if(status != Linear_solver_status::SUCCESS && status != Linear_solver_status::TRUNCATED)
      return Step_status::SOLVER_FAILED;
    if(is_converged())
      return Step_status::DONE;
    if(m_step_length >= 1)
      m_negative_curvature.raise();
    return m_step_length > 0 ? Step_status::CONTINUE : Step_status::STUCK;
  }

private:
  Linear_solver_status move()
  {
    constexpr double solver_tolerance = 1e-2;
    m_step_length = 0;
    const Linear_solver_status status
      = m_newton.compute_direction(m_energy, m_u, m_negative_curvature.part(), solver_tolerance);
    if(status == Linear_solver_status::SUCCESS
       || (status == Linear_solver_status::TRUNCATED && m_negative_curvature.part() == 0))
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
  Negative_curvature m_negative_curvature;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_MINIMIZER_3_H
