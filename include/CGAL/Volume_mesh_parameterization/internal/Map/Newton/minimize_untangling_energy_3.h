// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_MINIMIZE_UNTANGLING_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_MINIMIZE_UNTANGLING_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Energies/Untangling_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/line_search_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Lowers the untangling energy while its epsilon tends to zero (Garanzha et al. 2021, section 4).
class Untangler_3
{
public:
  Untangler_3(Newton_system_3& system, const Matrix3Xd& u, const double theta, const std::size_t few_cells,
              const double solver_tolerance)
    : m_system(system), m_theta(theta), m_solver_tolerance(solver_tolerance), m_few_cells(few_cells),
      m_iterate{ system.scale(), u }, m_best(u)
  {
    const double D = evaluate(Untangling_energy_3(1, m_theta)).smallest_determinant;
    m_epsilon = first_epsilon(D);
    if(m_system.are_steps_along_tangents())
      m_system.move_from(u);
    m_iterate.evaluation = evaluate(Untangling_energy_3(m_epsilon, m_theta));
    m_fewest_inverted_cells = m_halved_inverted_cells = m_iterate.evaluation.number_of_inverted_cells;
  }

  const Newton_iterate_3& iterate() const { return m_iterate; }
  const Matrix3Xd& best() const { return m_best; } // with the fewest inverted cells so far

  void step(const Budget& budget)
  {
    const Cell_energy_of<Untangling_energy_3> energy{Untangling_energy_3(m_epsilon, m_theta)};
    const Energy_evaluation before = m_iterate.evaluation;
    if(!m_iterate.move(m_system.direction(energy, m_iterate.u, 0., m_solver_tolerance, budget), [&]
       { return line_search_3(m_system, energy, m_iterate, 1., false); }))
      return;
    Energy_evaluation& evaluation = m_iterate.evaluation;
    if(m_system.are_steps_along_tangents())
    {
      m_iterate.u = m_system.move_from(std::move(m_iterate.u));
      evaluation = evaluate(Untangling_energy_3(m_epsilon, m_theta));
    }
    keep_best();
    if(evaluation.is_flip_free())
      return;
    m_epsilon = next_epsilon(m_epsilon, 1 - evaluation.energy / before.energy, before.smallest_determinant,
                             evaluation.smallest_determinant);
    evaluation = evaluate(Untangling_energy_3(m_epsilon, m_theta));
  }

  // A small epsilon no longer changes what the energy is. The last few cells take long, if their number does not fall by half
  // any more: patches then need less time.
  bool is_stuck() const
  {
    constexpr std::size_t patience = 15, patience_with_few = 4; // guesses; numbers of steps
    constexpr double small_epsilon = 1e-6; // a guess
    return m_iterate.step_length == 0 || m_steps_without_progress >= (m_epsilon < small_epsilon ? patience : 2 * patience)
        || (m_fewest_inverted_cells <= m_few_cells && m_steps_without_half >= patience_with_few);
  }

private:
  Energy_evaluation evaluate(const Untangling_energy_3& f) const
  { return m_system.evaluate(Cell_energy_of<Untangling_energy_3>(f), m_iterate.u); }

  void keep_best()
  {
    ++m_steps_without_progress;
    ++m_steps_without_half;
    if(m_iterate.evaluation.number_of_inverted_cells >= m_fewest_inverted_cells)
      return;
    m_fewest_inverted_cells = m_iterate.evaluation.number_of_inverted_cells;
    m_best = m_iterate.u;
    m_steps_without_progress = 0;
    if(2 * m_fewest_inverted_cells > m_halved_inverted_cells)
      return;
    m_halved_inverted_cells = m_fewest_inverted_cells;
    m_steps_without_half = 0;
  }

  Newton_system_3& m_system;
  double m_theta, m_solver_tolerance, m_epsilon;
  std::size_t m_few_cells;
  Newton_iterate_3 m_iterate;
  Matrix3Xd m_best;
  std::size_t m_fewest_inverted_cells, m_halved_inverted_cells;
  std::size_t m_steps_without_progress = 0, m_steps_without_half = 0;
};

// Untangles until no cell is inverted, or a few that are better left to patches. The result has the fewest inverted cells
// of all steps.
inline Newton_result_3 minimize_untangling_energy_3(Newton_system_3& system, const Matrix3Xd& positions,
                                                    const double theta, Progress_3& progress, const std::size_t few_cells = 0,
                                                    const double solver_tolerance = 1e-2,
                                                    const Reference_cells references = Reference_cells::SOURCE)
{
  system.set_references(references);
  Untangler_3 untangler(system, system.scale() * positions, theta, few_cells, solver_tolerance);
  const Newton_iterate_3& iterate = untangler.iterate();
  progress.end_start();
  const auto step = [&]
  {
    untangler.step(progress.budget());
    return step_of(iterate, Phase::UNTANGLING);
  };
  const auto status = [&]() -> std::optional<Error_code>
  {
    if(!iterate.direction.is_usable())
      return ERROR_LINEAR_SOLVER_FAILED;
    if(iterate.evaluation.is_flip_free())
      return OK;
    return untangler.is_stuck() ? std::optional(ERROR_NOT_FLIP_FREE) : std::nullopt;
  };
  const Error_code end = iterate.evaluation.is_flip_free() ? OK : progress.make_steps(false, step, status);
  return { untangler.best() / system.scale(), iterate.evaluation.energy, end, reason_of_end(end, iterate) };
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_MINIMIZE_UNTANGLING_ENERGY_3_H
