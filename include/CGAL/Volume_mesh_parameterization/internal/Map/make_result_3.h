// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MAKE_RESULT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MAKE_RESULT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Infeasibility/diagnose_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Input_check_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/measure_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns how the search ended, by the exact verdict on its map.
inline Error_code final_status(const Found_map_3& found)
{
  if(found.status == ERROR_INTERRUPTED)
    return found.status;
  if(found.map.is_valid())
    return found.map.meets_boundary || found.status == OK_WITHIN_TOLERANCE ? found.status : ERROR_BOUNDARY_NOT_REACHED;
  return found.status == ERROR_LINEAR_SOLVER_FAILED || found.status == ERROR_INVERTED_BY_ROUNDING ? found.status
                                                                                                   : ERROR_NOT_FLIP_FREE;
}

// Returns why the search did not end better: the reason of the last stage, of the stage with fixed boundary, or of the check.
inline std::string reason_of(const Error_code status, const Found_map_3& found, const Input_check_3& check)
{
  if(status == OK || (status == ERROR_NOT_CONVERGED && found.reason.empty()))
    return "";
  const bool is_reason = found.status == status || found.status == ERROR_LINEAR_SOLVER_FAILED;
  const std::string reason = is_reason && !found.reason.empty() ? found.reason
                           : found.diagnosis ? found.diagnosis->message : check.message;
  return reason.empty() ? "" : " " + reason;
}

// Returns sentences on how far the boundary is from where it may be, where most, and on the remedy.
inline std::string describe_missed_boundary(const Numbered_mesh_3& mesh, const Found_map_3& found, const bool is_refinable)
{
  const auto& [v, allowed, distance] = found.map.farthest_vertex;
  if(v < 0)
    return "";
  const std::string position = "The vertex of the source at " + describe(mesh.source.col(v)) + " is at "
                            + describe(found.map.positions.col(v));
  if(const Vertex_condition_3 condition = found.condition(mesh, v); condition.is_sliding())
    return " " + position + sentence(", ", distance, " off its surface or curve.")
           + (std::isfinite(distance) ? " Let it start nearer to the surface." : " " + std::string(fault_of_surface));
  return sentence(" The largest distance of a vertex to its target is ", distance, ", ", distance / target_diagonal(mesh),
                  " times the diagonal of all targets. ") + position + " instead of " + describe(allowed)
         + sentence(is_refinable ? sentence(". Allow refinement (", way_to_refine, "), or prescribe") : ". Prescribe",
                    " a boundary nearer to the source there.");
}

// Counts the cells that the boundary alone distorts, which refinement splits; empty if there are none.
inline std::string describe_distorted_prescribed_cells(const Numbered_mesh_3& mesh)
{
  const std::size_t number = distorted_prescribed_cells_3(mesh).size();
  return number == 0 ? "" : sentence(" The prescribed vertices alone distort the angles of ",
                                     counted(number, "cell", "cells"), " by a factor above ", large_prescribed_distortion,
                                     ". Refinement (", way_to_refine, ") may lower the distortion much.");
}

// The result where the check does not allow a search, without counts.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Parameterization_result refused_result(const Input_check_3& check, const Progress_3& progress)
{
  Parameterization_result result;
  result.status = check.status;
  result.message = check.message;
  result.seconds_numbering = result.seconds_total = progress.seconds();
  return result;
}

// Returns the result of a search, without counts of the complex. No other place writes it.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Parameterization_result make_result_3(const Numbered_mesh_3& mesh, const Input_check_3& check, const Found_map_3& found,
                                      const Map_problem_3& problem)
{
  const Linear_solver_3& solver = problem.solver;
  const Progress_3& progress = problem.progress;
  const double begin = progress.seconds();
  Parameterization_result result = progress.effort();
  result.status = final_status(found);
  result.message = get_error_message(result.status) + reason_of(result.status, found, check);
  if(const std::size_t number = solver.number_of_cut_solutions(); number > 0)
    result.message += sentence(" The linear solver reached its limit of iterations ", number, " times, which shortened steps. ",
                               mesh.is_whole() ? "CHOLMOD_solver_traits_3 has no limit."
                                                                   : "PETSc's option -ksp_max_it sets it.");
  if(result.status == ERROR_BOUNDARY_NOT_REACHED)
    result.message += describe_missed_boundary(mesh, found, check.is_refinable);
  if((result.status == ERROR_BOUNDARY_NOT_REACHED || result.status == ERROR_NOT_FLIP_FREE)
     && mesh.is_boundary_fixed && mesh.is_whole()) // otherwise facets between processes would seem to be on the boundary
    if(const std::string crossing = describe_self_intersection(mesh, mesh.target, "prescribed boundary", progress.budget());
       !crossing.empty())
      result.message += crossing + ". Few such boundaries have a map without inverted cells, and no such map is one to one.";
  if(found.map.is_valid() && (!mesh.is_boundary_fixed || found.has_slid_on_surfaces))
    if(const std::string crossing = describe_self_intersection(mesh, found.map.positions, "free boundary", progress.budget());
       !crossing.empty())
    {
      result.boundary_crosses_itself = true;
      result.message += crossing + ". Therefore, the map is not one to one.";
    }
  if(found.number_of_open_motions > 0)
    result.message += sentence(" The conditions leave the image as a whole ",
                               counted(std::size_t(found.number_of_open_motions), "motion", "motions"),
                               ". It is where the sum of the squared distances to the source is least.");
  result.has_valid_map = found.map.is_valid();
  if(result.has_valid_map && result.status != ERROR_BOUNDARY_NOT_REACHED && check.is_refinable && mesh.is_whole()
     && !found.has_slid_on_surfaces) // off their targets
    result.message += describe_distorted_prescribed_cells(mesh);
  result.number_of_sliding_vertices = found.number_of_sliding_vertices
    + std::count_if(mesh.conditions.begin(), mesh.conditions.end(), [](const Vertex_condition_3& c) { return c.dimension() > 0; });
  result.number_of_infeasibility_proofs = found.diagnosis ? found.diagnosis->number_of_proofs : 0;
  result.number_of_inverted_cells_at_start = found.number_of_inverted_cells_at_start;
  result.number_of_inverted_cells = found.map.number_of_inverted_cells;
  result.untangling_method = found.untangling_method;
  if(result.has_valid_map)
  {
    const std::vector<Vector_3> s = singular_values_of_cells_3(mesh, found.map.positions);
    const double to_source_volume = factor_to_source_volume(mesh, found.map.positions);
    result.reference_scale = 1 / to_source_volume;
    result.boundary_residual = found.map.distance_to_boundary / target_diagonal(mesh);
    result.distortion = measure_distortion_3(mesh, s);
    result.distortion_at_source_volume = measure_distortion_3(mesh, s, to_source_volume);
    result.energy = mean_energy_3(mesh, s, problem.energy, to_source_volume);
    result.quality = measure_quality_3(mesh, found.map.positions);
    result.unavoidable_angle_distortion = found.unavoidable_angle_distortion;
    result.missed_angle_distortion = found.missed_angle_distortion;
  }
  result.number_of_linear_solver_iterations = solver.number_of_iterations();
  result.seconds_check = progress.seconds() - begin;
  result.seconds_total = progress.seconds();
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MAKE_RESULT_3_H
