// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_HARMONIC_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_HARMONIC_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Newton_iterate_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Moves the unknown vertices to the minimum of the Dirichlet energy. As it is quadratic, one exact Newton step suffices;
// that of a solver which is not exact leaves about the squared tolerance of its gain. Then further steps with the same
// matrix follow, until no more than a part of the energy is left to gain, or the budget is exhausted. Returns the last
// direction, which is not usable if there was none.
inline Newton_direction_3 harmonic_map_3(Newton_system_3& system, Matrix3Xd& positions, Progress_3& progress,
                                         const double energy_tolerance = 1e-14,
                                         const Reference_cells references = Reference_cells::SOURCE)
{
  constexpr int maximum_number_of_steps = 20; // a guess; one to three are usual
  const Dirichlet_energy_3 energy;
  const Cell_energy_of<Dirichlet_energy_3> dirichlet(energy);
  double tolerance = 1e-2;
  system.set_references(references);
  Matrix3Xd u = system.scale() * positions;
  if(progress.is_interrupted())
    return {};
  Newton_direction_3 direction = system.direction(dirichlet, u, 0., tolerance, progress.budget());
  for(int i = 1; direction.is_usable(); ++i)
  {
    u += direction.vectors;
    const double left = -direction.slope * tolerance * tolerance;
    const double allowed = energy_tolerance * system.evaluate(dirichlet, u).energy;
    if(left <= allowed || i == maximum_number_of_steps || progress.is_interrupted())
      break;
    tolerance = std::clamp(0.5 * std::sqrt(allowed / left), 1e-3, 1e-1);
    direction = system.next_direction(dirichlet, u, tolerance, progress.budget());
  }
  positions = u / system.scale();
  return direction;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_HARMONIC_MAP_3_H
