// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_UNTANGLE_PATCHES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_UNTANGLE_PATCHES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/harmonic_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/minimize_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/minimize_untangling_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/Neighborhood_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// A way to untangle a mesh or a patch of it: from which images, towards what reference cells, and how much their volumes
// count (theta in `Untangling_energy_3`).
struct Untangling_attempt_3
{
  const char* name;
  bool is_harmonic;        // from the harmonic extension with the reference cells, or from the images as they are?
  Reference_cells references;
  double theta;
  double solver_tolerance;
};

// Returns the number of inverted cells that patches and splits mend in less time than steps of the whole mesh. A guess: with 20,
// 40 maps and blocks with slivers took half as much time again; with a hundredth of 60,000 cells, one took six times; and with 100
// of 1,500 cells, bodies with winding arms took twice as long as with 20.
inline std::size_t few_inverted_cells(const double number_of_cells)
{ return static_cast<std::size_t>((std::clamp)(number_of_cells / 75, 20., 100.)); }

// They are tried in this order. Slivers of the source would stiffen the map, so regular cells of one size come first; a
// large and a smaller theta fail in different places. In some maps of large distortion the source serves better; there
// theta must be small, so that parts that shrink a million times do not dominate the energy. A direction of higher precision
// leads the whole mesh no further, as epsilon changes with each step.
constexpr std::array<Untangling_attempt_3, 3> untangling_attempts = {{
  {"regular cells, theta 20", false, Reference_cells::REGULAR, 20, 0.3},
  {"regular cells, theta 0.5", false, Reference_cells::REGULAR, 0.5, 0.3},
  {"cells of the source", false, Reference_cells::SOURCE, 0.01, 0.3}
}};

// Returns the attempts in a patch, from both starts. Patches are small, so that their linear systems can be solved more exactly.
inline std::vector<Untangling_attempt_3> patch_attempts()
{
  std::vector<Untangling_attempt_3> result;
  for(const bool is_harmonic : {false, true})
    for(Untangling_attempt_3 attempt : untangling_attempts)
    {
      attempt.is_harmonic = is_harmonic;
      attempt.solver_tolerance = 1e-2;
      result.push_back(attempt);
    }
  return result;
}

// Makes an attempt from these images of all vertices; the system keeps its reference cells.
inline Newton_result_3 untangle_with_3(const Untangling_attempt_3& attempt, Newton_system_3& system,
                                       Matrix3Xd positions, Progress_3& progress, const std::size_t few_cells = 0)
{
  if(attempt.is_harmonic)
    harmonic_map_3(system, positions, progress, 1e-14, attempt.references);
  Newton_result_3 result = minimize_untangling_energy_3(system, positions, attempt.theta, progress, few_cells,
                                                        attempt.solver_tolerance, attempt.references);
  result.positions = snapped(system.mesh(), result.positions);
  return result;
}

// A few steps from images that invert no cell towards the cells of the source.
inline Matrix3Xd relaxed_3(Newton_system_3& system, const Matrix3Xd& positions, const Budget& budget)
{
  constexpr std::size_t number_of_steps = 10; // a guess
  const Untangling_energy_3 barrier(0, 0.01);
  Progress_3 steps(budget, number_of_steps);
  return snapped(system.mesh(),
                 minimize_energy_3(system, Cell_energy_of<Untangling_energy_3>(barrier), positions, steps).positions);
}

// Makes an attempt from the images of a patch. Cells that have just become positive are flat, and are relaxed.
inline Matrix3Xd untangle_patch_with_3(const Untangling_attempt_3& attempt, Newton_system_3& system,
                                              const Matrix3Xd& positions, const Budget& budget)
{
  constexpr std::size_t maximum_number_of_steps = 250; // a guess
  Progress_3 steps(budget, maximum_number_of_steps);
  const Newton_result_3 result = untangle_with_3(attempt, system, positions, steps);
  return result.status == OK ? relaxed_3(system, result.positions, budget) : result.positions;
}

