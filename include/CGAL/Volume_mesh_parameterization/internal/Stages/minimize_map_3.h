// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MINIMIZE_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MINIMIZE_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Scaled_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/minimize_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/newton_step_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Gain_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Map_search_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The images of the vertices that no chosen cell has are unknown.
inline Unknowns_3 unknowns_without_cells(const Numbered_mesh_3& mesh, const Unknowns_3& unknowns,
                                         const std::vector<std::size_t>& cells)
{
  std::vector<bool> is_chosen(mesh.number_of_vertices());
  for(const std::size_t c : cells)
    for(const int v : mesh.cells[c])
      is_chosen[v] = true;
  return unknowns.without([&](const int v) { return is_chosen[v]; });
}

// Minimizes over the free vertices, from a map without inverted cells on. Where the prescribed vertices make a few cells
// so flat that they hold most of the energy, these crawl along curved valleys for thousands of steps, their stiffness
// keeps all others from their minimum, and a minimum up to a part of their energy is none for the others. Then the search
// is over as soon as the energy stagnates or falls for them alone, and the others are minimized alone, in the same way.
inline void minimize_map_3(Newton_system_3& system, const Cell_energy_3& energy, Linear_solver_3& solver,
                           const bool is_parallel, Progress_3& progress, Found_map_3& found,
                           const Negative_curvature& negative_curvature = Negative_curvature())
{
  const Numbered_mesh_3& mesh = system.mesh();
  const auto take = [&](const Newton_result_3& result)
  {
    found.take(result.status, result.reason, judged(mesh, snapped(mesh, result.positions)));
    progress.end_check();
  };
  Gain_3 gain(mesh, energy);
  bool has_crawled = false;
  progress.begin_attempt("minimization");
  const Newton_result_3 whole = minimize_energy_3(
    system, energy, found.map.positions, progress, negative_curvature,
    [&](const Newton_iterate_3& iterate, const Eigen::Matrix3Xd& image)
    { return has_crawled = gain.is_for_dominant_cells_alone(iterate, image); });
  take(whole);
  const bool is_minimum
    = found.status == OK && whole.energy > Gain_3::large_energy && gain.is_dominated(whole.positions);
  if(!is_minimum && !has_crawled)
    return;

  const Unknowns_3 others = unknowns_without_cells(mesh, system.unknowns(), gain.dominant_cells());
  if(others.size() == 0)
    return;
  Newton_system_3 rest(mesh, others, solver, is_parallel);
  Gain_3 gain_of_rest(mesh, energy);
  progress.begin_attempt("minimization apart from dominant cells");
  take(minimize_energy_3(rest, energy, whole.positions, progress, Negative_curvature(),
                         [&](const Newton_iterate_3& iterate, const Eigen::Matrix3Xd&)
                         { return gain_of_rest.is_stagnating(iterate); }));
  if(is_minimum && found.status == ERROR_NOT_CONVERGED)
    found.status = OK; // of the energy as a whole
  if(has_crawled && found.status == OK)
    found.status = ERROR_NOT_CONVERGED;
  if(found.status == ERROR_NOT_CONVERGED)
    found.reason = gain.describe_dominant_cells();
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MINIMIZE_MAP_3_H
