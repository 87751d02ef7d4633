// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_METHOD_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_METHOD_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Linear_solver_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Cell_packs_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Energy_sum_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Quadratic_penalty_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Sliding_directions_3.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The parts of which untangling and minimization are made: a Newton direction and a line search
// for any energy, on one mesh, plus an optional quadratic penalty, with vertices that are free or that
// slide in given directions. The pattern of the Hessian is set, and analyzed, once.
template <typename ConcurrencyTag, typename Solver>
class Newton_method_3
{
public:
  using Positions = Eigen::Matrix3Xd;

  Newton_method_3(const Numbered_mesh_3& mesh,
                  const std::vector<Eigen::Matrix3d>& inverse_sources,
                  const std::vector<double>& weights,
                  Solver& solver,
                  const Quadratic_penalty_3* const penalty = nullptr,
                  const Sliding_directions_3* const directions = nullptr)
    : m_penalty(penalty),
      m_directions(directions),
      m_hessian(pattern(mesh)),
      m_packs(mesh, inverse_sources, weights, m_hessian),
      m_energy_sum(m_packs),
      m_solver(solver),
      m_direction(Positions::Constant(3, mesh.number_of_vertices(), -0.)) // adding 0. would turn -0. into 0.
  {
    m_solver.analyze_pattern(m_hessian);
  }

  const Cell_packs_3& packs() const { return m_packs; }

  template <typename Energy>
  Energy_evaluation evaluate(const Energy& energy, const Positions& u) const
  {
    Energy_evaluation evaluation = m_energy_sum.evaluate(energy, u);
    if(m_penalty != nullptr)
      evaluation.energy += m_penalty->value(u);
    return evaluation;
  }

  template <typename Energy>
  Positions gradient(const Energy& energy, const Positions& u) const
  {
    Positions result(3, m_hessian.size());
    m_energy_sum.compute_gradient(energy, u, result);
    if(m_penalty != nullptr)
      m_penalty->add_gradient(u, result);
    if(m_directions != nullptr)
      m_directions->project(result);
    return result;
  }

  // Solves H d = -g.
  template <typename Energy>
  Linear_solver_status compute_direction(const Energy& energy, const Positions& u,
                                         const double negative_curvature, const double tolerance)
  {
    m_energy_sum.assemble(energy, u, negative_curvature, m_gradient, m_hessian);
    if(m_penalty != nullptr)
    {
      m_penalty->add_gradient(u, m_gradient);
      m_penalty->add_hessian(m_hessian);
    }
    if(m_directions != nullptr)
    {
      m_directions->project(m_gradient);
      m_directions->project(m_hessian);
    }
    Linear_solver_status status = solve(tolerance);
    // a semi-definite matrix may fail to be definite by rounding
    for(double shift = 1e-8; shift < 1e-2 && negative_curvature == 0
                             && status == Linear_solver_status::NOT_POSITIVE_DEFINITE; shift *= 100)
    {
      m_hessian.scale_diagonal(static_cast<typename Solver::NT>(shift));
      status = solve(tolerance);
    }
    return status;
  }

  // One column a vertex; zero where the vertex is not free.
  const Positions& direction() const { return m_direction; }
  double gradient_norm() const { return m_gradient.norm(); }

  // The derivative of the energy along the direction; minus the squared Newton decrement.
  double slope() const { return m_slope; }

  struct Step
  {
    double length = 0;            // 0 if no step was acceptable
    Energy_evaluation evaluation; // after the step
  };

  // Backtracking: moves u along the direction until the energy has fallen enough (Armijo's
  // condition) and, if asked for, no cell is inverted and the norm of the gradient is below a bound.
  // Leaves u alone if there is no such step.
  template <typename Energy>
  Step line_search(const Energy& energy, Positions& u, const double current_energy,
                   const double first_length, const bool must_be_flip_free,
                   const double gradient_bound = std::numeric_limits<double>::infinity()) const
  {
    constexpr double sufficient_decrease = 1e-4;
    // a step much shorter than the energy alone asks for does not serve the gradient either
    const double smallest_length = std::isinf(gradient_bound) ? 1e-12 : 1e-3 * first_length;
    Step step;
    for(double length = first_length; length > smallest_length; length /= 2)
    {
      const Positions trial = u + length * m_direction;
      const Energy_evaluation evaluation = evaluate(energy, trial);
      if((!must_be_flip_free || evaluation.is_flip_free())
         && evaluation.energy <= current_energy + sufficient_decrease * length * m_slope
         && (std::isinf(gradient_bound) || gradient(energy, trial).norm() < gradient_bound))
      {
        u = trial;
        step.length = length;
        step.evaluation = evaluation;
        return step;
      }
    }
    return step;
  }

  // Doubles a step that led from `origin` to u as long as the energy falls and no cell is inverted.
  template <typename Energy>
  void extrapolate(const Energy& energy, const Positions& origin, Positions& u, Step& step) const
  {
    while(true)
    {
      const Positions trial = origin + 2 * step.length * m_direction;
      const Energy_evaluation evaluation = evaluate(energy, trial);
      if(!evaluation.is_flip_free() || !(evaluation.energy < step.evaluation.energy))
        return;
      u = trial;
      step.length *= 2;
      step.evaluation = evaluation;
    }
  }

private:
  using NT = typename Solver::NT;

  Block_sparse_matrix_3<NT> pattern(const Numbered_mesh_3& mesh) const
  {
    Block_sparse_matrix_3<NT> matrix;
    set_pattern(mesh, m_penalty == nullptr ? std::vector<std::vector<int> >() : m_penalty->groups(), matrix);
    return matrix;
  }

  Linear_solver_status solve(const double tolerance)
  {
    Linear_solver_status status = m_solver.factorize(m_hessian);
    if(status != Linear_solver_status::SUCCESS)
      return status;
    const Eigen::Map<const Eigen::VectorXd> gradient(m_gradient.data(), m_gradient.size());
    Eigen::VectorXd solution;
    status = m_solver.solve(-gradient, solution, tolerance);
    if(status == Linear_solver_status::SUCCESS || status == Linear_solver_status::TRUNCATED)
    {
      m_direction.leftCols(m_gradient.cols()) = Eigen::Map<const Positions>(solution.data(), 3, m_gradient.cols());
      if(m_directions != nullptr)
        m_directions->project(m_direction);
      m_slope = gradient.dot(solution);
    }
    return status;
  }

  const Quadratic_penalty_3* m_penalty;
  const Sliding_directions_3* m_directions;
  Block_sparse_matrix_3<NT> m_hessian;
  Cell_packs_3 m_packs;
  Energy_sum_3<ConcurrencyTag> m_energy_sum;
  Solver& m_solver;
  Positions m_gradient, m_direction;
  double m_slope = 0;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_METHOD_3_H
