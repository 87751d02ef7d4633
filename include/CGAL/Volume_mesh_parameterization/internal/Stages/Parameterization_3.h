// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_PARAMETERIZATION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_PARAMETERIZATION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Bounded_angle_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Soft_boundary_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Sliding_boundary_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/distortion_of_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/spatial_order_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/unavoidable_angle_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Sliding_directions_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Engine_run.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Fixed_boundary_engine_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Soft_boundary_engine_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Where the approach of a soft boundary starts: at the aligned source if there are no positions.
struct Soft_boundary_start_3
{
  Eigen::Matrix3Xd positions;
  std::size_t number_of_raises = 0; // of the weight
  std::size_t patience = 0;         // see Soft_boundary_engine_3::end_when_blocked()
};

// From numbered arrays to the images of their vertices, by one stage or several.
template <typename ConcurrencyTag, typename Energy, typename Solver, typename Visitor>
class Parameterization_3
{
public:
  using Positions = Eigen::Matrix3Xd;
  using Constraints = std::vector<Linear_constraint_3<int> >;

  // With `do_slide`, the boundary does not stay fixed while the energy is minimized: see slide().
  Parameterization_3(const Numbered_mesh_3& mesh, const Energy& energy, Solver& solver,
                     Engine_run<Visitor>& run, const bool do_slide, Parameterization_result& result)
    : m_order(spatial_order_3(mesh)),
      m_mesh(reordered(mesh, m_order)),
      m_energy(energy),
      m_solver(solver),
      m_run(run),
      m_do_slide(do_slide),
      m_result(result)
  {}

  // The boundary at its targets from the beginning: untangles and minimizes.
  void run_with_fixed_boundary()
  {
    const double begin = m_run.seconds();
    Fixed_engine engine(m_mesh, m_energy, m_solver);
    engine.start();
    m_result.seconds_to_flip_free = m_run.seconds();
    m_result.number_of_inverted_cells_at_start = engine.number_of_inverted_cells_at_start();
    if(m_do_slide)
      engine.end_when_flip_free();
    run(engine, begin);
  }

  // No inverted cell from the beginning: the boundary approaches its targets. As soon as it can be put
  // there without inverting a cell, the minimization continues with fixed boundary.
  void run_with_soft_boundary(const Soft_boundary_parameters& parameters, const Constraints& constraints,
                              const Soft_boundary_start_3& start)
  {
    const double begin = m_run.seconds();
    Soft_engine engine(m_mesh, m_energy, m_solver, parameters, renumbered(constraints));
    engine.end_when_blocked(start.patience);
    if(start.positions.cols() == 0)
      engine.start();
    else
      engine.start(reordered(start.positions, m_order), start.number_of_raises);
    m_result.seconds_to_flip_free = m_run.seconds();
    run(engine, begin);
    m_number_of_raises = engine.number_of_raises();
    if(engine.can_snap() && !m_run.is_interrupted())
    {
      const double begin_of_fixed = m_run.seconds();
      Fixed_engine fixed(m_mesh, m_energy, m_solver);
      fixed.start(engine.snapped_positions());
      if(m_do_slide)
        fixed.end_when_flip_free();
      run(fixed, begin_of_fixed);
    }
  }

  // Minimizes the energy while vertices of planar patches of the boundary slide, but for those that are
  // constrained. Nothing is done unless the map found so far is flip-free and meets the boundary.
  template <typename Predicate>
  void slide(const Predicate& is_constrained)
  {
    if(!is_flip_free() || !meets_boundary())
      return;
    const double begin = m_run.seconds();
    m_sliding.emplace(m_mesh, [&](const int v) { return is_constrained(m_order[v]); });
    m_result.number_of_sliding_vertices = m_sliding->number_of_sliding_vertices();
    minimize_further(m_energy, begin);
  }

  // Brings the distortion of angles of every cell below a bound, by a barrier. It is relaxed, less and less, until no
  // cell exceeds the bound, or the excess hardly falls. Once none does, no step does so any more, and the energy is
  // minimized below the bound. Does so if the map found so far is flip-free and meets the boundary.
  void bound_angle_distortion(const double bound)
  {
    if(!is_flip_free() || !meets_boundary())
      return;
    double excess = largest_angle_distortion() - bound;
    if(excess < 0)
      return;
    const auto minimize = [&](const double relaxation)
    {
      minimize_further(Bounded_angle_energy_3<Energy>(bound, m_energy, relaxation), m_run.seconds());
      excess = largest_angle_distortion() - bound;
    };
    double previous = std::numeric_limits<double>::infinity();
    for(double relaxation = 0.05; excess >= 0 && relaxation > 1e-6 && !m_run.is_interrupted(); relaxation /= 5)
    {
      minimize(relaxation);
      if(excess > previous / 2)
        break;
      previous = excess;
    }
    if(excess < 0 && !m_run.is_interrupted())
      minimize(0);
    if(!(excess < 0) && !m_run.is_interrupted())
    {
      m_result.status = ERROR_ANGLE_BOUND_NOT_REACHED;
      m_result.message
        = describe_angle_distortion(bound + excess, m_sliding ? 0 : unavoidable_angle_distortion_3(m_mesh));
    }
  }

