// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_SLIDE_AND_BOUND_ANGLES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_SLIDE_AND_BOUND_ANGLES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Any_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Bounded_angle_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Sliding_boundary_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/measure_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/minimize_map_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

inline std::string describe_angle_distortion(const double reached, const double unavoidable)
{
  return sentence("The largest distortion of angles is ", reached, ".")
         + (unavoidable > 2 ? sentence(" The prescribed vertices alone force ", unavoidable, ".") : "");
}

// Brings the distortion of angles of every cell below a bound, by a barrier. The barrier is relaxed less and less, until no cell
// exceeds the bound, or the excess hardly falls. A step never lifts a cell above the bound again: then the energy is minimized
// below it. If the bound is missed, a map with a much larger energy than before is not kept.
// `minimize(energy, map)` continues from a map.
template <typename Minimize>
Found_map_3 bound_angle_distortion_3(const Numbered_mesh_3& mesh, const Map_problem_3& problem, const double bound,
                                     const bool is_sliding, const Minimize& minimize, Found_map_3 found)
{
  double excess = largest_angle_distortion_3(mesh, found.map.positions) - bound;
  if(excess < 0)
    return found;
  constexpr double high_price = 2; // a guess; of the energy before
  const auto energy = [&](const Matrix3Xd& positions) { return mean_energy_3(mesh, positions, problem.energy); };
  const double bearable_energy = high_price * energy(found.map.positions);
  Map_3 nearest = found.map; // to the bound, of those with a bearable energy
  const Any_energy_3 unbounded(std::shared_ptr<const Cell_energy_3>(std::shared_ptr<void>(), &problem.energy));
  const auto minimize_relaxed = [&](const double relaxation)
  {
    found = minimize(cell_energy_3(Bounded_angle_energy_3<Any_energy_3>(bound, unbounded, relaxation)), std::move(found));
    excess = largest_angle_distortion_3(mesh, found.map.positions) - bound;
    if(energy(found.map.positions) <= bearable_energy)
      nearest = found.map;
  };
  double previous = std::numeric_limits<double>::infinity();
  for(double relaxation = 0.05; excess >= 0 && relaxation > 1e-6 && !problem.progress.is_interrupted(); relaxation /= 5)
  {
    minimize_relaxed(relaxation);
    if(excess > previous / 2)
      break;
    previous = excess;
  }
  if(excess < 0 && !problem.progress.is_interrupted())
    minimize_relaxed(0);
  if(excess < 0)
    return found;
  found.map = std::move(nearest);
  if(!problem.progress.is_interrupted())
  {
    found.status = ERROR_ANGLE_BOUND_NOT_REACHED;
    found.reason = describe_angle_distortion(largest_angle_distortion_3(mesh, found.map.positions),
                                             is_sliding ? 0 : unavoidable_angle_distortion_3(mesh));
  }
  return found;
}

// Finds the least bound of the distortion of angles, by bisection between what the prescribed vertices force and what the
// map has. A map below one bound is the start for the next one; after a vain attempt, the search continues from the best map.
template <typename Minimize>
Found_map_3 minimize_angle_distortion_3(const Numbered_mesh_3& mesh, const Map_problem_3& problem, const bool is_sliding,
                                        const Minimize& minimize, Found_map_3 found)
{
  constexpr double precision = 0.02; // a guess; relative
  found.unavoidable_angle_distortion = is_sliding ? 2 : unavoidable_angle_distortion_3(mesh);
  found.missed_angle_distortion = found.unavoidable_angle_distortion;
  double reached = largest_angle_distortion_3(mesh, found.map.positions);
  while(reached > (1 + precision) * found.missed_angle_distortion && !problem.progress.is_interrupted())
  {
    const double bound = std::sqrt(found.missed_angle_distortion * reached);
    Found_map_3 bounded = bound_angle_distortion_3(mesh, problem, bound, is_sliding, minimize, found);
    const double largest = bounded.map.is_solution() ? largest_angle_distortion_3(mesh, bounded.map.positions) : reached;
    if(largest < bound)
    {
      reached = largest;
      found = std::move(bounded);
    }
    else if(!problem.progress.is_interrupted())
      found.missed_angle_distortion = bound;
  }
  return found;
}

