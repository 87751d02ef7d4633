// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_HARMONIC_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_HARMONIC_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Linear_solver_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Distortion_derivatives_3.h>

#include <Eigen/Dense>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Moves the free vertices to the minimum of the Dirichlet energy. As it is quadratic, one exact Newton
// step suffices; repeated steps make up for a solver that is not exact.
template <typename Newton>
Linear_solver_status harmonic_map_3(Newton& newton, Eigen::Matrix3Xd& u)
{
  constexpr int maximal_number_of_steps = 20;
  constexpr double solver_tolerance = 1e-3;
  constexpr double energy_tolerance = 1e-9;
  const Dirichlet_energy_3 dirichlet;

  Linear_solver_status status = Linear_solver_status::SUCCESS;
  for(int i = 0; i < maximal_number_of_steps; ++i)
  {
    status = newton.compute_direction(dirichlet, u, 1., solver_tolerance);
    if(status != Linear_solver_status::SUCCESS)
      break;
    u += newton.direction();
    if(-newton.slope() <= energy_tolerance * newton.evaluate(dirichlet, u).energy)
      break;
  }
  return status;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_HARMONIC_MAP_3_H
