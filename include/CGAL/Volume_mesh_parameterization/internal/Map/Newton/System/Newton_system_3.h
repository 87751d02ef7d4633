// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_NEWTON_SYSTEM_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_NEWTON_SYSTEM_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Direct_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Embedded_boundary_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Newton_direction_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Quadratic_penalty_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/sums_over_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Solvers/Conjugate_gradient_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// An energy of the cells, plus perhaps a penalty, as a function of the unknown vertices: its value and gradient, and the
// Newton direction, for any energy. Its positions `u` are images multiplied by a scale that gives cells a volume near 1;
// only what is below Newton/ knows them.
class Newton_system_3
{
public:
  using Positions = Matrix3Xd;

  // Takes the cells of the source as reference.
  Newton_system_3(const Numbered_mesh_3& mesh, Unknowns_3 unknowns, Linear_solver_3& solver)
    : Newton_system_3(mesh, cells_scaled_to_target(mesh), std::move(unknowns), solver)
  {}

  Newton_system_3(const Numbered_mesh_3& mesh, Scaled_cells_3 scaled, Unknowns_3 unknowns,
                  Linear_solver_3& solver, const Quadratic_penalty_3* const penalty = nullptr)
    : m_mesh(mesh), m_communicator(*mesh.communicator), m_solver(solver),
      m_number_of_own_rows(unknowns.size() - mesh.number_of_copied_vertices), m_unknowns(std::move(unknowns)),
      m_penalty(penalty), m_scale(scaled.scale),
      m_pattern(sparsity_pattern_3(mesh, m_unknowns, penalty == nullptr ? Groups_of_vertices() : penalty->groups())),
      m_packs(mesh, std::move(scaled), m_unknowns, m_pattern), m_system(solver.make_system(std::move(m_pattern), m_communicator))
  {}

  // Some of the unknowns of a system of one process without a penalty, with the cells around them only.
  Newton_system_3(const Newton_system_3& whole, Unknowns_3 some, Linear_solver_3& solver)
    : m_mesh(whole.m_mesh), m_communicator(whole.m_communicator), m_solver(solver), m_number_of_own_rows(some.size()),
      m_unknowns(std::move(some)), m_boundary(whole.m_boundary), m_penalty(nullptr), m_scale(whole.m_scale),
      m_pattern(sparsity_pattern_3(m_mesh, m_unknowns)), m_packs(whole.m_packs, m_unknowns, m_pattern),
      m_system(solver.make_system(std::move(m_pattern), m_communicator))
  {}

  const Numbered_mesh_3& mesh() const { return m_mesh; }
  Linear_solver_3& solver() const { return m_solver; }
  const Unknowns_3& unknowns() const { return m_unknowns; }
  bool has_penalty() const { return m_penalty != nullptr; }
  double scale() const { return m_scale; } // by which positions are multiplied

  // Takes regular cells as reference from now on, or those of the source again, with the same scale.
  void set_references(const Reference_cells references)
  {
    if(references != m_references)
      m_packs.set_references(m_mesh, references == Reference_cells::REGULAR ? regular_cells_scaled_to_target(m_mesh)
                                                                            : cells_scaled_to_target(m_mesh));
    m_references = references;
  }

  // Returns positions after a step, and unit normals of surfaces. Unless steps are along tangents, vertices are put back on their
  // surfaces, and normals are those there.
  std::pair<Positions, Positions> moved(const Positions& u, const double length, const Positions& d) const
  {
    Positions result = u + length * d;
    if(m_are_steps_along_tangents)
      return { std::move(result), m_unknowns.normals() };
    Positions normals = m_unknowns.put_on_surfaces(result, m_scale, m_mesh.is_parallel);
    return { std::move(result), std::move(normals) };
  }

  // Puts vertices back on their surfaces, and lets them move in the tangent planes there from now on. Returns the positions.
  Positions move_from(Positions u)
  {
    set_normals(m_unknowns.put_on_surfaces(u, m_scale, m_mesh.is_parallel));
    return u;
  }

