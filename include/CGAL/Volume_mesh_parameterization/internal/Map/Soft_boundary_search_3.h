// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_SOFT_BOUNDARY_SEARCH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_SOFT_BOUNDARY_SEARCH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/alignment_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Penalty_minimizer_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The map with soft boundary (Jin et al., section 4): starts from the source aligned to the target,
// and lets a penalty of growing weight pull the prescribed vertices to their targets. No cell is
// inverted at any time; the targets may be missed. Further constraints may be given, on any vertices.
class Soft_boundary_search_3
{
public:
  using Constraints = std::vector<Linear_constraint_3<int> >;

  Soft_boundary_search_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy, Linear_solver_3& solver,
                      const Soft_boundary_parameters& parameters = Soft_boundary_parameters(),
                      const Constraints& constraints = Constraints(), const Search_start_3& start = Search_start_3())
    : m_mesh(mesh), m_energy(energy), m_parameters(parameters), m_has_constraints(!constraints.empty()),
      m_patience(start.patience), m_number_of_raises(start.number_of_raises),
      m_aligned_source(similarity_alignment_3(mesh)), m_length(length_of_target()),
      m_penalty(all_constraints(constraints), factor_of(parameters.weight), scale_of_length(m_length)),
      m_system(mesh, cells_scaled_to_length(mesh, m_length), all_vertices(mesh), solver, &m_penalty)
  {
    minimize(start.stage == Search_start_3::Stage::SOFT_BOUNDARY ? start.positions : m_aligned_source);
    if(!m_minimizer->iterate().evaluation.is_flip_free())
      end(ERROR_INVERTED_SOURCE_CELL);
  }

  // Makes a step, and decides what comes next. The search must be running.
  void step()
  {
    const std::optional<Error_code> status = m_minimizer->step();
    const std::size_t number_of_steps = m_last_step.iteration + 1;
    m_last_step = step_of(m_minimizer->iterate(), Phase::MINIMIZATION);
    m_last_step.iteration = number_of_steps;
    if(status == ERROR_LINEAR_SOLVER_FAILED)
      end(*status, describe_failure(m_minimizer->iterate().direction));
    else if(can_snap())
      end(OK);
    else if(status)
    {
      if(residual() <= m_parameters.residual_tolerance)
        end(*status);
      else if(is_blocked() || m_number_of_raises >= m_parameters.maximum_number_of_raises)
        end(ERROR_BOUNDARY_NOT_REACHED);
      else
        raise_weight();
    }
  }

  bool is_running() const { return !m_status; }
  std::optional<Error_code> status() const { return m_status; } // once it has ended
  const std::string& reason() const { return m_reason; } // for the status; empty if there is nothing to add
  const Parameterization_step& last_step() const { return m_last_step; }

  // The images of all vertices; those of the prescribed ones are near their targets.
  Matrix3Xd positions() const { return m_minimizer->iterate().positions(); }
  Map_3 map() const { return evaluated_map(m_mesh, positions()); }

  // The positions with the prescribed vertices on their targets.
  Matrix3Xd snapped_positions() const { return snapped(m_mesh, positions()); }

  // May the minimization with fixed boundary take over from there?
  bool can_snap() const
  { return m_parameters.do_snap && !m_has_constraints && inverted_cells(m_mesh, snapped_positions()).number == 0; }

  double energy() const { return m_minimizer->iterate().evaluation.energy; } // with the penalty

  // |P(u)|_2, where the target has volume 1
  double residual() const { return m_penalty.residual(m_minimizer->iterate().u) / m_length; }
  double weight() const
  { return m_parameters.weight * std::pow(m_parameters.weight_factor, static_cast<double>(m_number_of_raises)); }
  std::size_t number_of_raises() const { return m_number_of_raises; }
  bool is_relaxing() const { return m_minimizer->is_relaxing(); }

private:
  double length_of_target() const
  { return std::cbrt(m_mesh.reference_scale ? reference_volume(m_mesh) : volume(m_mesh, snapped(m_mesh, m_aligned_source))); }

  void end(const Error_code status, const std::string& reason = std::string())
  {
    m_status = status;
    m_reason = reason;
  }

  // The constraints, with three more for each vertex at its target. The rows of 1 - P keep one in its plane or on its line.
  Constraints all_constraints(Constraints constraints) const
  {
    for(int v = m_mesh.number_of_free_vertices; v < m_mesh.number_of_vertices(); ++v)
    {
      const Matrix_3 Q = Matrix_3::Identity() - m_mesh.projector(v);
      for(int i = 0; i < 3; ++i)
        if(Q.col(i) == Vector_3::Unit(i))
          constraints.push_back({{{v, Vector_3::Unit(i)}}, m_mesh.target(i, v)});
        else if(Q.col(i) != Vector_3::Zero())
          constraints.push_back({{{v, Q.col(i)}}, Q.col(i).dot(m_mesh.target.col(v))});
    }
    return constraints;
  }

  // A weight is meant for lengths where the target has volume 1.
  double factor_of(const double weight) const { return weight / std::pow(m_length, 2); }

  // Returns the diameter of the bounding box of the source, where that has volume 1.
  double diameter() const
  {
    const Vector_3 box = m_mesh.source.rowwise().maxCoeff() - m_mesh.source.rowwise().minCoeff();
    return box.norm() / std::cbrt(volume(m_mesh, m_mesh.source));
  }

  void minimize(const Matrix3Xd& start)
  {
    m_penalty.set_weight(factor_of(weight()));
    m_minimizer.emplace(m_system, m_penalty, m_energy, start, m_parameters, diameter());
  }

  void raise_weight()
  {
    ++m_number_of_raises;
    minimize(positions());
  }

  // Returns whether several raises of the weight in a row were useless. A raise is useless if the largest distance to a target has
  // hardly fallen, or if two raises have not lowered the number of cells that keep vertices from their targets. The first raises
  // only bring the boundary near, and do not count.
  bool is_blocked()
  {
    constexpr std::size_t number_of_first_raises = 3; // a guess
    const Matrix3Xd at_targets = snapped_positions();
    m_distances.push_back((at_targets - positions()).colwise().norm().maxCoeff());
    m_numbers_of_blocking_cells.push_back(inverted_cells(m_mesh, at_targets).number);
    const std::size_t n = m_distances.size();
    const bool is_useless = m_number_of_raises >= number_of_first_raises
      && ((n > 1 && m_distances[n - 1] > 0.9 * m_distances[n - 2])
          || (n > 2 && m_numbers_of_blocking_cells[n - 1] >= m_numbers_of_blocking_cells[n - 3]));
    m_number_of_useless_raises = is_useless ? m_number_of_useless_raises + 1 : 0;
    return m_number_of_useless_raises >= m_patience;
  }

  const Numbered_mesh_3& m_mesh;
  const Cell_energy_3& m_energy;
  Soft_boundary_parameters m_parameters;
  bool m_has_constraints; // other than the targets
  std::size_t m_patience;
  std::size_t m_number_of_raises;
  Matrix3Xd m_aligned_source;
  double m_length;        // cube root of the volume of the target
  Quadratic_penalty_3 m_penalty;
  Newton_system_3 m_system;
  std::optional<Penalty_minimizer_3> m_minimizer;
  std::size_t m_number_of_useless_raises = 0;
  std::vector<double> m_distances;                      // the largest one, for each weight
  std::vector<std::size_t> m_numbers_of_blocking_cells; // for each weight
  Parameterization_step m_last_step;
  std::optional<Error_code> m_status;
  std::string m_reason;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_SOFT_BOUNDARY_SEARCH_3_H
