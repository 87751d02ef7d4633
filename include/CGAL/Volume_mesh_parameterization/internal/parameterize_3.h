// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PARAMETERIZE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PARAMETERIZE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Fixed_boundary_engine_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_input_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/distortion_of_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/run_engine.h>
#include <CGAL/Volume_mesh_parameterization/internal/spatial_order_3.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Dense>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The largest distance of a prescribed vertex to its target, relative to the diagonal of the bounding
// box of the targets.
inline double boundary_residual(const Numbered_mesh_3& mesh, const Eigen::Matrix3Xd& image)
{
  const Eigen::Index n = mesh.number_of_vertices() - mesh.number_of_free_vertices;
  const auto targets = mesh.target.rightCols(n);
  const double diagonal = (targets.rowwise().maxCoeff() - targets.rowwise().minCoeff()).norm();
  return (image.rightCols(n) - targets).colwise().norm().maxCoeff() / diagonal;
}

// Judges the map by exact predicates and measures it.
template <typename Energy>
void evaluate_map(const Numbered_mesh_3& mesh, const Eigen::Matrix3Xd& image, const Energy& energy,
                  Parameterization_result& result)
{
  result.number_of_inverted_cells = inverted_cells(mesh, image).number;
  result.has_valid_map = result.number_of_inverted_cells == 0;
  if(!result.has_valid_map)
    return;
  result.boundary_residual = boundary_residual(mesh, image);
  const Distortion_of_map_3 distortion = distortion_of_map_3(mesh, image, energy);
  result.distortion = distortion.as_it_is;
  result.distortion_at_source_volume = distortion.at_source_volume;
  result.energy = distortion.energy;
}

// From numbered arrays to the images of their vertices: checks the input, runs the engine, checks the output.
template <typename ConcurrencyTag, typename Energy, typename Solver, typename Visitor>
Parameterization_result parameterize_3(const Numbered_mesh_3& mesh, const Energy& energy, Solver& solver,
                                       Visitor& visitor, const Run_limits& limits, Real_timer& timer,
                                       Eigen::Matrix3Xd& image)
{
  Parameterization_result result;
  result.number_of_vertices = mesh.number_of_vertices();
  result.number_of_cells = mesh.cells.size();
  const Input_check check = check_input_3(mesh);
  result.status = check.status;
  result.message = check.message;
  result.seconds_numbering = timer.time();
  if(check.status == OK)
  {
    const std::vector<std::size_t> order = spatial_order_3(mesh);
    const Numbered_mesh_3 ordered = reordered(mesh, order);
    Fixed_boundary_engine_3<Energy, Solver, ConcurrencyTag> engine(ordered, energy, solver);
    engine.start();
    result.number_of_inverted_cells_at_start = engine.number_of_inverted_cells_at_start();
    result.seconds_start = timer.time() - result.seconds_numbering;

    result.status = run_engine(engine, visitor, limits, timer, result.seconds_to_flip_free);
    const double seconds_before_check = timer.time();
    result.seconds_untangling = result.seconds_to_flip_free - result.seconds_numbering - result.seconds_start;
    result.seconds_minimization = seconds_before_check - result.seconds_to_flip_free;
    result.number_of_iterations = engine.last_step().iteration;
    result.number_of_untangling_iterations = engine.number_of_untangling_iterations();

    const Eigen::Matrix3Xd positions = engine.positions();
    evaluate_map(ordered, positions, energy, result);
    if(!result.has_valid_map && result.status != ERROR_LINEAR_SOLVER_FAILED && result.status != ERROR_INTERRUPTED)
      result.status = ERROR_NOT_FLIP_FREE;
    result.message = get_error_message(result.status);

    image.resize(3, mesh.number_of_vertices());
    for(std::size_t i = 0; i < order.size(); ++i)
      image.col(order[i]) = positions.col(i);
    result.seconds_check = timer.time() - seconds_before_check;
  }
  result.seconds_total = timer.time();
  return result;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PARAMETERIZE_3_H
