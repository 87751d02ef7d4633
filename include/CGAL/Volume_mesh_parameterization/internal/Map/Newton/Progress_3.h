// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_PROGRESS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_PROGRESS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#include <optional>

namespace CGAL::Volume_mesh_parameterization::internal {

// Decides before each step of a loop whether the loop may continue: the clock, the user and the number of steps limit it. After
// the step, it gets a report. If several processes share a mesh, all ask together, and get one answer.
class Progress_3
{
public:
  using Visitor = std::function<bool(const Parameterization_step&)>; // returns false to end the computation

  // The number of steps is limited for each stage, the budget is for all.
  Progress_3(Budget budget, const std::size_t steps_of_stage,
             Visitor visitor = [](const Parameterization_step&) { return true; },
             const Communicator_3& communicator = single_process())
    : m_whole_budget(std::move(budget)), m_budget(m_whole_budget), m_limit(steps_of_stage), m_visitor(std::move(visitor)),
      m_communicator(communicator)
  {}

  const Budget& budget() const { return m_budget; } // of this process, for loops that it runs alone
  double seconds() const { return m_budget.seconds(); }

  // Limits what follows to a part of the time that is left, or to all of it.
  void limit_to_part_of_time(const double part)
  {
    m_budget = part < 1 ? m_whole_budget.part(part) : m_whole_budget;
    m_is_interrupted = false;
  }

  const Parameterization_result& effort() const { return m_effort; } // only with the numbers of steps, and the seconds
  std::size_t number_of_steps() const { return m_number_of_steps; } // of this stage

  void begin_stage() { m_number_of_steps = 0; }
  void begin_attempt(std::string name) { m_attempt = std::move(name); } // for visitors

  bool is_interrupted()
  {
    if(!m_is_interrupted)
      m_is_interrupted = !m_communicator.all(!m_budget.is_exhausted());
    return m_is_interrupted;
  }

  // Returns whether an answer of is_interrupted() has ended a loop; does not ask the clock.
  bool has_ended_a_loop() const { return m_is_interrupted; }

  bool may_continue() { return m_number_of_steps < m_limit && !is_interrupted(); }

  // Returns how a loop ends that may not continue.
  Error_code status_of_end(const bool is_flip_free) const
  { return m_is_interrupted ? ERROR_INTERRUPTED : is_flip_free ? ERROR_NOT_CONVERGED : ERROR_NOT_FLIP_FREE; }

  // Makes steps until `status()` returns one with which to end, or they may not continue. `step()` returns its report.
  template <typename Step, typename Status>
  Error_code make_steps(const bool is_flip_free, const Step& step, const Status& status)
  {
    while(may_continue())
    {
      after_step(step());
      if(const std::optional<Error_code> end = status())
        return *end;
    }
    return status_of_end(is_flip_free);
  }

  void after_step(Parameterization_step step)
  {
    ++m_number_of_steps;
    step.iteration = ++m_effort.number_of_iterations;
    step.attempt = m_attempt;
    if(step.phase == Phase::UNTANGLING)
    {
      ++m_effort.number_of_untangling_iterations;
      add_lap(m_effort.seconds_untangling);
      reach_flip_free();
    }
    else
      add_lap(m_effort.seconds_minimization);
    step.seconds = seconds();
    if(!m_visitor(step))
      m_whole_budget.exhaust();
  }

  // The time since the last step, or the last call of one of these, was taken by something else.
  void end_numbering() { add_lap(m_effort.seconds_numbering); }
  void end_boundary() { add_lap(m_effort.seconds_boundary); }
  void end_start() { add_lap(m_effort.seconds_start); }
  void end_check() { m_lap = seconds(); }

  // Notes that no cell is inverted from now on, or from the next step that untangles on, or was from a time on.
  void reach_flip_free() { reach_flip_free(seconds()); }
  void reach_flip_free(const double time) { m_effort.seconds_to_flip_free = time; }

private:
  void add_lap(double& sum)
  {
    sum += seconds() - m_lap;
    m_lap = seconds();
  }

  Budget m_whole_budget, m_budget; // of all stages, and of the next ones
  std::size_t m_limit, m_number_of_steps = 0;
  Visitor m_visitor;
  const Communicator_3& m_communicator;
  std::string m_attempt;
  Parameterization_result m_effort;
  double m_lap = 0;
  bool m_is_interrupted = false;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_PROGRESS_3_H
