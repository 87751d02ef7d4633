// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_NEWTON_SYSTEM_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_NEWTON_SYSTEM_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Linear_solver_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Parallel/Communicator_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Scaled_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Cell_packs_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Quadratic_penalty_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_direction_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Sparsity_pattern_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/sum_over_cells_3.h>

#include <Eigen/Core>

#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// An energy of the cells, plus perhaps a penalty, as a function of the unknown vertices: its value and gradient, and the
// Newton direction, for any energy. The pattern of the Hessian is set and analyzed once; the linear solver belongs
// to the system that was made last.
class Newton_system_3
{
public:
  using Positions = Eigen::Matrix3Xd;

  Newton_system_3(const Numbered_mesh_3& mesh, const Scaled_cells_3& scaled, Unknowns_3 unknowns,
                  Linear_solver_3& solver, const bool is_parallel, const Quadratic_penalty_3* const penalty = nullptr)
    : m_communicator(*mesh.communicator),
      m_number_of_own_rows(unknowns.size() - mesh.number_of_copied_vertices),
      m_unknowns(std::move(unknowns)),
      m_penalty(penalty),
      m_unit(scaled.unit),
      m_hessian(solver.make_matrix()),
      m_pattern(sparsity_pattern_3(mesh, m_unknowns, penalty == nullptr ? std::vector<std::vector<int> >()
                                                                        : penalty->groups())),
      m_packs(mesh, scaled, m_unknowns, m_pattern),
      m_solver(solver),
      m_is_parallel(is_parallel)
  {
    std::visit([&](auto& hessian) { hessian.set_pattern(std::move(m_pattern.row_begin), std::move(m_pattern.columns)); },
               m_hessian);
    claim_solver();
  }

  const Unknowns_3& unknowns() const { return m_unknowns; }
  double unit() const { return m_unit; } // by which positions are multiplied

  // Takes these reference cells, of the same mesh and with the same unit, from now on.
  void set_references(const Numbered_mesh_3& mesh, const Scaled_cells_3& scaled)
  {
    m_packs.set_references(mesh, scaled, m_unknowns);
  }

  // Takes the linear solver back, after another system has used it.
  void claim_solver() { m_solver.analyze_pattern(m_hessian); }

  Energy_evaluation evaluate(const Cell_energy_3& energy, const Positions& u) const
  {
    Energy_evaluation evaluation = sum(m_communicator, evaluate_energy(m_packs, energy, u, m_is_parallel));
    if(m_penalty != nullptr)
      evaluation.energy += m_penalty->value(u);
    return evaluation;
  }

  // The energy of the cells that no unknown vertex belongs to.
  double energy_of_other_cells(const Cell_energy_3& energy, const Positions& u) const
  {
    Energy_evaluation evaluation;
    cell_kernels_3().evaluate(m_packs.others_begin(), m_packs.others_end(), u.data(), energy, evaluation);
    return m_communicator.sum(evaluation.energy);
  }

  // One column a row.
  Positions gradient(const Cell_energy_3& energy, const Positions& u) const
  {
    Positions result = Positions::Zero(3, m_unknowns.size());
    add_energy_gradient(m_packs, energy, u, m_is_parallel, result);
    if(m_penalty != nullptr)
      m_penalty->add_gradient(u, result);
    m_unknowns.project(result);
    return result;
  }

  // Solves H d = -g, where H keeps the part `negative_curvature` of negative eigenvalues of each cell.
  Newton_direction_3 direction(const Cell_energy_3& energy, const Positions& u, const double negative_curvature,
                               const double tolerance)
  {
    return std::visit([&](auto& hessian)
    {
      Positions gradient;
      assemble(energy, u, negative_curvature, gradient, hessian);
      Newton_direction_3 direction = solve(gradient, tolerance);
      // a semi-definite matrix may fail to be definite by rounding
      for(double shift = 1e-8; shift < 1e-2 && negative_curvature == 0
                               && direction.status == Linear_solver_status::NOT_POSITIVE_DEFINITE; shift *= 100)
      {
        hessian.scale_diagonal(static_cast<typename std::decay_t<decltype(hessian)>::NT>(shift));
        direction = solve(gradient, tolerance);
      }
      direction.is_of_semidefinite_matrix = negative_curvature == 0;
      return direction;
    }, m_hessian);
  }

  // The same with the matrix of the last direction, which a convex quadratic energy has everywhere.
  Newton_direction_3 next_direction(const Cell_energy_3& energy, const Positions& u, const double tolerance)
  {
    Newton_direction_3 direction = solve(gradient(energy, u), tolerance, true);
    direction.is_of_semidefinite_matrix = true;
    return direction;
  }

  // The largest t in [0, 1] for which u + t d inverts no cell, if u inverts none.
  double largest_step(const Positions& u, const Positions& d) const
  {
    return m_communicator.minimum(largest_step_3(m_packs, u, d, m_is_parallel));
  }

private:
  template <typename NT>
  void assemble(const Cell_energy_3& energy, const Positions& u, const double negative_curvature,
                Positions& gradient, Block_sparse_matrix_3<NT>& hessian) const
  {
    assemble_energy(m_packs, energy, u, negative_curvature, m_is_parallel, gradient, hessian);
    if(m_penalty != nullptr)
    {
      m_penalty->add_gradient(u, gradient);
      m_penalty->add_hessian(hessian);
    }
    m_unknowns.project(gradient);
    m_unknowns.project(hessian);
  }

  Newton_direction_3 solve(const Positions& columns, const double tolerance, const bool is_factorized = false)
  {
    const Eigen::Map<const Eigen::VectorXd> gradient(columns.data(), columns.size());
    Newton_direction_3 result;
    result.gradient_norm = std::sqrt(dot(gradient, gradient));
    result.status = is_factorized ? Linear_solver_status::SUCCESS : m_solver.factorize(m_hessian);
    if(result.status != Linear_solver_status::SUCCESS)
      return result;
    Eigen::VectorXd solution;
    result.status = m_solver.solve(-gradient, solution, tolerance);
    if(result.status == Linear_solver_status::SUCCESS || result.status == Linear_solver_status::TRUNCATED)
    {
      result.slope = dot(gradient, solution);
      if(!(result.slope < 0) && result.gradient_norm > 0) // otherwise it would pass for a minimum
        result.status = Linear_solver_status::NOT_POSITIVE_DEFINITE;
      Positions direction = Eigen::Map<const Positions>(solution.data(), 3, columns.cols());
      m_unknowns.project(direction);
      result.vectors = m_unknowns.to_vertices(direction);
    }
    return result;
  }

  // of all rows, each counted by the process that owns it
  template <typename A, typename B>
  double dot(const A& a, const B& b) const
  {
    const Eigen::Index n = 3 * Eigen::Index(m_number_of_own_rows);
    return m_communicator.sum(a.head(n).dot(b.head(n)));
  }

  const Communicator_3& m_communicator;
  int m_number_of_own_rows; // they come first; the others are copies
  Unknowns_3 m_unknowns;
  const Quadratic_penalty_3* m_penalty;
  double m_unit;
  Newton_matrix_3 m_hessian;
  Sparsity_pattern_3 m_pattern; // of the matrix, which takes it over
  Cell_packs_3 m_packs;
  Linear_solver_3& m_solver;
  bool m_is_parallel;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_NEWTON_SYSTEM_3_H