  void set_normals(Positions normals) { m_unknowns.set_normals(std::move(normals)); }

  // Lets steps leave surfaces along tangents, until positions are put back. If line searches put them back, vertices at borders
  // and folds of surfaces hold up all others.
  void step_along_tangents() { m_are_steps_along_tangents = true; }
  bool are_steps_along_tangents() const { return m_are_steps_along_tangents; }

  // Lets no step from these positions on, in the user's units, turn over facets against their surfaces or make them intersect.
  void keep_boundary_embedded(const Matrix3Xd& positions)
  { m_boundary = std::make_shared<const Embedded_boundary_3>(m_mesh, m_unknowns, positions); }

  bool is_boundary_kept_embedded() const { return m_boundary != nullptr; }
  bool is_boundary_embedded(const Positions& u, const Positions& normals) const
  { return m_boundary == nullptr || m_boundary->spoilt_facets(u / m_scale, normals, 1).empty(); }

  // Holds vertices, until normals are set, that a step would lead uphill after they are put back on their surfaces, as a
  // fold does, and those of facets that it would spoil. Returns whether there are any.
  bool hold_stuck_vertices(const Cell_energy_3& energy, const Positions& u, const double length, const Positions& d)
  {
    if(m_are_steps_along_tangents || !are_some_on_surfaces(m_unknowns.conditions()))
      return false;
    Positions gradient = Positions::Zero(3, m_unknowns.size());
    add_energy_gradient(m_packs, energy, u, gradient);
    const auto [trial, normals] = moved(u, length, d);
    const Positions step = trial - u;
    std::set<int> spoilt;
    if(m_boundary != nullptr)
      for(const auto& facet : m_boundary->spoilt_facets(trial / m_scale, normals))
        spoilt.insert(facet.begin(), facet.end());
    return m_unknowns.hold_if([&](const int row)
    {
      const int v = m_unknowns.vertex(row);
      return gradient.col(row).dot(step.col(v)) > 0 || spoilt.count(v) == 1;
    });
  }

  Energy_evaluation evaluate(const Cell_energy_3& energy, const Positions& u) const
  {
    const Energy_evaluation part = evaluate_energy(m_packs, energy, u);
    const double number = m_communicator.sum(static_cast<double>(part.number_of_inverted_cells));
    const double sum = m_communicator.sum(part.energy) + (m_penalty == nullptr ? 0 : m_penalty->value(u));
    return { sum, m_communicator.minimum(part.smallest_determinant), static_cast<std::size_t>(number) };
  }

  // The smallest volume of a cell, with inverted ones below 0, relative to the mean one; of positions in the user's units.
  double smallest_relative_volume(const Matrix3Xd& positions) const
  {
    const Dirichlet_energy_3 any;
    return evaluate(Cell_energy_of<Dirichlet_energy_3>(any), m_scale * positions).smallest_determinant;
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
    add_energy_gradient(m_packs, energy, u, result);
    if(m_penalty != nullptr)
      m_penalty->add_gradient(u, m_unknowns, result);
    m_unknowns.project(result);
    return result;
  }

  // Solves H d = -g, where H keeps the part `negative_curvature` of the negative eigenvalues of each cell. An iterative solver may
  // end early if the budget is exhausted. If it stops at its limit of iterations, or fails by rounding, a direct solver may take
  // over.
  Newton_direction_3 direction(const Cell_energy_3& energy, const Positions& u, const double negative_curvature,
                               const double tolerance, const Budget& budget = Budget())
  {
    if(m_turns.is_direct())
    {
      Newton_direction_3 exact = direction_by(m_turns.begin_turn(), energy, u, negative_curvature, tolerance, budget);
      if(exact.is_usable() || negative_curvature > 0)
        return exact;
    }
    const std::size_t iterations_before = m_solver.number_of_own_iterations();
    Newton_direction_3 result = direction_by(*m_system, energy, u, negative_curvature, tolerance, budget);
    const bool is_cut = result.status == Linear_solver_status::ITERATION_LIMIT;
    // rounding has made a semi-definite matrix indefinite or infinite, and none with less negative curvature is left to try
    const bool is_lost = !result.is_usable() && negative_curvature == 0 && m_solver.does_iterate();
    return direction_by_factorization_if(is_cut || is_lost, std::move(result), iterations_before, energy, u, negative_curvature,
                                         budget);
  }