// Have vertices moved in the tangents of the surfaces on which they slide?
inline bool have_slid_in_tangents(const Numbered_mesh_3& mesh)
{
  for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices() && !mesh.sliding_conditions.empty(); ++v)
    if(mesh.sliding_conditions[v - mesh.number_of_free_vertices].is_sliding() && !mesh.is_fixed(v))
      return true;
  return false;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Found_map_3 slide_and_bound_angles_3(const Numbered_mesh_3& mesh, const Map_problem_3& problem, Found_map_3 found)
{
  const Map_options_3& options = problem.options;
  Progress_3& progress = problem.progress;
  const double bound = options.maximum_angle_distortion;
  const bool exceeds_bound
    = std::isfinite(bound) && !(largest_angle_distortion_3(mesh, found.map.positions) < bound);
  const bool do_slide = !mesh.sliding_conditions.empty();
  if((!do_slide && !options.minimize_maximum_angle_distortion && !exceeds_bound) || progress.is_interrupted())
    return found;
  const Sliding_boundary_3 boundary(mesh);
  found.number_of_sliding_vertices = boundary.number_of_sliding_vertices();
  found.conditions = boundary.conditions();
  found.has_slid_on_surfaces = are_some_on_surfaces(boundary.conditions());
  if(are_some_in_boundary(mesh.sliding_conditions) && found.has_slid_on_surfaces)
  { // folds may end the sliding early, so it starts at the minimum of the fixed boundary
    Newton_system_3 fixed(mesh, free_vertices(mesh), problem.solver);
    found = minimize_map_3(fixed, problem, std::move(found));
    if(found.status == ERROR_LINEAR_SOLVER_FAILED || !found.map.is_solution() || progress.is_interrupted())
      return found;
  }
  if(have_slid_in_tangents(mesh))
  {
    found.map = evaluated_map(mesh, boundary, found.map.positions);
    if(!found.map.is_valid())
    {
      found.status = ERROR_NOT_FLIP_FREE;
      found.reason = "Vertices have slid in the tangent planes of curved walls, and cells are inverted if they are put back. Move "
                     "the targets in smaller steps, each with the last map as initial map.";
      return found;
    }
  }
  Newton_system_3 system(mesh, free_vertices(mesh, boundary.conditions()), problem.solver);
  if(found.has_slid_on_surfaces)
    system.keep_boundary_embedded(found.map.positions);
  const auto minimize = [&](const Cell_energy_3& psi, Found_map_3 from, const Ends_here& ends_here = nullptr)
  {
    progress.begin_stage();
    const Newton_result_3 result = minimize_energy_3(system, psi, from.map.positions, progress, Negative_curvature(),
                                                     ends_here, options.negligible_gain());
    from.map = evaluated_map(mesh, boundary, result.positions);
    from.status = result.status;
    from.reason = result.reason;
    progress.end_check();
    return from;
  };
  progress.begin_attempt(do_slide ? "sliding boundary" : "bound of angles");
  if(do_slide)
    found = minimize(problem.energy, std::move(found), ends_if_stagnating(mesh, problem));
  if(std::isfinite(bound) && found.map.is_solution() && !progress.is_interrupted())
    found = bound_angle_distortion_3(mesh, problem, bound, do_slide, minimize, std::move(found));
  if(options.minimize_maximum_angle_distortion && found.map.is_solution() && !progress.is_interrupted())
    found = minimize_angle_distortion_3(mesh, problem, do_slide, minimize, std::move(found));
  return found;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_SLIDE_AND_BOUND_ANGLES_3_H
