// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_SOFT_BOUNDARY_ENGINE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_SOFT_BOUNDARY_ENGINE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Linear_constraint_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>
#include <CGAL/Volume_mesh_parameterization/Soft_boundary_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/similarity_alignment_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Newton_method_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Quadratic_penalty_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Relaxing_minimizer_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Step_status.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The map with soft boundary, one Newton step at a time: starts from the source aligned to the target,
// and lets a penalty of growing weight pull the prescribed vertices to their targets. No cell is
// inverted at any time; the targets may be missed. Further constraints may be given, on any vertices.
template <typename Energy, typename Solver, typename ConcurrencyTag>
class Soft_boundary_engine_3
{
  using Newton = Newton_method_3<ConcurrencyTag, Solver>;
  using Minimizer = Relaxing_minimizer_3<Newton, Energy, ConcurrencyTag>;

public:
  using Constraints = std::vector<Linear_constraint_3<int> >;

  Soft_boundary_engine_3(const Numbered_mesh_3& mesh, const Energy& energy, Solver& solver,
                         const Soft_boundary_parameters& parameters = Soft_boundary_parameters(),
                         const Constraints& constraints = Constraints())
    : m_mesh(mesh),
      m_energy(energy),
      m_parameters(parameters),
      m_has_constraints(!constraints.empty()),
      m_start(similarity_alignment_3(mesh)),
      m_length(std::cbrt(volume(snapped(mesh, m_start), mesh.cells))),
      m_scale(std::exp2(-std::round(std::log2(m_length)))),
      m_penalty(scaled(constraints), penalty_factor(parameters.weight)),
      m_newton(with_free_vertices(mesh), inverse_sources(), cell_weights(mesh), solver, &m_penalty)
  {}

  // Starts from the aligned source.
  void start() { start(m_start, 0); }

  // Starts from the given images of all vertices, which invert no cell, as after that many raises of the weight.
  void start(const Eigen::Matrix3Xd& positions, const std::size_t number_of_raises)
  {
    m_u = m_scale * positions;
    m_number_of_raises = number_of_raises;
    minimize();
    report();
    if(!m_minimizer->evaluation().is_flip_free())
      end(ERROR_INVERTED_SOURCE_CELL);
  }

  // Makes the end come where so many raises of the weight in a row have not helped.
  void end_when_blocked(const std::size_t patience) { m_patience = patience; }

  // One Newton step; to be called while is_running().
  void step()
  {
    ++m_step.iteration;
    m_step.phase = Phase::MINIMIZATION;
    const Step_status status = m_minimizer->step();
    report();
    if(status == Step_status::SOLVER_FAILED)
      end(ERROR_LINEAR_SOLVER_FAILED);
    else if(can_snap())
      end(OK);
    else if(status != Step_status::CONTINUE)
    {
      if(residual() <= m_parameters.residual_tolerance)
        end(status == Step_status::DONE ? OK : ERROR_NOT_CONVERGED);
      else if(is_blocked() || m_number_of_raises >= m_parameters.maximal_number_of_raises)
        end(ERROR_BOUNDARY_NOT_REACHED);
      else
        raise_weight();
    }
  }

  bool is_running() const { return m_is_running; }
  Error_code status() const { return m_status; }
  const Parameterization_step& last_step() const { return m_step; }
  bool is_flip_free() const { return true; }
  std::size_t number_of_inverted_cells_at_start() const { return 0; }
  std::size_t number_of_untangling_iterations() const { return 0; }

  // The images of all vertices; those of the prescribed ones are near their targets.
  Eigen::Matrix3Xd positions() const { return m_u / m_scale; }

  // The same with the prescribed vertices on their targets.
  Eigen::Matrix3Xd snapped_positions() const { return snapped(m_mesh, positions()); }

  // May the minimization with fixed boundary take over from there?
  bool can_snap() const
  {
    return m_parameters.do_snap && !m_has_constraints && inverted_cells(m_mesh, snapped_positions()).number == 0;
  }