  // Returns a direction by the last matrix, which is right for a convex quadratic energy. Negative curvature is an error of
  // rounding then, and a truncated solution may lead far away.
  Newton_direction_3 next_direction(const Cell_energy_3& energy, const Positions& u, const double tolerance,
                                    const Budget& budget)
  {
    const std::size_t iterations_before = m_solver.number_of_own_iterations();
    Newton_direction_3 result = solve(*m_last_system, gradient(energy, u), tolerance, budget, true);
    result.is_of_semidefinite_matrix = true;
    if(m_last_system != m_system.get())
      return result;
    const bool is_inexact = result.status != Linear_solver_status::SUCCESS;
    return direction_by_factorization_if(is_inexact, std::move(result), iterations_before, energy, u, 0., budget);
  }

  // The largest t in [0, 1] for which u + t d inverts no cell, if u inverts none.
  double largest_step(const Positions& u, const Positions& d) const
  { return m_communicator.minimum(largest_step_3(m_packs, u, d)); }

private:
  // Returns the direction of a direct solver if the one found is inexact and a factorization costs less, else the one found.
  Newton_direction_3 direction_by_factorization_if(const bool is_inexact, Newton_direction_3 found,
                                                   const std::size_t iterations_before, const Cell_energy_3& energy,
                                                   const Positions& u, const double negative_curvature, const Budget& budget)
  {
    // nothing interrupts a factorization, so it may cost no more than the default solver does
    const std::size_t number_of_iterations = found.is_usable() ? m_solver.number_of_own_iterations() - iterations_before
                                                               : default_limit_of_iterations;
    if(!m_mesh.is_whole() || budget.is_exhausted() || !m_turns.takes_over(m_system->matrix(), is_inexact, number_of_iterations))
      return found;
    Newton_direction_3 exact = direction_by(m_turns.begin_turn(), energy, u, negative_curvature, 0., budget);
    if(!exact.is_usable())
    {
      m_last_system = m_system.get();
      return found;
    }
    m_solver.number_of_replaced_solutions += found.status == Linear_solver_status::ITERATION_LIMIT;
    return exact;
  }

  Newton_direction_3 direction_by(Linear_system_3& system, const Cell_energy_3& energy, const Positions& u,
                                  const double negative_curvature, const double tolerance, const Budget& budget)
  {
    m_last_system = &system;
    return std::visit([&](auto& hessian)
    {
      Positions gradient;
      assemble(energy, u, negative_curvature, gradient, hessian);
      Newton_direction_3 direction = solve(system, gradient, tolerance, budget);
      // a semi-definite matrix may fail to be definite by rounding
      for(double shift = 1e-8; shift < 1e-2 && negative_curvature == 0
                               && direction.status == Linear_solver_status::NOT_POSITIVE_DEFINITE; shift *= 100)
      {
        hessian.scale_diagonal(static_cast<typename std::decay_t<decltype(hessian)>::NT>(shift));
        direction = solve(system, gradient, tolerance, budget);
      }
      direction.is_of_semidefinite_matrix = negative_curvature == 0;
      if(direction.status == Linear_solver_status::NOT_POSITIVE_DEFINITE)
        direction.gain_of_single_vertices = gain_of_single_vertices(gradient, hessian);
      return direction;
    }, system.matrix());
  }

