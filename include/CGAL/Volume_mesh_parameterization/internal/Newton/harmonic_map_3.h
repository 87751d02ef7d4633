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
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_direction_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>

#include <Eigen/Core>

namespace CGAL::Volume_mesh_parameterization::internal {

// Moves the unknown vertices to the minimum of the Dirichlet energy. As it is quadratic, one exact Newton
// step suffices; repeated steps make up for a solver that is not exact, until one gains no more than a part of the energy.
// Returns the last direction.
inline Newton_direction_3 harmonic_map_3(Newton_system_3& system, Eigen::Matrix3Xd& u,
                                         const double energy_tolerance = 1e-9)
{
  constexpr int maximal_number_of_steps = 20;
  constexpr double solver_tolerance = 1e-3;
  const Dirichlet_energy_3 energy;
  const Cell_energy_of<Dirichlet_energy_3> dirichlet(energy);

  Newton_direction_3 direction;
  for(int i = 0; i < maximal_number_of_steps; ++i)
  {
    direction = system.direction(dirichlet, u, 0., solver_tolerance);
    if(!direction.is_usable())
      break;
    u += direction.vectors;
    if(-direction.slope <= energy_tolerance * system.evaluate(dirichlet, u).energy)
      break;
  }
  return direction;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_HARMONIC_MAP_3_H