  // |P(u)|_2, where the target has volume 1
  double residual() const { return m_penalty.residual(m_u) / (m_scale * m_length); }
  double weight() const
  {
    return m_parameters.weight * std::pow(m_parameters.weight_factor, static_cast<double>(m_number_of_raises));
  }
  std::size_t number_of_raises() const { return m_number_of_raises; }
  bool is_relaxing() const { return m_minimizer->is_relaxing(); }

private:
  // The constraints, with three more for each prescribed vertex, for the scaled positions.
  Constraints scaled(Constraints constraints) const
  {
    for(int v = m_mesh.number_of_free_vertices; v < m_mesh.number_of_vertices(); ++v)
      for(int i = 0; i < 3; ++i)
        constraints.push_back({{{v, Eigen::Vector3d::Unit(i)}}, m_mesh.target(i, v)});
    for(Linear_constraint_3<int>& constraint : constraints)
      constraint.value *= m_scale;
    return constraints;
  }

  // A weight is meant for lengths where the target has volume 1.
  double penalty_factor(const double weight) const { return weight / std::pow(m_scale * m_length, 2); }

  // X^{-1}, scaled such that source and target have the same volume
  std::vector<Eigen::Matrix3d> inverse_sources() const
  {
    const double ratio = std::cbrt(volume(m_mesh.source, m_mesh.cells)) / (m_scale * m_length);
    return scaled_inverse_sources(m_mesh, ratio);
  }

  // of the bounding box of the source, where that has volume 1
  double diameter() const
  {
    const Eigen::Vector3d box = m_mesh.source.rowwise().maxCoeff() - m_mesh.source.rowwise().minCoeff();
    return box.norm() / std::cbrt(volume(m_mesh.source, m_mesh.cells));
  }

  void minimize()
  {
    m_penalty.set_weight(penalty_factor(weight()));
    m_minimizer.emplace(m_newton, m_penalty, m_u, m_energy, m_parameters, diameter());
  }

  void raise_weight()
  {
    ++m_number_of_raises;
    minimize();
  }

  // Has the last raise of the weight been useless? It was if the vertex farthest from its target has not followed, or if
  // for two raises as many cells as before keep vertices from their targets. The first raises only bring the
  // boundary near.
  bool is_blocked()
  {
    constexpr std::size_t number_of_first_raises = 3;
    const Eigen::Matrix3Xd at_targets = snapped_positions();
    m_distances.push_back((at_targets - positions()).colwise().norm().maxCoeff());
    m_numbers_of_blocking_cells.push_back(inverted_cells(m_mesh, at_targets).number);
    const std::size_t n = m_distances.size();
    const bool is_useless = m_number_of_raises >= number_of_first_raises
      && ((n > 1 && m_distances[n - 1] > 0.9 * m_distances[n - 2])
          || (n > 2 && m_numbers_of_blocking_cells[n - 1] >= m_numbers_of_blocking_cells[n - 3]));
    m_number_of_useless_raises = is_useless ? m_number_of_useless_raises + 1 : 0;
    return m_number_of_useless_raises >= m_patience;
  }

  void report()
  {
    m_step.energy = m_minimizer->evaluation().energy;
    m_step.number_of_inverted_cells = m_minimizer->evaluation().number_of_inverted_cells;
    m_step.gradient_norm = m_newton.gradient_norm();
    m_step.step_length = m_minimizer->step_length();
  }

  void end(const Error_code status)
  {
    m_status = status;
    m_is_running = false;
  }

  const Numbered_mesh_3& m_mesh;
  const Energy& m_energy;
  Soft_boundary_parameters m_parameters;
  bool m_has_constraints;          // other than the targets
  Eigen::Matrix3Xd m_start;
  double m_length;                 // cube root of the volume of the target
  double m_scale;                  // a power of two, so that scaling is exact, that makes that length near 1
  Quadratic_penalty_3 m_penalty;
  Newton m_newton;
  Eigen::Matrix3Xd m_u;
  std::optional<Minimizer> m_minimizer;
  std::size_t m_number_of_raises = 0;
  std::size_t m_patience = (std::numeric_limits<std::size_t>::max)();
  std::size_t m_number_of_useless_raises = 0;
  std::vector<double> m_distances;                         // the largest one, for each weight
  std::vector<std::size_t> m_numbers_of_blocking_cells;    // for each weight
  Parameterization_step m_step;
  Error_code m_status = ERROR_NOT_CONVERGED;
  bool m_is_running = true;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_SOFT_BOUNDARY_ENGINE_3_H
