// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_IMPROVE_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_IMPROVE_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Any_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Bounded_angle_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Sliding_boundary_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/measure_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/minimize_energy_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

inline std::string describe_angle_distortion(const double reached, const double unavoidable)
{
  return sentence("The largest distortion of angles is ", reached, ".")
         + (unavoidable > 2 ? sentence(" The prescribed vertices alone force ", unavoidable, ".") : "");
}

// Brings the distortion of angles of every cell below a bound, by a barrier. It is relaxed, less and less, until no
// cell exceeds the bound, or the excess hardly falls. Once none does, no step does so any more, and the energy is
// minimized below the bound. `minimize` is a function of the energy that goes on from the map found so far.
template <typename Minimize>
void bound_angle_distortion_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy, const double bound,
                              const bool is_sliding, const Minimize& minimize, Progress_3& progress, Found_map_3& found)
{
  double excess = largest_angle_distortion_3(mesh, found.map.positions) - bound;
  if(excess < 0)
    return;
  const Any_energy_3 unbounded(std::shared_ptr<const Cell_energy_3>(std::shared_ptr<void>(), &energy));
  const auto minimize_relaxed = [&](const double relaxation)
  {
    minimize(cell_energy_3(Bounded_angle_energy_3<Any_energy_3>(bound, unbounded, relaxation)));
    excess = largest_angle_distortion_3(mesh, found.map.positions) - bound;
  };
  double previous = std::numeric_limits<double>::infinity();
  for(double relaxation = 0.05; excess >= 0 && relaxation > 1e-6 && !progress.is_interrupted(); relaxation /= 5)
  {
    minimize_relaxed(relaxation);
    if(excess > previous / 2)
      break;
    previous = excess;
  }
  if(excess < 0 && !progress.is_interrupted())
    minimize_relaxed(0);
  if(!(excess < 0) && !progress.is_interrupted())
  {
    found.status = ERROR_ANGLE_BOUND_NOT_REACHED;
    found.reason = describe_angle_distortion(bound + excess, is_sliding ? 0 : unavoidable_angle_distortion_3(mesh));
  }
}

// The least bound of the distortion of angles, by bisection between what the prescribed vertices force and what the map
// has. A map below one bound is the start for the next one; after a vain attempt, the search goes on from the best map.
template <typename Minimize>
void minimize_angle_distortion_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy, const bool is_sliding,
                                 const Minimize& minimize, Progress_3& progress, Found_map_3& found)
{
  constexpr double precision = 0.02; // relative
  found.unavoidable_angle_distortion = is_sliding ? 2 : unavoidable_angle_distortion_3(mesh);
  found.missed_angle_distortion = found.unavoidable_angle_distortion;
  double reached = largest_angle_distortion_3(mesh, found.map.positions);
  while(reached > (1 + precision) * found.missed_angle_distortion && !progress.is_interrupted())
  {
    const Found_map_3 best = found;
    const double bound = std::sqrt(found.missed_angle_distortion * reached);
    bound_angle_distortion_3(mesh, energy, bound, is_sliding, minimize, progress, found);
    const double largest = found.map.is_solution() ? largest_angle_distortion_3(mesh, found.map.positions) : reached;
    if(largest < bound)
      reached = largest;
    else
    {
      const Error_code status = found.status;
      found = best;
      if(progress.is_interrupted())
        found.status = status;
      else
        found.missed_angle_distortion = bound;
    }
  }
}

// Goes on from a map that meets the boundary: vertices of planar patches slide, and the distortion of angles is bounded.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
void improve_map_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy, Linear_solver_3& solver,
                   const Map_options_3& options, Progress_3& progress, Found_map_3& found)
{
  const double bound = options.maximal_angle_distortion;
  const auto exceeds_bound = [&]()
  { return std::isfinite(bound) && !(largest_angle_distortion_3(mesh, found.map.positions) < bound); };
  if(!options.do_slide && !options.minimize_maximal_angle_distortion && !exceeds_bound())
    return;
  const bool is_bounded = std::isfinite(bound) || options.minimize_maximal_angle_distortion;
  if(progress.is_interrupted())
  {
    found.status = ERROR_INTERRUPTED;
    return;
  }
  std::optional<Sliding_boundary_3> sliding;
  if(options.do_slide)
  {
    sliding.emplace(mesh, [&](const int v) { return !options.is_held.empty() && options.is_held[v]; });
    found.number_of_sliding_vertices = sliding->number_of_sliding_vertices();
  }
  Newton_system_3 system(mesh, sliding ? Unknowns_3(sliding->projectors()) : free_vertices(mesh), solver);
  const auto minimize = [&](const Cell_energy_3& psi, const Ends_here& ends_here = nullptr)
  {
    progress.begin_stage();
    const Newton_result_3 result
      = minimize_energy_3(system, psi, found.map.positions, progress, Negative_curvature(), ends_here,
                          options.negligible_gain());
    found.take(result.status, result.reason, sliding ? judged(mesh, *sliding, sliding->restored(result.positions))
                                                     : judged(mesh, snapped(mesh, result.positions)));
    progress.end_check();
  };
  progress.begin_attempt(sliding ? "sliding boundary" : "bound of angles");
  if(sliding)
    minimize(energy, ends_if_stagnating(mesh, energy, options));
  if(found.map.is_solution() && !progress.is_interrupted() && std::isfinite(bound))
    bound_angle_distortion_3(mesh, energy, bound, sliding.has_value(), minimize, progress, found);
  if(found.map.is_solution() && !progress.is_interrupted() && options.minimize_maximal_angle_distortion)
    minimize_angle_distortion_3(mesh, energy, sliding.has_value(), minimize, progress, found);
  if(is_bounded && found.status == OK && progress.is_interrupted())
    found.status = ERROR_INTERRUPTED;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_IMPROVE_MAP_3_H