  // Returns a lower bound of what the unknowns gain if each moves alone; infinity if a number is infinite.
  template <typename NT>
  double gain_of_single_vertices(const Positions& gradient, const Block_sparse_matrix_3<NT>& hessian) const
  {
    double sum = 0;
    for(int row = 0; row < m_number_of_own_rows; ++row)
      if(const double squares = gradient.col(row).squaredNorm(); squares > 0)
      {
        const double stiffness = hessian.block(hessian.position(row, row)).trace();
        sum += std::isfinite(stiffness) ? squares / stiffness : std::numeric_limits<double>::infinity();
      }
    return m_communicator.sum(sum);
  }

  template <typename NT>
  void assemble(const Cell_energy_3& energy, const Positions& u, const double negative_curvature,
                Positions& gradient, Block_sparse_matrix_3<NT>& hessian) const
  {
    assemble_energy(m_packs, energy, u, negative_curvature, gradient, hessian);
    if(m_penalty != nullptr)
    {
      m_penalty->add_gradient(u, m_unknowns, gradient);
      m_penalty->add_hessian(m_unknowns, hessian);
    }
    m_unknowns.project(gradient);
    m_unknowns.project(hessian);
    if(m_mesh.alignment)
      hessian.set_points(m_unknowns.points(u));
  }

  Newton_direction_3 solve(Linear_system_3& system, const Positions& columns, const double tolerance, const Budget& budget,
                           const bool is_factorized = false) const
  {
    const Eigen::Map<const Eigen::VectorXd> gradient(columns.data(), columns.size());
    Newton_direction_3 result;
    result.gradient_norm = std::sqrt(dot(gradient, gradient));
    const bool is_critical = result.gradient_norm == 0; // the matrix may be zero then, as that of a constant energy
    result.status = is_critical || is_factorized ? Linear_solver_status::SUCCESS : system.factorize();
    if(result.status != Linear_solver_status::SUCCESS)
      return result;
    VectorXd solution = VectorXd::Zero(gradient.size());
    if(!is_critical)
      result.status = system.solve(-gradient, solution, tolerance, budget);
    if(result.is_exact() || result.status == Linear_solver_status::ITERATION_LIMIT)
    {
      result.slope = dot(gradient, solution);
      if(!(result.slope < 0) && result.gradient_norm > 0) // otherwise it would pass for a minimum
        result.status = Linear_solver_status::NOT_POSITIVE_DEFINITE;
      Positions direction = Eigen::Map<const Eigen::Matrix3Xd>(solution.data(), 3, columns.cols());
      m_unknowns.project(direction);
      result.slopes = columns.cwiseProduct(direction).colwise().sum().transpose();
      result.vectors = m_unknowns.to_vertices(direction);
    }
    return result;
  }

  // Sums over all rows, each counted by the process that owns it.
  template <typename A, typename B>
  double dot(const A& a, const B& b) const
  {
    const Eigen::Index n = 3 * Eigen::Index(m_number_of_own_rows);
    return m_communicator.sum(a.head(n).dot(b.head(n)));
  }

  const Numbered_mesh_3& m_mesh;
  const Communicator_3& m_communicator;
  Linear_solver_3& m_solver;
  int m_number_of_own_rows; // they come first; the others are copies
  Unknowns_3 m_unknowns;
  std::shared_ptr<const Embedded_boundary_3> m_boundary; // none if no boundary slides on surfaces
  const Quadratic_penalty_3* m_penalty;
  double m_scale;
  bool m_are_steps_along_tangents = false;
  Reference_cells m_references = Reference_cells::SOURCE;
  Sparsity_pattern_3 m_pattern; // which the linear system takes over
  Cell_packs_3 m_packs;
  std::unique_ptr<Linear_system_3> m_system;
  Direct_turns_3 m_turns; // of another system with the same pattern
  Linear_system_3* m_last_system = nullptr;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_NEWTON_SYSTEM_3_H
