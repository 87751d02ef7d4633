// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_UNTANGLE_PATCH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_UNTANGLE_PATCH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Scaled_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Step_status.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Untangler_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/harmonic_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/Untangling_setting.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/relax_flat_cells_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Steps with reference cells from these images on, in the units of the system. Cells that have just become positive are
// flat, and are relaxed.
inline Eigen::Matrix3Xd untangled_3(const Numbered_mesh_3& patch, Newton_system_3& system, const Eigen::Matrix3Xd& u,
                                    const double theta)
{
  constexpr int maximal_number_of_steps = 250;
  Untangler_3 untangler(system, u, theta);
  for(int i = 0; i < maximal_number_of_steps && untangler.step() == Step_status::CONTINUE; ++i) {}
  if(!untangler.evaluation().is_flip_free())
    return untangler.positions();
  system.set_references(patch, cells_scaled_to_target(patch));
  return relaxed_3(system, untangler.positions());
}

// A way to untangle a patch: from its images or from the harmonic map, with a setting.
struct Patch_attempt
{
  bool is_harmonic;
  Untangling_setting setting;
};

inline std::vector<Patch_attempt> patch_attempts()
{
  std::vector<Patch_attempt> result;
  for(const bool is_harmonic : {false, true})
    for(const Untangling_setting& setting : untangling_settings)
      result.push_back({ is_harmonic, setting });
  return result;
}

// The images that an attempt finds from these. The solver serves the patch then.
inline Eigen::Matrix3Xd attempt_patch_3(const Numbered_mesh_3& patch, Linear_solver_3& solver, const Eigen::Matrix3Xd& start,
                                        const Patch_attempt& attempt)
{
  Newton_system_3 system(patch, reference_cells(patch, attempt.setting), free_vertices(patch), solver, false);
  Eigen::Matrix3Xd u = system.unit() * start;
  if(attempt.is_harmonic)
    harmonic_map_3(system, u);
  return snapped(patch, untangled_3(patch, system, u, attempt.setting.theta) / system.unit());
}

// One attempt after the other, until no cell is inverted. Keeps the images with the fewest inverted cells, and returns their
// number.
inline std::size_t untangle_patch_3(const Numbered_mesh_3& patch, Linear_solver_3& solver, Eigen::Matrix3Xd& image)
{
  std::size_t fewest = inverted_cells(patch, image).number;
  const Eigen::Matrix3Xd start = image;
  for(const Patch_attempt& attempt : patch_attempts())
  {
    if(fewest == 0)
      break;
    const Eigen::Matrix3Xd found = attempt_patch_3(patch, solver, start, attempt);
    const std::size_t number = inverted_cells(patch, found).number;
    if(number < fewest)
    {
      fewest = number;
      image = found;
    }
  }
  return fewest;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_UNTANGLE_PATCH_3_H
