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

#include <CGAL/Volume_mesh_parameterization/internal/Newton/Negative_curvature.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Stagnation.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Step_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_direction_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/line_search_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// Minimizes an energy by Newton steps that never invert a cell.
class Minimizer_3
{
public:
  Minimizer_3(Newton_system_3& system, const Cell_energy_3& energy, Eigen::Matrix3Xd u,
              const Negative_curvature& negative_curvature = Negative_curvature())
    : m_system(system), m_energy(energy), m_u(std::move(u)), m_evaluation(system.evaluate(energy, m_u)),
      m_negative_curvature(negative_curvature)
  {}

  const Eigen::Matrix3Xd& positions() const { return m_u; }
  const Energy_evaluation& evaluation() const { return m_evaluation; }
  const Newton_direction_3& direction() const { return m_direction; } // of the last step
  double step_length() const { return m_step_length; }
  bool is_stagnating() const { return m_stagnation.is_noticed(); }

  // The full Hessian is tried, or a part of its negative curvature; less of it where that fails.
  Step_status step()
  {
    move();
    while(m_negative_curvature.part() > 0 && (m_step_length == 0 || !m_direction.is_usable())
          && m_direction.status != Linear_solver_status::OUT_OF_MEMORY)
    {
      m_negative_curvature.lower();
      move();
    }
    if(!m_direction.is_usable())
      return Step_status::SOLVER_FAILED;
    if(is_converged())
      return Step_status::DONE;
    m_stagnation.add(m_evaluation.energy, -m_direction.slope);
    // far from the minimum, the semi-definite Hessian does as well, and the full one mostly proves indefinite
    if(m_step_length >= 1 && -m_direction.slope < 0.1 * m_evaluation.energy)
      m_negative_curvature.raise();
    return m_step_length > 0 ? Step_status::CONTINUE : Step_status::STUCK;
  }

private:
  void move()
  {
    m_step_length = 0;
    m_direction = m_system.direction(m_energy, m_u, m_negative_curvature.part(), solver_tolerance());
    if(!m_direction.is_usable())
      return;
    Line_search_step_3 step = search();
    m_step_length = step.length;
    if(step.length == 0)
      return;
    m_u = std::move(step.positions);
    m_evaluation = step.evaluation;
  }

  Line_search_step_3 search() const
  {
    Line_search_step_3 step = safe_line_search_3(m_system, m_energy, m_u, m_evaluation.energy, m_direction);
    // A gain above half of the slope shows less curvature than the Hessian had.
    if(step.length == 1 && step.evaluation.energy < m_evaluation.energy + 0.6 * m_direction.slope)
      return extrapolated(m_system, m_energy, m_u, m_direction, std::move(step));
    return step;
  }

  // The squared Newton decrement, which bounds what a step can gain, relative to the energy.
  double relative_gain() const { return -m_direction.slope / (std::max)(1., m_evaluation.energy); }

  bool is_converged() const { return relative_gain() <= 1e-8; }

  // Tighter as the minimum is near, so that the last step meets it (Eisenstat and Walker, Choosing the forcing terms in an
  // inexact Newton method, SIAM Journal on Scientific Computing 17, 1996).
  double solver_tolerance() const
  {
    constexpr double smallest = 1e-4, largest = 1e-2;
    return relative_gain() > 0 ? std::clamp(std::sqrt(relative_gain()), smallest, largest) : largest;
  }

  Newton_system_3& m_system;
  const Cell_energy_3& m_energy;
  Eigen::Matrix3Xd m_u;
  Energy_evaluation m_evaluation;
  Newton_direction_3 m_direction;
  double m_step_length = 0;
  Negative_curvature m_negative_curvature;
  Stagnation m_stagnation;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_MINIMIZER_3_H