  // of the weight of the soft boundary
  std::size_t number_of_raises() const { return m_number_of_raises; }

  bool is_flip_free() const { return inverted_cells(m_mesh, m_positions).number == 0; }

  bool meets_boundary() const
  {
    if(m_sliding)
      return m_sliding->residual(m_positions) == 0 && m_sliding->has_same_orientations(m_positions);
    // the residual may be zero by underflow
    const Eigen::Index n = m_mesh.number_of_vertices() - m_mesh.number_of_free_vertices;
    return m_positions.rightCols(n) == m_mesh.target.rightCols(n);
  }

  // Judges the map by exact predicates and measures it.
  void evaluate()
  {
    const double begin = m_run.seconds();
    m_result.number_of_inverted_cells = inverted_cells(m_mesh, m_positions).number;
    m_result.has_valid_map = m_result.number_of_inverted_cells == 0;
    if(m_result.has_valid_map)
    {
      m_result.boundary_residual = boundary_residual();
      if(!meets_boundary() && m_result.status != ERROR_INTERRUPTED)
        m_result.status = ERROR_BOUNDARY_NOT_REACHED;
      const Distortion_of_map_3 distortion = distortion_of_map_3(m_mesh, m_positions, m_energy);
      m_result.distortion = distortion.as_it_is;
      m_result.distortion_at_source_volume = distortion.at_source_volume;
      m_result.energy = distortion.energy;
    }
    else if(m_result.status != ERROR_LINEAR_SOLVER_FAILED && m_result.status != ERROR_INTERRUPTED)
      m_result.status = ERROR_NOT_FLIP_FREE;
    m_result.seconds_check += m_run.seconds() - begin;
  }

  // The images of the vertices, in the order of the mesh that was given.
  Positions positions() const { return in_original_order(m_positions, m_order); }

private:
  using Fixed_engine = Fixed_boundary_engine_3<Energy, Solver, ConcurrencyTag>;
  using Soft_engine = Soft_boundary_engine_3<Energy, Solver, ConcurrencyTag>;

  template <typename Engine>
  void run(Engine& engine, const double begin)
  {
    m_result.seconds_start += m_run.seconds() - begin;
    m_result.status = m_run.run(engine, m_result);
    m_positions = engine.positions();
  }

  // Minimizes an energy from the map found so far. Vertices that slide go on doing so.
  template <typename Other_energy>
  void minimize_further(const Other_energy& energy, const double begin)
  {
    using Engine = Fixed_boundary_engine_3<Other_energy, Solver, ConcurrencyTag>;
    if(!m_sliding)
    {
      Engine engine(m_mesh, energy, m_solver);
      engine.start_minimization(m_positions);
      run(engine, begin);
      return;
    }
    const std::vector<std::size_t> order = m_sliding->order();
    Numbered_mesh_3 mesh = reordered(m_mesh, order);
    mesh.number_of_free_vertices += static_cast<int>(m_result.number_of_sliding_vertices);
    const Sliding_directions_3 directions = m_sliding->directions(order);
    Engine engine(mesh, energy, m_solver, &directions);
    engine.start_minimization(reordered(m_positions, order));
    run(engine, begin);
    m_positions = in_original_order(m_positions, order);
    m_sliding->restore(m_positions);
  }

  double largest_angle_distortion() const
  {
    return distortion_of_map_3(m_mesh, m_positions, m_energy).as_it_is.angle_max;
  }

  Constraints renumbered(Constraints constraints) const
  {
    std::vector<int> number(m_order.size());
    for(std::size_t i = 0; i < m_order.size(); ++i)
      number[m_order[i]] = static_cast<int>(i);
    for(Linear_constraint_3<int>& constraint : constraints)
      for(auto& term : constraint.terms)
        term.vertex = number[term.vertex];
    return constraints;
  }

  // The largest distance of a prescribed vertex to its target, or to where it may slide, relative to the
  // diagonal of the bounding box of the targets.
  double boundary_residual() const
  {
    const Eigen::Index n = m_mesh.number_of_vertices() - m_mesh.number_of_free_vertices;
    const auto targets = m_mesh.target.rightCols(n);
    const double diagonal = (targets.rowwise().maxCoeff() - targets.rowwise().minCoeff()).norm();
    const double distance = m_sliding ? m_sliding->residual(m_positions)
                                      : largest_distance_to_target(m_mesh, m_positions);
    return distance / diagonal;
  }

  std::vector<std::size_t> m_order;
  Numbered_mesh_3 m_mesh;
  const Energy& m_energy;
  Solver& m_solver;
  Engine_run<Visitor>& m_run;
  bool m_do_slide;
  Parameterization_result& m_result;
  Positions m_positions;
  std::size_t m_number_of_raises = 0;
  std::optional<Sliding_boundary_3> m_sliding; // once vertices may slide
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_PARAMETERIZATION_3_H
