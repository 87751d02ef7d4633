// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_MINIMIZE_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_MINIMIZE_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/line_search_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Negative_curvature.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Below this energy, what is left to gain counts as it is, and not relative to the energy, which may have the minimum 0:
// an eighteenth of the trace of the Hessian at the identity, 1 for the stretch. So factors of psi do not matter.
inline double scale_of(const Cell_energy_3& energy)
{
  Packed_vector_3 s, g;
  Packed_matrix_3 H;
  for(Packed_number& x : s)
    std::fill(std::begin(x), std::end(x), 1.);
  energy.derivatives(s, g, H);
  const double scale = (H[0][0] + H[4][0] + H[8][0]) / 18;
  return std::isfinite(scale) && scale > 0 ? scale : 0;
}

// Minimizes an energy by Newton steps that never invert a cell.
class Minimizer_3
{
public:
  Minimizer_3(Newton_system_3& system, const Cell_energy_3& energy, const Matrix3Xd& positions,
              const Negative_curvature& negative_curvature)
    : m_system(system), m_energy(energy), m_scale(scale_of(energy)), m_iterate{ system.scale(), system.scale() * positions },
      m_negative_curvature(negative_curvature)
  {
    m_iterate.evaluation = system.evaluate(energy, m_iterate.u);
    m_iterate.energy_of_other_cells = system.energy_of_other_cells(energy, m_iterate.u);
    system.move_from(m_iterate.u);
  }

  const Newton_iterate_3& iterate() const { return m_iterate; }
  double slope() const { return m_iterate.direction.slope; }

  // The full Hessian is tried, or a part of its negative curvature; less of it where that fails.
  void step(const Budget& budget)
  {
    step_with_some_curvature(m_negative_curvature, m_iterate, [&](const double part) { return move(part, budget); });
    // far from the minimum, the semi-definite Hessian does as well, and the full one mostly proves indefinite
    if(m_iterate.step_length >= 1 && -m_iterate.direction.slope < 0.1 * m_iterate.evaluation.energy)
      m_negative_curvature.raise();
  }

  // Takes what a minimization of a part of the energy found.
  void take(const Newton_iterate_3& part)
  {
    m_iterate.u = part.u;
    m_iterate.evaluation = m_system.evaluate(m_energy, m_iterate.u);
    m_system.move_from(m_iterate.u);
  }

  // If the body may turn, the matrix is singular. It may then fail to be definite where the gradient is nothing but rounding.
  bool is_converged(const double negligible_gain) const
  {
    constexpr double rounding = 1e-20; // a guess; relative to the energy, far above the square of the precision
    return (m_iterate.direction.is_exact() && relative_gain() <= negligible_gain)
        || m_iterate.direction.gain_of_single_vertices <= rounding * least_energy();
  }

private:
  bool move(const double negative_curvature, const Budget& budget)
  {
    constexpr double short_step = 1. / 16; // a guess; where vertices that a fold of their surface holds shorten steps
    constexpr int number_of_trials = 4; // a guess; each with more vertices held
    bool has_moved = false;
    for(int trial = 0; trial < number_of_trials; ++trial)
    {
      has_moved = try_to_move(negative_curvature, budget) || has_moved;
      if(m_iterate.step_length >= short_step || !m_iterate.direction.is_usable()
         || !m_system.hold_stuck_vertices(m_energy, m_iterate.u, short_step, m_iterate.direction.vectors))
        break;
    }
    return has_moved;
  }

  bool try_to_move(const double negative_curvature, const Budget& budget)
  {
    const bool has_moved
      = m_iterate.move(m_system.direction(m_energy, m_iterate.u, negative_curvature, solver_tolerance(), budget),
                       [this] { return far_line_search_3(m_system, m_energy, m_iterate); });
    if(has_moved)
      m_system.set_normals(m_iterate.normals);
    return has_moved;
  }

  // The squared Newton decrement, which bounds what a step can gain, relative to the energy. Nothing is to be gained
  // of an energy that is 0 everywhere.
  double relative_gain() const
  {
    const double slope = m_iterate.direction.slope;
    return slope == 0 ? 0 : -slope / least_energy();
  }

  double least_energy() const { return (std::max)(m_scale, m_iterate.evaluation.energy); }

  // Tighter as the minimum is near, so that the last step meets it (Eisenstat and Walker, Choosing the forcing terms in an
  // inexact Newton method, SIAM Journal on Scientific Computing 17, 1996).
  double solver_tolerance() const
  {
    constexpr double smallest = 1e-4, largest = 1e-2; // guesses
    return relative_gain() > 0 ? std::clamp(std::sqrt(relative_gain()), smallest, largest) : largest;
  }

  Newton_system_3& m_system;
  const Cell_energy_3& m_energy;
  double m_scale;
  Newton_iterate_3 m_iterate;
  Negative_curvature m_negative_curvature;
};

