// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_NEWTON_ITERATE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_NEWTON_ITERATE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Newton_system_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// A step along a direction.
struct Line_search_step_3
{
  double length = 0;            // 0 if no step was acceptable
  Matrix3Xd positions = {}; // after the step, if there is one
  Energy_evaluation evaluation = {};
  Matrix3Xd normals = {}; // of surfaces, and tangents of curves, at the positions
};

// Where Newton's method stands, and the step that has led there.
struct Newton_iterate_3
{
  double scale = 1;              // of the system
  Matrix3Xd u = {};
  Energy_evaluation evaluation = {}; // of the energy that is minimized
  double energy_of_other_cells = 0; // that no unknown vertex belongs to
  Matrix3Xd normals = {};        // of surfaces, and tangents of curves, after a step
  Newton_direction_3 direction = {};
  double step_length = 0;

  Matrix3Xd positions() const { return u / scale; } // of all vertices, in the units of the user
  double energy() const { return evaluation.energy + energy_of_other_cells; }

  // Moves along a direction, if it is usable, as far as `search()` finds. Returns whether there was an acceptable step.
  template <typename Search>
  bool move(Newton_direction_3 newton_direction, const Search& search)
  {
    direction = std::move(newton_direction);
    step_length = 0;
    if(!direction.is_usable())
      return false;
    Line_search_step_3 step = search();
    step_length = step.length;
    if(step.length == 0)
      return false;
    u = std::move(step.positions);
    evaluation = step.evaluation;
    normals = std::move(step.normals);
    return true;
  }
};

// Where a Newton iteration has ended, and why.
struct Newton_result_3
{
  Matrix3Xd positions;     // the images of all vertices, in the units of the user
  double energy = 0;              // of all cells
  Error_code status = ERROR_NOT_CONVERGED;
  std::string reason = {};        // for the status; empty if there is nothing to add
};

// Returns why an iteration has ended with a status, if there is something to add to it.
inline std::string reason_of_end(const Error_code status, const Newton_iterate_3& iterate)
{ return status == ERROR_LINEAR_SOLVER_FAILED ? describe_failure(iterate.direction) : ""; }

// Returns the report of a step to a visitor.
inline Parameterization_step step_of(const Newton_iterate_3& iterate, const Phase phase)
{
  Parameterization_step step;
  step.phase = phase;
  step.energy = iterate.energy();
  step.number_of_inverted_cells = iterate.evaluation.number_of_inverted_cells;
  step.gradient_norm = iterate.direction.gradient_norm;
  step.decrement = iterate.direction.decrement();
  step.step_length = iterate.step_length;
  return step;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_NEWTON_ITERATE_3_H
