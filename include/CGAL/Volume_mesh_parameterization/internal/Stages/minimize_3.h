// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MINIMIZE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MINIMIZE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Scaled_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Negative_curvature.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Crawl_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Minimization_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Stage_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/dominant_cells_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Minimizes over the free vertices, from a map without inverted cells on. Where the prescribed vertices make a few cells
// so flat that they hold most of the energy, these crawl along curved valleys for thousands of steps, their stiffness
// keeps all others from their minimum, and a minimum up to a part of their energy is none for the others. Then the search
// is over as soon as the energy stagnates or falls for them alone, and the others are minimized alone, in the same way.
inline void minimize_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy, Newton_system_3& system,
                       Linear_solver_3& solver, const bool is_parallel, const std::size_t number_of_steps_before,
                       Progress_3& progress, Found_map_3& found,
                       const Negative_curvature& negative_curvature = Negative_curvature())
{
  const auto run = [&](Minimization_3& minimization, const double begin, const std::size_t number_of_steps)
  {
    const Error_code status = progress.run(minimization, begin, number_of_steps);
    take_over(minimization, status, judged(mesh, snapped(mesh, minimization.positions())), found);
  };
  Crawl_3 crawl(mesh, energy);
  const auto is_crawling = [&](const auto& step, const bool is_stagnating, const auto& positions)
  { return crawl.notice(step, is_stagnating, positions); };
  Minimization_3 minimization(system, energy, found.map.positions, is_crawling, negative_curvature);
  run(minimization, progress.seconds(), number_of_steps_before);
  const bool is_minimum = found.status == OK && minimization.last_step().energy > Crawl_3::large_energy
                          && crawl.is_dominated(minimization.positions());
  const bool has_crawled = found.status == ERROR_NOT_CONVERGED && crawl.is_noticed();
  if(!is_minimum && !has_crawled)
    return;

  const double begin = progress.seconds();
  std::vector<bool> is_dominant(mesh.number_of_vertices());
  for(const std::size_t c : crawl.dominant().cells)
    for(const int v : mesh.cells[c])
      is_dominant[v] = true;
  const Unknowns_3 others = system.unknowns().without([&](const int v) { return is_dominant[v]; });
  if(others.size() == 0)
    return;
  Newton_system_3 rest(mesh, cells_scaled_to_target(mesh), others, solver, is_parallel);
  Minimization_3 minimization_of_rest(rest, energy, minimization.positions(),
                                      [](const auto&, const bool is_stagnating, const auto&) { return is_stagnating; });
  run(minimization_of_rest, begin, number_of_steps_before + minimization.last_step().iteration);
  system.claim_solver();
  if(is_minimum && found.status == ERROR_NOT_CONVERGED)
    found.status = OK; // of the energy as a whole
  if(has_crawled && found.status == OK)
    found.status = ERROR_NOT_CONVERGED;
  if(found.status == ERROR_NOT_CONVERGED)
    found.reason = describe(crawl.dominant(), mesh);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MINIMIZE_3_H
