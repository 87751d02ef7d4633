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

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

class Cell_energy_3;
class Linear_solver_3;
class Progress_3;
struct Map_problem_3;

// Why no map was found with fixed boundary.
struct Diagnosis_3
{
  std::vector<std::size_t> inverted_cells;
  std::size_t number_of_proofs = 0; // that there is none
  std::string message;
};

using Edges_3 = std::vector<std::array<int, 2> >;

// Edges to split, and images of their new vertices and of all others.
struct Splits_3
{
  Edges_3 edges;
  std::vector<Eigen::Vector3d> new_images;
  Matrix3Xd positions;
};

// A map, how the stages that have led to it ended, and why.
struct Found_map_3
{
  Map_3 map;
  Error_code status = ERROR_NOT_FLIP_FREE;
  std::string reason;                   // for the status; empty if there is nothing to add
  std::string untangling_method;        // that has found the first map
  bool may_be_near_minimum = false;     // if the initial map needed no step to untangle; then the full Hessian is tried first
  std::size_t number_of_sliding_vertices = 0;
  std::size_t number_of_inverted_cells_at_start = 0;
  Splits_3 splits;                      // with which fewer cells are inverted, if few are left and some were found
  std::optional<Diagnosis_3> diagnosis; // why there is no map with fixed boundary
  std::size_t number_of_raises = 0;     // of the weight of the soft boundary
  double unavoidable_angle_distortion = 0; // forced by the prescribed vertices; known where the largest one is minimized
  double missed_angle_distortion = 0;      // the largest bound that was not reached

  // Are cells left inverted, and splits known that make them fewer?
  bool is_stuck() const { return !splits.edges.empty(); }

  // Is a map missing, or does it miss the boundary, such that a refinement may help?
  bool is_blocked() const
  { return is_stuck() || status == ERROR_BOUNDARY_NOT_REACHED || (status == ERROR_NOT_CONVERGED && !map.meets_boundary); }
};

// Where a search for a map starts, and what the searches before the last refinements have come to.
struct Search_start_3
{
  enum class Stage { NONE, UNTANGLING, SOFT_BOUNDARY };

  Stage stage = Stage::NONE;        // that continues from the positions; the others start anew
  Matrix3Xd positions = {};         // the images of all vertices, which the soft boundary takes only without inverted cells
  std::string method = "harmonic extension"; // that has led there
  std::size_t number_of_raises = 0; // of the weight of the soft boundary, that have led there
  double distance = std::numeric_limits<double>::infinity(); // the largest one to a target, where that was blocked
  double smallest_distance = std::numeric_limits<double>::infinity(); // of those after all refinements
  std::size_t number_of_vain_refinements = 0; // that did not lower that
  std::size_t fewest_inverted_cells = (std::numeric_limits<std::size_t>::max)(); // that rounds of splits have left
  std::size_t number_of_vain_rounds = 0; // of splits that did not make them fewer
  bool may_split = false;           // may edges be split after the search?
  std::size_t patience = (std::numeric_limits<std::size_t>::max)(); // raises in vain, one after the other, that end it

  // After two rounds in vain, a guess, cells that untangling leaves inverted are left to the soft boundary.
  bool has_given_up_splits() const { return number_of_vain_rounds >= 2; }
  bool may_split_inverted_cells() const { return may_split && !has_given_up_splits(); }
};

// Continues from a map that meets the boundary: vertices of planar regions slide, and the distortion of angles is bounded.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Found_map_3 slide_and_bound_angles_3(const Numbered_mesh_3& mesh, const Map_problem_3& problem, Found_map_3 found);

struct Map_options_3
{
  Boundary_mode mode = Boundary_mode::AUTO;
  Refinement_mode refinement = Refinement_mode::HELPFUL; // of a body that may be refined
  Soft_boundary_parameters soft;
  bool do_slide = false;
  double energy_tolerance = 1e-3;        // a part of the energy that is nothing, if five steps gain it,
  double negligible_gain() const { return (std::max)(1e-8, energy_tolerance / 100); } // or one promises this
  double maximum_angle_distortion = std::numeric_limits<double>::infinity();
  bool minimize_maximum_angle_distortion = false;
  decltype(&slide_and_bound_angles_3) improve = nullptr; // if it is wanted; otherwise it need not be compiled
  bool use_volume_weights = false;
  bool use_regular_references = false;   // in place of the cells of the source, which may be tangled
  bool is_parallel = false;
  bool verbose = false;
};

// Tells what is asked for, and by what means it is found.
struct Map_problem_3
{
  Map_options_3 options;
  const Cell_energy_3& energy;
  Linear_solver_3& solver;
  Progress_3& progress;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MAP_PROBLEM_3_H
