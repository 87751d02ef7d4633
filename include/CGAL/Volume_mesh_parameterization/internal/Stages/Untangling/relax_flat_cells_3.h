// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_RELAX_FLAT_CELLS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_RELAX_FLAT_CELLS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Untangling_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Scaled_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Minimizer_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Step_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/Neighborhood_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/patches_3.h>

#include <Eigen/Core>

#include <array>

namespace CGAL::Volume_mesh_parameterization::internal {

// A few steps from images that invert no cell towards the reference cells of the system.
inline Eigen::Matrix3Xd relaxed_3(Newton_system_3& system, const Eigen::Matrix3Xd& u)
{
  constexpr int number_of_steps = 10;
  const Untangling_energy_3 barrier(0, 0.01);
  const Cell_energy_of<Untangling_energy_3> energy(barrier);
  Minimizer_3 minimizer(system, energy, u);
  for(int i = 0; i < number_of_steps && minimizer.step() == Step_status::CONTINUE; ++i) {}
  return minimizer.positions();
}

// The same for patches of those cells that are flat, from a map on that inverts none. They hold most of an energy, and a
// minimization over the whole mesh would deal with them in its first ten steps, which take far longer. The solver serves
// these patches then.
inline void relax_flat_cells_3(const Numbered_mesh_3& whole, Linear_solver_3& solver, Eigen::Matrix3Xd& image)
{
  constexpr double flat_part = 0.01; // of the mean volume
  const double flat = flat_part * 6 * volume(whole, image) / whole.number_of_all_cells();
  const auto is_flat = [&](const Eigen::Matrix3Xd& positions, const std::array<int, 4>& cell)
  { return edge_matrix(positions, cell).determinant() < flat; };
  const Neighborhood_3 neighborhood(whole, image, is_flat, 1);
  Eigen::Matrix3Xd positions = neighborhood.positions();
  for(const Patch_3& patch : patches_3(neighborhood.mesh(), positions, is_flat, 1))
  {
    Patch_mesh_3 p(neighborhood.mesh(), positions, patch);
    p.positions = neighborhood.found_by_first([&]() -> Eigen::Matrix3Xd
    {
      Newton_system_3 system(p.mesh, cells_scaled_to_target(p.mesh), free_vertices(p.mesh), solver, false);
      return snapped(p.mesh, relaxed_3(system, system.unit() * p.positions) / system.unit());
    });
    if(inverted_cells(p.mesh, p.positions).number == 0)
      p.write(positions);
  }
  image = neighborhood.in_whole(positions);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_RELAX_FLAT_CELLS_3_H