// The unknowns that hold most of what a step gains, with rings of others that make room for them, if they are few.
inline std::optional<Unknowns_3> steepest_unknowns_3(const Newton_system_3& system, const Newton_direction_3& direction)
{
  constexpr double large_part = 0.9, few_rows = 0.01, few_unknowns = 0.1; // guesses; parts of the slope and of the unknowns
  constexpr int number_of_rings = 5; // a guess
  const Unknowns_3& unknowns = system.unknowns();
  std::vector<int> rows(unknowns.size());
  std::iota(rows.begin(), rows.end(), 0);
  const auto end = rows.begin() + static_cast<std::ptrdiff_t>(few_rows * unknowns.size());
  std::partial_sort(rows.begin(), end, rows.end(), [&](const int a, const int b)
  { return std::make_pair(direction.slopes[a], a) < std::make_pair(direction.slopes[b], b); });
  double slope = 0;
  std::vector<bool> is_near(unknowns.number_of_vertices());
  for(auto row = rows.begin(); row != end && slope > large_part * direction.slope; ++row)
  {
    slope += direction.slopes[*row];
    is_near[unknowns.vertex(*row)] = true;
  }
  std::optional<Unknowns_3> result;
  for(int ring = 0; ring < number_of_rings && slope <= large_part * direction.slope; ++ring)
  {
    const std::vector<bool> was_near = is_near;
    for(const std::array<int, 4>& cell : system.mesh().cells)
      if(std::any_of(cell.begin(), cell.end(), [&](const int v) { return was_near[v]; }))
        for(const int v : cell)
          is_near[v] = true;
    Unknowns_3 near = unknowns.without([&](const int v) { return !is_near[v]; });
    if(near.size() > few_unknowns * unknowns.size())
      break;
    result = std::move(near);
  }
  return result;
}

// Where few unknowns hold most of what a step gains, they move alone until they hold a tenth of it, or have taken about as
// long as the step: cells that are nearly flat need many steps, over the whole mesh, too, but steps of few cost little.
inline void minimize_steepest_3(Newton_system_3& system, const Cell_energy_3& energy, Minimizer_3& minimizer, const Budget& budget)
{
  constexpr int maximum_number_of_steps = 30; // a guess
  constexpr double sufficient_part = 0.1; // a guess
  std::optional<Unknowns_3> steepest = steepest_unknowns_3(system, minimizer.iterate().direction);
  if(!steepest)
    return;
  const int number_of_steps = (std::min)(maximum_number_of_steps, system.unknowns().size() / steepest->size());
  Conjugate_gradient_solver_traits_3<Sequential_tag, double> traits;
  Linear_solver_of solver(traits);
  Newton_system_3 part(system, std::move(*steepest), solver);
  Minimizer_3 moves(part, energy, minimizer.iterate().positions(), Negative_curvature());
  for(int step = 0; step < number_of_steps && !budget.is_exhausted(); ++step)
  {
    moves.step(budget);
    if(moves.iterate().step_length == 0 || moves.slope() > sufficient_part * minimizer.slope())
      break;
  }
  minimizer.take(moves.iterate());
}

// Returns the status with which to end after a step, although it is no minimum, or none to continue.
using Ends_here = std::function<std::optional<Error_code>(const Newton_iterate_3&)>;

// Minimizes from images on that invert no cell; vertices that are not unknown stay where they are. The first step that
// promises no more than the negligible part of the energy is the last one: the next one would gain about its square.
inline Newton_result_3 minimize_energy_3(Newton_system_3& system, const Cell_energy_3& energy,
                                         const Matrix3Xd& positions, Progress_3& progress,
                                         const Negative_curvature& negative_curvature = Negative_curvature(),
                                         const Ends_here& ends_here = nullptr, const double negligible_gain = 1e-8)
{
  constexpr double small_gain = 1e-3; // a guess; that vertices at folds of a surface may promise in vain
  system.set_references(Reference_cells::SOURCE);
  Minimizer_3 minimizer(system, energy, positions, negative_curvature);
  const Newton_iterate_3& iterate = minimizer.iterate();
  progress.end_start();
  const auto step = [&]
  {
    minimizer.step(progress.budget());
    return step_of(iterate, Phase::MINIMIZATION);
  };
  std::string reason;
  const auto status = [&]() -> std::optional<Error_code>
  {
    if(minimizer.is_converged(negligible_gain))
      return OK;
    if(!iterate.direction.is_usable())
      return ERROR_LINEAR_SOLVER_FAILED;
    if(iterate.step_length == 0 && are_some_on_surfaces(system.unknowns().conditions()))
    {
      reason = "No step lowers the energy, because vertices meet folds of their surface. A finer surface has smaller folds.";
      return minimizer.is_converged(small_gain) ? OK : ERROR_NOT_CONVERGED;
    }
    if(iterate.step_length == 0)
    {
      reason = "No step along the Newton direction lowers the energy. If the energy is your own, check_derivatives() compares its "
               "derivatives with differences.";
      return ERROR_NOT_CONVERGED;
    }
    if(system.mesh().is_whole() && !system.has_penalty())
      minimize_steepest_3(system, energy, minimizer, progress.budget());
    return ends_here ? ends_here(iterate) : std::nullopt;
  };
  const Error_code end = progress.make_steps(true, step, status);
  return { iterate.positions(), iterate.energy(), end, reason.empty() ? reason_of_end(end, iterate) : reason };
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_MINIMIZE_ENERGY_3_H
