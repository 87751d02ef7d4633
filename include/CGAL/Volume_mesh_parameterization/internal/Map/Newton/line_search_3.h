// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_LINE_SEARCH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_LINE_SEARCH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Newton_iterate_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Backtracking along the direction from a first length, until the energy has fallen enough (Armijo's condition) and, if asked
// for, no cell is inverted and the norm of the gradient is below a bound. A boundary that is kept embedded is so after the step.
inline Line_search_step_3 line_search_3(const Newton_system_3& system, const Cell_energy_3& energy,
                                        const Newton_iterate_3& iterate, const double first_length,
                                        const bool must_be_flip_free,
                                        const double gradient_bound = std::numeric_limits<double>::infinity())
{
  constexpr double sufficient_decrease = 1e-4; // Armijo's condition; the usual part of the slope
  // a step much shorter than the energy alone asks for serves neither the gradient nor the boundary
  const bool is_energy_alone = std::isinf(gradient_bound) && !system.is_boundary_kept_embedded();
  const double smallest_length = is_energy_alone ? 1e-12 : 1e-3 * first_length;
  for(double length = first_length; length > smallest_length; length /= 2)
  {
    auto [trial, normals] = system.moved(iterate.u, length, iterate.direction.vectors);
    const Energy_evaluation evaluation = system.evaluate(energy, trial);
    if((!must_be_flip_free || evaluation.is_flip_free())
       && evaluation.energy <= iterate.evaluation.energy + sufficient_decrease * length * iterate.direction.slope
       && (std::isinf(gradient_bound) || system.gradient(energy, trial).norm() < gradient_bound)
       && system.is_boundary_embedded(trial, normals))
      return { length, std::move(trial), evaluation, std::move(normals) };
  }
  return {};
}

// Backtracking that never inverts a cell: from a full step, or from near the longest one that inverts none.
inline Line_search_step_3 safe_line_search_3(const Newton_system_3& system, const Cell_energy_3& energy,
                                             const Newton_iterate_3& iterate,
                                             const double gradient_bound = std::numeric_limits<double>::infinity())
{
  constexpr double safety = 0.9; // stays away from flat cells
  const double largest = system.largest_step(iterate.u, iterate.direction.vectors);
  return line_search_3(system, energy, iterate, largest < 1 ? safety * largest : 1., true, gradient_bound);
}

// Doubles a step as long as the energy falls and no cell is inverted, not even on the way: a cell that is turned twice is
// positive again, but facets that slide in the boundary may have been turned over with it.
inline Line_search_step_3 extrapolated(const Newton_system_3& system, const Cell_energy_3& energy,
                                       const Newton_iterate_3& iterate, Line_search_step_3 step)
{
  while(true)
  {
    const Matrix3Xd doubled = 2 * step.length * iterate.direction.vectors;
    auto [trial, normals] = system.moved(iterate.u, 1, doubled);
    const Energy_evaluation evaluation = system.evaluate(energy, trial);
    if(!evaluation.is_flip_free() || !(evaluation.energy < step.evaluation.energy)
       || system.largest_step(iterate.u, doubled) < 1 || !system.is_boundary_embedded(trial, normals))
      return step;
    step = { 2 * step.length, std::move(trial), evaluation, std::move(normals) };
  }
}

// Searches as above, and beyond a full step where that has gained more than the Hessian promised.
inline Line_search_step_3 far_line_search_3(const Newton_system_3& system, const Cell_energy_3& energy,
                                            const Newton_iterate_3& iterate)
{
  Line_search_step_3 step = safe_line_search_3(system, energy, iterate);
  // a gain above half of the slope shows less curvature than the Hessian had
  if(step.length == 1 && step.evaluation.energy < iterate.evaluation.energy + 0.6 * iterate.direction.slope)
    return extrapolated(system, energy, iterate, std::move(step));
  return step;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_LINE_SEARCH_3_H
