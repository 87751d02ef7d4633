// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_UNTANGLER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_UNTANGLER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Untangling_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Step_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_direction_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/line_search_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// Removes inverted cells: minimizes the untangling energy while its epsilon tends to zero
// (Garanzha et al. 2021, section 4), until no cell is inverted.
class Untangler_3
{
public:
  Untangler_3(Newton_system_3& system, Eigen::Matrix3Xd u, const double theta)
    : m_system(system), m_u(std::move(u)), m_theta(theta)
  {
    const double D = evaluate(Untangling_energy_3(1, m_theta)).smallest_determinant;
    m_epsilon = first_epsilon(D);
    m_evaluation = evaluate(Untangling_energy_3(m_epsilon, m_theta));
    m_best = m_u;
    m_fewest_inverted_cells = m_evaluation.number_of_inverted_cells;
  }

  const Eigen::Matrix3Xd& positions() const { return m_best; } // with the fewest inverted cells so far
  const Energy_evaluation& evaluation() const { return m_evaluation; }
  const Newton_direction_3& direction() const { return m_direction; } // of the last step
  double step_length() const { return m_step_length; }

  Step_status step()
  {
    constexpr double solver_tolerance = 1e-2;
    if(m_evaluation.is_flip_free())
      return Step_status::DONE;

    const Untangling_energy_3 f(m_epsilon, m_theta);
    const Cell_energy_of<Untangling_energy_3> energy(f);
    m_direction = m_system.direction(energy, m_u, 0., solver_tolerance);
    if(!m_direction.is_usable())
      return Step_status::SOLVER_FAILED;

    Line_search_step_3 step = line_search_3(m_system, energy, m_u, m_evaluation.energy, m_direction, 1., false);
    m_step_length = step.length;
    if(step.length == 0)
      return Step_status::STUCK;
    m_u = std::move(step.positions);
    keep_best(step.evaluation);
    if(step.evaluation.is_flip_free())
    {
      m_evaluation = step.evaluation;
      return Step_status::DONE;
    }

    m_epsilon = next_epsilon(m_epsilon, 1 - step.evaluation.energy / m_evaluation.energy,
                             m_evaluation.smallest_determinant, step.evaluation.smallest_determinant);
    m_evaluation = evaluate(Untangling_energy_3(m_epsilon, m_theta));
    return is_progressing() ? Step_status::CONTINUE : Step_status::STUCK;
  }

private:
  Energy_evaluation evaluate(const Untangling_energy_3& f) const
  {
    return m_system.evaluate(Cell_energy_of<Untangling_energy_3>(f), m_u);
  }

  void keep_best(const Energy_evaluation& evaluation)
  {
    ++m_steps_without_progress;
    if(evaluation.number_of_inverted_cells >= m_fewest_inverted_cells)
      return;
    m_fewest_inverted_cells = evaluation.number_of_inverted_cells;
    m_best = m_u;
    m_steps_without_progress = 0;
  }

  // A small epsilon no longer changes what the energy is.
  bool is_progressing() const
  {
    constexpr std::size_t patience = 15;
    constexpr double small_epsilon = 1e-6;
    return m_steps_without_progress < (m_epsilon < small_epsilon ? patience : 2 * patience);
  }

  Newton_system_3& m_system;
  Eigen::Matrix3Xd m_u, m_best;
  double m_theta;
  double m_epsilon;
  double m_step_length = 0;
  Newton_direction_3 m_direction;
  Energy_evaluation m_evaluation;
  std::size_t m_fewest_inverted_cells;
  std::size_t m_steps_without_progress = 0;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_UNTANGLER_3_H