// One attempt after the other, until no cell is inverted. Returns the images with the fewest inverted cells.
inline Matrix3Xd untangled_patch_3(const Numbered_mesh_3& patch, Linear_solver_3& solver,
                                          const Matrix3Xd& start, const Budget& budget)
{
  Newton_system_3 system(patch, free_vertices(patch), solver);
  Matrix3Xd best = start;
  std::size_t fewest = inverted_cells(patch, start).number;
  for(const Untangling_attempt_3& attempt : patch_attempts())
  {
    if(fewest == 0 || budget.is_exhausted())
      break;
    const Matrix3Xd found = untangle_patch_with_3(attempt, system, start, budget);
    if(const std::size_t number = inverted_cells(patch, found).number; number < fewest)
    {
      fewest = number;
      best = found;
    }
  }
  return best;
}

// Untangles where cells are inverted: these with a ring of neighbors, then with two, each connected part as a problem of
// its own in which all other vertices are prescribed where they are. Small problems get past what stops the whole, in
// thousandths of a second. More rings give room to the last cells, and take long. A step is a patch.
inline Newton_result_3 untangle_patches_3(const Numbered_mesh_3& mesh, Linear_solver_3& solver,
                                          const Matrix3Xd& start, Progress_3& progress, const int maximum_number_of_rings = 2)
{
  constexpr std::size_t number_of_last_cells = 20; // a guess
  const auto is_inverted = [](const Matrix3Xd& positions, const std::array<int, 4>& cell)
  { return !is_positive(positions, cell); };
  progress.end_start();
  std::size_t number = inverted_cells(mesh, start).number;
  if(number == 0)
    return { start, 0, OK };
  // has room for cells that become inverted, too
  const Neighborhood_3 neighborhood(mesh, start, is_inverted, maximum_number_of_rings + 1);
  Matrix3Xd positions = neighborhood.positions();
  const auto untangle = [&](const Patch_3& patch)
  {
    Patch_mesh_3 p(neighborhood.mesh(), positions, patch);
    if(!(reference_volume(p.mesh) > 0)) // which does not depend on the vertices that move
      return;
    const std::size_t before = inverted_cells(p.mesh, p.positions).number;
    p.positions = neighborhood.agreed_positions([&]
    { return untangled_patch_3(p.mesh, solver, p.positions, progress.budget()); });
    const std::size_t after = inverted_cells(p.mesh, p.positions).number;
    number -= before - after;
    if(after < before)
      p.write(positions);
  };
  for(int rings = 1; number > 0 && rings <= (number > number_of_last_cells ? 2 : maximum_number_of_rings); ++rings)
  {
    const std::vector<Patch_3> patches = patches_3(neighborhood.mesh(), positions, is_inverted, rings);
    for(auto patch = patches.rbegin(); patch != patches.rend() && progress.may_continue(); ++patch)
    {
      untangle(*patch);
      Parameterization_step step;
      step.phase = Phase::UNTANGLING;
      step.kind = Step_kind::PATCH;
      step.number_of_inverted_cells = number;
      progress.after_step(step);
    }
  }
  return { neighborhood.in_whole(positions), 0, number == 0 ? OK : progress.status_of_end(false) };
}

// Relaxes patches of those cells that are flat, from a map on that inverts none. They hold most of an energy, and a
// minimization over the whole mesh would deal with them in its first ten steps, which take far longer.
inline Matrix3Xd relaxed_flat_cells_3(const Numbered_mesh_3& whole, Linear_solver_3& solver,
                                             const Matrix3Xd& image, const Budget& budget)
{
  constexpr double flat_part = 0.01; // a guess; of the mean volume
  const double flat_volume = flat_part * 6 * volume(whole, image) / whole.global_number_of_cells();
  const auto is_flat = [&](const Matrix3Xd& positions, const std::array<int, 4>& cell)
  { return edge_matrix(positions, cell).determinant() < flat_volume; };
  const Neighborhood_3 neighborhood(whole, image, is_flat, 1);
  Matrix3Xd positions = neighborhood.positions();
  for(const Patch_3& patch : patches_3(neighborhood.mesh(), positions, is_flat, 1))
  {
    Patch_mesh_3 p(neighborhood.mesh(), positions, patch);
    p.positions = neighborhood.agreed_positions([&]() -> Matrix3Xd
    {
      if(budget.is_exhausted())
        return p.positions;
      Newton_system_3 system(p.mesh, free_vertices(p.mesh), solver);
      return relaxed_3(system, p.positions, budget);
    });
    if(inverted_cells(p.mesh, p.positions).number == 0)
      p.write(positions);
  }
  return neighborhood.in_whole(positions);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_UNTANGLE_PATCHES_3_H
