// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MAP_PROBLEM_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MAP_PROBLEM_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace CGAL::Volume_mesh_parameterization::internal {

class Cell_energy_3;
class Linear_solver_3;
class Progress_3;
struct Found_map_3;
struct Map_problem_3;
struct Numbered_mesh_3;

// Continues from a map that meets the boundary: vertices of planar regions slide, and the distortion of angles is bounded.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Found_map_3 slide_and_bound_angles_3(const Numbered_mesh_3& mesh, const Map_problem_3& problem, Found_map_3 found);

struct Map_options_3
{
  Boundary_mode mode = Boundary_mode::AUTO;
  Refinement_mode refinement = Refinement_mode::HELPFUL; // of a body that may be refined
  Soft_boundary_parameters soft;
  double energy_tolerance = 1e-3;        // a part of the energy that is nothing, if five steps gain it,
  double negligible_gain() const { return (std::max)(1e-8, energy_tolerance / 100); } // or one promises this
  double maximum_angle_distortion = std::numeric_limits<double>::infinity();
  bool minimize_maximum_angle_distortion = false;
  decltype(&slide_and_bound_angles_3) improve = nullptr; // if it is wanted; otherwise it need not be compiled
  std::optional<double> reference_scale; // given by the user; `found_reference_scale` stands for one that is found
  bool use_volume_weights = false;
  bool use_regular_references = false;   // in place of the cells of the source, which may be tangled
  bool is_parallel = false;
  bool verbose = false;
};

// Problem of finding a map: what the user wants, and the means to find it.
struct Map_problem_3
{
  Map_options_3 options;
  const Cell_energy_3& energy;
  Linear_solver_3& solver;
  Progress_3& progress;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MAP_PROBLEM_3_H
