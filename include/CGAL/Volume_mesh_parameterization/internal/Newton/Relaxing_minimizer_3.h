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

#include <CGAL/Volume_mesh_parameterization/internal/Newton/Penalty_minimizer_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/line_search_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// The same with the relaxation of Jin et al., section 4.2: a step must decrease the energy and the norm of its
// gradient. Where none does, the vertices are relaxed: for some steps, the current positions take the
// place of the target. If it fails again after that, a decrease of the energy suffices.
class Relaxing_minimizer_3 : public Penalty_minimizer_3
{
public:
  using Penalty_minimizer_3::Penalty_minimizer_3;

  // Then evaluation() is of the energy with the temporary target.
  bool is_relaxing() const override { return m_relaxations_left > 0; }

  Step_status step() override
  {
    if(is_relaxing())
      return relax();

    bool has_moved = m_parameters.use_full_hessian ? move(1, true) : move_with_some_curvature(true);
    if(!has_moved && m_can_relax && !m_direction.has_solver_failed())
    {
      begin_relaxation();
      return relax();
    }
    if(!has_moved)
      has_moved = move(0, false);
    // a relaxation has to pay off before there is another one
    m_can_relax = m_evaluation.energy < m_lowest_energy;
    m_lowest_energy = (std::min)(m_lowest_energy, m_evaluation.energy);
    return conclude(has_moved);
  }

private:
  void begin_relaxation()
  {
    m_can_relax = false;
    m_relaxations_left = m_parameters.maximal_number_of_relaxations;
    m_penalty.hold(m_u);
    m_evaluation = m_system.evaluate(m_energy, m_u);
  }

  Step_status relax()
  {
    --m_relaxations_left;
    if(!move(0, false))
      m_relaxations_left = 0;
    if(!is_relaxing())
    {
      m_penalty.release();
      m_evaluation = m_system.evaluate(m_energy, m_u);
    }
    return m_direction.has_solver_failed() ? Step_status::SOLVER_FAILED : Step_status::CONTINUE;
  }

  double m_lowest_energy = std::numeric_limits<double>::infinity();
  bool m_can_relax = true;
  std::size_t m_relaxations_left = 0;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_RELAXING_MINIMIZER_3_H
