// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RUN_ENGINE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RUN_ENGINE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>

#include <CGAL/Real_timer.h>

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

// The solver loop. Returns how it ended; `seconds_to_flip_free` is measured by the timer.
template <typename Engine, typename Visitor>
Error_code run_engine(Engine& engine, Visitor& visitor, const Run_limits& limits,
                      const Real_timer& timer, double& seconds_to_flip_free)
{
  seconds_to_flip_free = timer.time();
  while(engine.is_running())
  {
    if(engine.last_step().iteration >= limits.number_of_iterations)
      return engine.is_flip_free() ? ERROR_NOT_CONVERGED : ERROR_NOT_FLIP_FREE;
    if(timer.time() > limits.seconds)
      return ERROR_INTERRUPTED;

    const bool was_flip_free = engine.is_flip_free();
    engine.step();
    if(!was_flip_free)
      seconds_to_flip_free = timer.time();

    Parameterization_step step = engine.last_step();
    step.seconds = timer.time();
    if(limits.verbose)
      print(step);
    if(!visitor.after_step(step))
      return ERROR_INTERRUPTED;
  }
  return engine.status();
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RUN_ENGINE_H
