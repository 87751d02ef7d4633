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
  Matrix3Xd positions;   // after the step, if there is one
  Energy_evaluation evaluation;
};

// Where Newton's method stands, and the step that has led there.
struct Newton_iterate_3
{
  double unit = 1;               // of the system
  Matrix3Xd u = {};
  Energy_evaluation evaluation = {}; // of the energy that is minimized
  double energy_of_other_cells = 0; // that no unknown vertex belongs to
  Newton_direction_3 direction = {};
  double step_length = 0;

  Matrix3Xd positions() const { return u / unit; } // of all vertices, in the units of the user
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
    return true;
  }
};

// Backtracking along the direction from a first length, until the energy has fallen enough (Armijo's condition) and, if asked
// for, no cell is inverted and the norm of the gradient is below a bound.
inline Line_search_step_3 line_search_3(const Newton_system_3& system, const Cell_energy_3& energy,
                                        const Newton_iterate_3& iterate, const double first_length,
                                        const bool must_be_flip_free,
                                        const double gradient_bound = std::numeric_limits<double>::infinity())
{
  constexpr double sufficient_decrease = 1e-4;
  // a step much shorter than the energy alone asks for does not serve the gradient either
  const double smallest_length = std::isinf(gradient_bound) ? 1e-12 : 1e-3 * first_length;
  for(double length = first_length; length > smallest_length; length /= 2)
  {
    Matrix3Xd trial = iterate.u + length * iterate.direction.vectors;
    const Energy_evaluation evaluation = system.evaluate(energy, trial);
    if((!must_be_flip_free || evaluation.is_flip_free())
       && evaluation.energy <= iterate.evaluation.energy + sufficient_decrease * length * iterate.direction.slope
       && (std::isinf(gradient_bound) || system.gradient(energy, trial).norm() < gradient_bound))
      return { length, std::move(trial), evaluation };
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
    Matrix3Xd trial = iterate.u + doubled;
    const Energy_evaluation evaluation = system.evaluate(energy, trial);
    if(!evaluation.is_flip_free() || !(evaluation.energy < step.evaluation.energy)
       || system.largest_step(iterate.u, doubled) < 1)
      return step;
    step = { 2 * step.length, std::move(trial), evaluation };
  }
}

// The same, and beyond a full step where that has gained more than the Hessian promised.
inline Line_search_step_3 far_line_search_3(const Newton_system_3& system, const Cell_energy_3& energy,
                                            const Newton_iterate_3& iterate)
{
  Line_search_step_3 step = safe_line_search_3(system, energy, iterate);
  // a gain above half of the slope shows less curvature than the Hessian had
  if(step.length == 1 && step.evaluation.energy < iterate.evaluation.energy + 0.6 * iterate.direction.slope)
    return extrapolated(system, energy, iterate, std::move(step));
  return step;
}

// The part of the negative curvature that a Hessian keeps: between 0, which makes it positive
// semi-definite and serves far from the optimum, and 1, which makes it the full one and converges
// quadratically near it. Raised after a full step; lowered where the Hessian proves indefinite.
class Negative_curvature
{
public:
  explicit Negative_curvature(const double part = 0) : m_part(part) {}

  double part() const { return m_part; }

  // A failure also slows down the next rises.
  void lower()
  {
    m_part = m_part > 0.01 ? m_part / 4 : 0;
    m_growth = 1.5;
  }

  void raise()
  {
    m_part = (std::min)(1., (std::max)(0.1, m_growth * m_part));
    m_growth = (std::min)(4., 1.2 * m_growth);
  }

private:
  double m_part;
  double m_growth = 4;
};

// Where a Newton iteration has ended, and why.
struct Newton_result_3
{
  Matrix3Xd positions;     // the images of all vertices, in the units of the user
  double energy = 0;              // of all cells
  Error_code status = ERROR_NOT_CONVERGED;
  std::string reason = {};        // for the status; empty if there is nothing to add
};

// Asks `step(part)` for a step with as much negative curvature of the Hessian as serves, less of it where that fails.
template <typename Step>
bool step_with_some_curvature(Negative_curvature& negative_curvature, const Newton_iterate_3& iterate, const Step& step)
{
  while(!step(negative_curvature.part()))
  {
    if(negative_curvature.part() == 0 || iterate.direction.status == Linear_solver_status::OUT_OF_MEMORY)
      return false;
    negative_curvature.lower();
  }
  return true;
}

// What a visitor is told of it.
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

// Moves the unknown vertices to the minimum of the Dirichlet energy. As it is quadratic, one exact Newton step suffices;
// that of a solver which is not exact leaves about the squared tolerance of its gain. Then further steps with the same
// matrix follow, until no more than a part of the energy is left to gain, or the budget is exhausted. Returns the last
// direction, which is not usable if there was none.
inline Newton_direction_3 harmonic_map_3(Newton_system_3& system, Matrix3Xd& positions, Progress_3& progress,
                                         const double energy_tolerance = 1e-14)
{
  constexpr int maximal_number_of_steps = 20;
  const Dirichlet_energy_3 energy;
  const Cell_energy_of<Dirichlet_energy_3> dirichlet(energy);
  double tolerance = 1e-2;
  Matrix3Xd u = system.unit() * positions;
  if(progress.is_interrupted())
    return {};
  Newton_direction_3 direction = system.direction(dirichlet, u, 0., tolerance, progress.budget());
  for(int i = 1; direction.is_usable(); ++i)
  {
    u += direction.vectors;
    const double left = -direction.slope * tolerance * tolerance;
    const double allowed = energy_tolerance * system.evaluate(dirichlet, u).energy;
    if(left <= allowed || i == maximal_number_of_steps || progress.is_interrupted())
      break;
    tolerance = std::clamp(0.5 * std::sqrt(allowed / left), 1e-3, 1e-1);
    direction = system.next_direction(dirichlet, u, tolerance, progress.budget());
  }
  positions = u / system.unit();
  return direction;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_NEWTON_ITERATE_3_H
