// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_FIXED_BOUNDARY_ENGINE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_FIXED_BOUNDARY_ENGINE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Minimizer_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Newton_method_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Sliding_directions_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Untangler_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/harmonic_map_3.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The map with fixed boundary, one Newton step at a time:
// harmonic start, untangling until no cell is inverted, minimization of the energy. In the last stage,
// vertices may slide in given directions.
template <typename Energy, typename Solver, typename ConcurrencyTag>
class Fixed_boundary_engine_3
{
  using Newton = Newton_method_3<ConcurrencyTag, Solver>;
  using Untangler = Untangler_3<Newton>;
  using Minimizer = Minimizer_3<Newton, Energy, ConcurrencyTag>;

public:
  Fixed_boundary_engine_3(const Numbered_mesh_3& mesh, const Energy& energy, Solver& solver,
                          const Sliding_directions_3* const directions = nullptr)
    : m_energy(energy),
      m_prescribed(mesh.target.rightCols(mesh.number_of_vertices() - mesh.number_of_free_vertices)),
      m_scale(scale(mesh)),
      m_u(m_scale * mesh.target),
      m_newton(mesh, inverse_sources(mesh), cell_weights(mesh), solver, nullptr, directions)
  {}

  // Starts from the harmonic map.
  void start()
  {
    if(harmonic_map_3(m_newton, m_u) != Linear_solver_status::SUCCESS)
      end(ERROR_LINEAR_SOLVER_FAILED);
    start_untangling();
  }

  // Starts from the given images of all vertices.
  void start(const Eigen::Matrix3Xd& positions)
  {
    m_u = m_scale * positions;
    start_untangling();
  }

  // Only minimizes the energy, from the given images, which must not invert a cell.
  void start_minimization(const Eigen::Matrix3Xd& positions)
  {
    m_u = m_scale * positions;
    enter(Phase::MINIMIZATION);
  }

  // Leaves the minimization to another engine; to be called after start().
  void end_when_flip_free()
  {
    m_minimizes = false;
    if(is_flip_free())
      end(OK);
  }

  // One Newton step; to be called while is_running().
  void step()
  {
    ++m_step.iteration;
    m_step.phase = m_phase;
    if(m_phase == Phase::UNTANGLING)
    {
      const Step_status status = m_untangler->step();
      report(*m_untangler);
      if(status == Step_status::DONE)
      {
        enter(Phase::MINIMIZATION);
        if(!m_minimizes)
          end(OK);
      }
      else if(status == Step_status::STUCK)
        end(ERROR_NOT_FLIP_FREE);
      else if(status == Step_status::SOLVER_FAILED)
        end(ERROR_LINEAR_SOLVER_FAILED);
    }
    else
    {
      const Step_status status = m_minimizer->step();
      report(*m_minimizer);
      if(status == Step_status::DONE)
        end(OK);
      else if(status == Step_status::STUCK)
        end(ERROR_NOT_CONVERGED);
      else if(status == Step_status::SOLVER_FAILED)
        end(ERROR_LINEAR_SOLVER_FAILED);
    }
  }

  bool is_running() const { return m_is_running; }
  Error_code status() const { return m_status; }
  const Parameterization_step& last_step() const { return m_step; }
  bool is_flip_free() const { return m_phase == Phase::MINIMIZATION; }
  std::size_t number_of_inverted_cells_at_start() const { return m_inverted_cells_at_start; }

  // The images of all vertices; those of the prescribed ones are bitwise what was given.
  Eigen::Matrix3Xd positions() const
  {
    Eigen::Matrix3Xd result = m_u / m_scale;
    result.rightCols(m_prescribed.cols()) = m_prescribed; // scaling may have lost bits of denormal numbers
    return result;
  }

private:
  static constexpr double theta = 0.01;

  // A power of two, so that scaling is exact, that gives the cells of the target a volume near 1.
  static double scale(const Numbered_mesh_3& mesh)
  {
    const double mean_volume = volume(mesh.target, mesh.cells) / static_cast<double>(mesh.cells.size());
    return std::exp2(-std::round(std::log2(mean_volume) / 3));
  }

  // X^{-1}, scaled such that source and target have the same volume
  std::vector<Eigen::Matrix3d> inverse_sources(const Numbered_mesh_3& mesh) const
  {
    const double ratio = std::cbrt(volume(mesh.source, mesh.cells) / volume(mesh.target, mesh.cells)) / m_scale;
    return scaled_inverse_sources(mesh, ratio);
  }

  void start_untangling()
  {
    m_untangler.emplace(m_newton, m_u, theta);
    m_inverted_cells_at_start = m_untangler->evaluation().number_of_inverted_cells;
    enter(m_untangler->evaluation().is_flip_free() ? Phase::MINIMIZATION : Phase::UNTANGLING);
  }

  void enter(const Phase phase)
  {
    m_phase = phase;
    if(phase == Phase::MINIMIZATION)
      m_minimizer.emplace(m_newton, m_u, m_energy);
  }

  template <typename Method>
  void report(const Method& method)
  {
    m_step.energy = method.evaluation().energy;
    m_step.number_of_inverted_cells = method.evaluation().number_of_inverted_cells;
    m_step.gradient_norm = m_newton.gradient_norm();
    m_step.step_length = method.step_length();
  }

  void end(const Error_code status)
  {
    m_status = status;
    m_is_running = false;
  }

  const Energy& m_energy;
  Eigen::Matrix3Xd m_prescribed;
  double m_scale;
  Eigen::Matrix3Xd m_u;
  Newton m_newton;
  std::optional<Untangler> m_untangler;
  std::optional<Minimizer> m_minimizer;
  Parameterization_step m_step;
  Phase m_phase = Phase::START;
  Error_code m_status = ERROR_NOT_CONVERGED;
  bool m_is_running = true;
  bool m_minimizes = true;
  std::size_t m_inverted_cells_at_start = 0;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_FIXED_BOUNDARY_ENGINE_3_H
