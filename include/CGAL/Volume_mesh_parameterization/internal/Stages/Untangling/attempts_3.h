// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_ATTEMPTS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_ATTEMPTS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Newton/harmonic_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/untangle_cells_3.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// A way to untangle a mesh or a patch of it: from which images, towards what reference cells, and how much their volumes
// count (theta in `Untangling_energy_3`).
struct Untangling_attempt_3
{
  const char* name;
  bool is_harmonic;        // from the harmonic extension with the reference cells, or from the images as they are?
  bool has_regular_cells;  // or those of the source?
  double theta;
  std::size_t few_cells;   // inverted ones, that are left to patches if they take long
  double solver_tolerance;
};

// They are tried in this order. Slivers of the source would stiffen the map, so regular cells of one size come first; a
// large and a smaller theta fail in different places. In some maps of large distortion the source serves better; there
// theta must be small, so that parts that shrink a million times do not dominate the energy. A direction of higher precision
// leads the whole mesh no further, as epsilon changes with each step.
constexpr std::array<Untangling_attempt_3, 3> untangling_attempts = {{
  {"regular cells, theta 20", false, true, 20, 3, 0.3},
  {"regular cells, theta 0.5", false, true, 0.5, 3, 0.3},
  {"cells of the source", false, false, 0.01, 3, 0.3}
}};

// In a patch, which is small, from both starts, and with directions that are as good as may be.
inline std::vector<Untangling_attempt_3> patch_attempts()
{
  std::vector<Untangling_attempt_3> result;
  for(const bool is_harmonic : {false, true})
    for(Untangling_attempt_3 attempt : untangling_attempts)
    {
      attempt.is_harmonic = is_harmonic;
      attempt.few_cells = 0;
      attempt.solver_tolerance = 1e-2;
      result.push_back(attempt);
    }
  return result;
}

// What an attempt makes of these images of all vertices; the system keeps its reference cells.
inline Newton_result_3 untangle_by_3(const Untangling_attempt_3& attempt, Newton_system_3& system,
                                     Eigen::Matrix3Xd positions, Progress_3& progress)
{
  system.set_references(attempt.has_regular_cells ? regular_cells_scaled_to_target(system.mesh())
                                                  : cells_scaled_to_target(system.mesh()));
  if(attempt.is_harmonic)
    harmonic_map_3(system, positions, progress);
  Newton_result_3 result = untangle_cells_3(system, positions, attempt.theta, progress, attempt.few_cells,
                                            attempt.solver_tolerance);
  result.positions = snapped(system.mesh(), result.positions);
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_ATTEMPTS_3_H
