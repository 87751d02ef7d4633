// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_STAGE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_STAGE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Step_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_direction_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Found_map_3.h>

#include <Eigen/Core>

#include <string>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// One stage on the way to a map: ready to step as soon as it is constructed, then a Newton step at a time.
class Stage_3
{
public:
  virtual ~Stage_3() = default;

  virtual void step() = 0;                         // to be called while is_running()
  virtual Eigen::Matrix3Xd positions() const = 0;  // the images of all vertices, in the units of the target
  virtual bool is_flip_free() const = 0;           // by floating-point determinants

  bool is_running() const { return m_is_running; }
  Error_code status() const { return m_status; }
  const std::string& reason() const { return m_reason; } // for the status; empty if there is nothing to add
  const Parameterization_step& last_step() const { return m_step; }

protected:
  void end(const Error_code status, const std::string& reason = std::string())
  {
    m_status = status;
    m_reason = reason;
    m_is_running = false;
  }

  // Ends unless further steps make sense.
  void conclude(const Step_status status, const Error_code if_stuck, const Newton_direction_3& direction)
  {
    if(status == Step_status::DONE)
      end(OK);
    else if(status == Step_status::STUCK)
      end(if_stuck);
    else if(status == Step_status::SOLVER_FAILED)
      end(ERROR_LINEAR_SOLVER_FAILED, describe_failure(direction));
  }

  // What a visitor is told of an untangler or a minimizer, whose energy of the cells that do not move is given.
  template <typename Method>
  void report(const Phase phase, const Method& method, const double energy_of_other_cells = 0)
  {
    Parameterization_step& step = next_step(phase);
    step.energy = method.evaluation().energy + energy_of_other_cells;
    step.number_of_inverted_cells = method.evaluation().number_of_inverted_cells;
    step.gradient_norm = method.direction().gradient_norm;
    step.step_length = method.step_length();
  }

  // To be filled.
  Parameterization_step& next_step(const Phase phase)
  {
    ++m_step.iteration;
    m_step.phase = phase;
    return m_step;
  }

private:
  Parameterization_step m_step;
  Error_code m_status = ERROR_NOT_CONVERGED;
  std::string m_reason;
  bool m_is_running = true;
};

// Takes over how a stage ended, and its map with the verdict on it.
inline void take_over(const Stage_3& stage, const Error_code status, Map_3 map, Found_map_3& found)
{
  found.status = status;
  found.reason = status == stage.status() ? stage.reason() : std::string();
  found.map = std::move(map);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_STAGE_3_H
