// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_IMPROVE_CORNERS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_IMPROVE_CORNERS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/minimize_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/untangle_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/inline.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The reference of each cell is the corner of a cube with that edge.
inline Scaled_cells_3 cube_corners_3(const Numbered_mesh_3& mesh, const double edge)
{
  const double unit = std::exp2(-std::round(std::log2(edge)));
  const Eigen::Matrix3d inverse = Eigen::Matrix3d::Identity() / (edge * unit);
  return { unit, std::vector<Eigen::Matrix3d>(mesh.cells.size(), inverse), cell_weights(mesh) };
}

// Makes the corners of hexahedra, which are the cells and overlap, positive and as near to right angles as possible:
// untangles, from the targets of all vertices on, and minimizes an energy of angles, with corners of cubes of that edge
// as reference. Each free vertex moves in the directions onto which its projector projects. An exhausted budget ends it
// at the next step.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Map_3 improve_corners_3(const Numbered_mesh_3& mesh, const std::vector<Eigen::Matrix3d>& projectors,
                        const double edge, Linear_solver_3& solver, const bool is_parallel,
                        const Budget& budget)
{
  constexpr std::size_t maximal_number_of_steps = 100;
  constexpr double theta = 0.5; // how much volumes count while untangling
  Map_3 map = judged(mesh, mesh.target);
  if(mesh.number_of_free_vertices == 0 || inverted_prescribed_cells(mesh).number > 0 || budget.is_exhausted())
    return map;

  Progress_3 progress(budget, maximal_number_of_steps);
  Newton_system_3 system(mesh, cube_corners_3(mesh, edge), Unknowns_3(projectors), solver, is_parallel);
  map = judged(mesh, snapped(mesh, untangle_cells_3(system, mesh.target, theta, progress).positions));
  if(!map.is_valid())
    return map;
  const Cell_energy_of<MIPS_energy_3> energy{MIPS_energy_3()};
  progress.begin_stage();
  Map_3 improved = judged(mesh, snapped(mesh, minimize_energy_3(system, energy, map.positions, progress).positions));
  return improved.is_valid() ? improved : map;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_IMPROVE_CORNERS_3_H
