// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_COMPLETED_INITIAL_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_COMPLETED_INITIAL_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Scaled_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/harmonic_map_3.h>

#include <Eigen/Core>

namespace CGAL::Volume_mesh_parameterization::internal {

// The initial map with an image for each vertex: a prescribed vertex without one is on its target, and the others
// without one, as those that a refinement has inserted, are where they minimize the Dirichlet energy.
inline Eigen::Matrix3Xd completed_initial_map_3(const Numbered_mesh_3& mesh, Linear_solver_3& solver,
                                                const bool is_parallel)
{
  Eigen::Matrix3Xd result = mesh.initial;
  const auto is_missing = [&](const int v) { return mesh.initial.col(v).array().isNaN().any(); };
  for(int v = 0; v < result.cols(); ++v)
    if(is_missing(v))
      result.col(v) = mesh.target.col(v);
  const Unknowns_3 unknowns(static_cast<int>(result.cols()),
                            [&](const int v) { return mesh.is_free(v) && is_missing(v); });
  if(unknowns.size() == 0)
    return result;
  Newton_system_3 system(mesh, cells_scaled_to_target(mesh), unknowns, solver, is_parallel);
  result *= system.unit();
  harmonic_map_3(system, result);
  return result / system.unit();
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_COMPLETED_INITIAL_MAP_3_H
