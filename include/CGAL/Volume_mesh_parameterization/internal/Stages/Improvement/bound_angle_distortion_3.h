// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_IMPROVEMENT_BOUND_ANGLE_DISTORTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_IMPROVEMENT_BOUND_ANGLE_DISTORTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Bounded_cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/measure_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/unavoidable_angle_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/sentence.h>

#include <limits>
#include <string>

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
                              const bool is_sliding, const Minimize& minimize, const Progress_3& progress,
                              Found_map_3& found)
{
  double excess = largest_angle_distortion_3(mesh, found.map.positions) - bound;
  if(excess < 0)
    return;
  const auto minimize_relaxed = [&](const double relaxation)
  {
    minimize(Bounded_cell_energy_3(bound, energy, relaxation));
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

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_IMPROVEMENT_BOUND_ANGLE_DISTORTION_3_H
