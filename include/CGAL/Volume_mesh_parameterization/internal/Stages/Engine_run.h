// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_ENGINE_RUN_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_ENGINE_RUN_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <CGAL/Real_timer.h>

#include <boost/type_index.hpp>

#include <cstddef>
#include <iomanip>
#include <iostream>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// When to stop an engine that has not finished by itself.
struct Run_limits
{
  std::size_t number_of_iterations;
  double seconds;
  bool verbose;
};

inline void print(const Parameterization_step& step)
{
  std::cout << std::setw(5) << step.iteration
            << (step.phase == Phase::UNTANGLING ? " untangling  " : " minimization")
            << "  energy " << std::setw(12) << step.energy
            << "  inverted " << std::setw(6) << step.number_of_inverted_cells
            << "  gradient " << std::setw(11) << step.gradient_norm
            << "  step " << std::setw(9) << step.step_length
            << "  seconds " << step.seconds << std::endl;
}

// Runs one engine after another within the same limits, and counts steps and seconds. The number of
// steps is limited for each engine, the time for all.
template <typename Visitor>
class Engine_run
{
public:
  Engine_run(Visitor& visitor, const Run_limits& limits)
    : m_visitor(visitor), m_limits(limits)
  {
    m_timer.start();
  }

  double seconds() const { return m_timer.time(); }
  bool is_interrupted() const { return m_is_interrupted; }

  // Says what is going to be solved, and by which linear solver.
  template <typename Solver>
  void announce(const Numbered_mesh_3& mesh) const
  {
    if(m_limits.verbose)
      std::cout << mesh.cells.size() << " cells, " << mesh.number_of_vertices() << " vertices, "
                << mesh.number_of_free_vertices << " of them free; linear solver "
                << boost::typeindex::type_id<Solver>().pretty_name() << std::endl;
  }

  // The solver loop. Returns how it ended.
  template <typename Engine>
  Error_code run(Engine& engine, Parameterization_result& result)
  {
    while(engine.is_running())
    {
      if(engine.last_step().iteration >= m_limits.number_of_iterations)
        return engine.is_flip_free() ? ERROR_NOT_CONVERGED : ERROR_NOT_FLIP_FREE;
      const double begin = seconds();
      m_is_interrupted = begin > m_limits.seconds;
      if(m_is_interrupted)
        return ERROR_INTERRUPTED;

      engine.step();
      Parameterization_step step = engine.last_step();
      step.iteration = ++result.number_of_iterations;
      step.seconds = seconds();
      if(step.phase == Phase::UNTANGLING)
      {
        ++result.number_of_untangling_iterations;
        result.seconds_untangling += step.seconds - begin;
        result.seconds_to_flip_free = step.seconds;
      }
      else
        result.seconds_minimization += step.seconds - begin;

      if(m_limits.verbose)
        print(step);
      m_is_interrupted = !m_visitor.after_step(step);
      if(m_is_interrupted)
        return ERROR_INTERRUPTED;
    }
    return engine.status();
  }

private:
  Visitor& m_visitor;
  Run_limits m_limits;
  Real_timer m_timer;
  bool m_is_interrupted = false;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_ENGINE_RUN_H
