// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MAP_OPTIONS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MAP_OPTIONS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Soft_boundary_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/inline.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

class Cell_energy_3;
class Linear_solver_3;
class Progress_3;
struct Numbered_mesh_3;
struct Found_map_3;

// Where the approach of a boundary starts, and how soon it gives up.
struct Approach_start_3
{
  Eigen::Matrix3Xd positions;       // the images of all vertices, which invert no cell; none: the aligned source
  std::size_t number_of_raises = 0; // of the weight, that have led there
  // So many raises in a row that have not helped are the end.
  std::size_t patience = (std::numeric_limits<std::size_t>::max)();
};

// Where untangling starts, and when it is left to a refinement to go on.
struct Untangling_start_3
{
  Eigen::Matrix3Xd positions;                 // the images of all vertices; none: the harmonic map
  std::size_t most_inverted_cells_to_split = 0; // if so many at most are left
};

struct Map_options_3;

// What goes on from a map that meets the boundary.
using Improvement_3 = void (*)(const Numbered_mesh_3&, const Cell_energy_3&, Linear_solver_3&, const Map_options_3&,
                               Progress_3&, Found_map_3&);

// What is asked for, and with what means.
struct Map_options_3
{
  Boundary_mode mode = Boundary_mode::AUTO;
  Soft_boundary_parameters soft;
  std::vector<Linear_constraint_3<int> > constraints;
  Untangling_start_3 untangling;
  Approach_start_3 approach;
  Improvement_3 improve = nullptr;       // by what follows, if that is wanted; otherwise it need not be compiled
  bool do_slide = false;
  std::vector<bool> is_held;             // of each vertex: must it not slide? None if there are no entries
  double energy_tolerance = 1e-3;        // a part of the energy that is nothing, if five steps gain it,
  double negligible_gain() const { return (std::max)(1e-8, energy_tolerance / 100); } // or one promises this
  double maximal_angle_distortion = std::numeric_limits<double>::infinity();
  bool minimize_maximal_angle_distortion = false;
};

// Where vertices slide, or the largest distortion of angles is bounded.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
void improve_map_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy, Linear_solver_3& solver,
                   const Map_options_3& options, Progress_3& progress, Found_map_3& found);

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MAP_OPTIONS_3_H
