// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_PROGRESS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_PROGRESS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Stage_3.h>

#include <CGAL/Real_timer.h>

#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// Newton steps and wall-clock seconds of all stages so far, as in `Parameterization_result`.
struct Effort_3
{
  std::size_t number_of_iterations = 0;
  std::size_t number_of_untangling_iterations = 0;
  double seconds_to_flip_free = 0;
  double seconds_numbering = 0;
  double seconds_start = 0;
  double seconds_untangling = 0;
  double seconds_minimization = 0;
};

// Runs one stage after another within the same limits, tells a visitor, and counts steps and seconds.
class Progress_3
{
public:
  using Visitor = std::function<bool(const Parameterization_step&)>; // returns false to end the computation

  // The number of steps is limited for each stage, the time for all.
  Progress_3(Visitor visitor, const std::size_t number_of_iterations, const double seconds)
    : m_visitor(std::move(visitor)), m_number_of_iterations(number_of_iterations), m_seconds(seconds)
  {
    m_timer.start();
  }

  double seconds() const { return m_timer.time(); }
  bool is_interrupted() const { return m_is_interrupted; }
  const Effort_3& effort() const { return m_effort; }

  // The solver loop, for a stage whose set-up began at that time. Returns how it ended. A stage that goes on with another
  // one's work goes on with its number of steps as well.
  Error_code run(Stage_3& stage, const double begin, const std::size_t number_of_steps_before = 0)
  {
    m_effort.seconds_start += seconds() - begin;
    while(stage.is_running())
    {
      if(stage.last_step().iteration + number_of_steps_before >= m_number_of_iterations)
        return stage.is_flip_free() ? ERROR_NOT_CONVERGED : ERROR_NOT_FLIP_FREE;
      if(!take_step(stage))
        return ERROR_INTERRUPTED;
    }
    return stage.status();
  }

  void add_numbering(const double begin) { m_effort.seconds_numbering += seconds() - begin; }

  // From now on, or from the next step that untangles on, no cell is inverted.
  void reach_flip_free() { m_effort.seconds_to_flip_free = seconds(); }

private:
  bool take_step(Stage_3& stage)
  {
    const double begin = seconds();
    m_is_interrupted = begin > m_seconds;
    if(m_is_interrupted)
      return false;

    stage.step();
    Parameterization_step step = stage.last_step();
    step.iteration = ++m_effort.number_of_iterations;
    step.seconds = seconds();
    if(step.phase == Phase::UNTANGLING)
    {
      ++m_effort.number_of_untangling_iterations;
      m_effort.seconds_untangling += step.seconds - begin;
      m_effort.seconds_to_flip_free = step.seconds;
    }
    else
      m_effort.seconds_minimization += step.seconds - begin;
    m_is_interrupted = !m_visitor(step);
    return !m_is_interrupted;
  }

  Visitor m_visitor;
  std::size_t m_number_of_iterations;
  double m_seconds;
  Real_timer m_timer;
  Effort_3 m_effort;
  bool m_is_interrupted = false;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_PROGRESS_3_H
