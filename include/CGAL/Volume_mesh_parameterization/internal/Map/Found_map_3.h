// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_FOUND_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_FOUND_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Map_problem_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Input_check_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

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
  std::vector<Vector_3> new_images;
  Matrix3Xd positions;
  bool are_all = false; // is no cell inverted with them, in this order?
};

// Map that stages have found, how they ended, and why.
struct Found_map_3
{
  Map_3 map;
  Error_code status = ERROR_NOT_FLIP_FREE;
  std::string reason;                   // for the status; empty if there is nothing to add
  std::string untangling_method;        // that has found the first map
  bool may_be_near_minimum = false;     // if the initial map needed no step to untangle; then the full Hessian is tried first
  std::size_t number_of_sliding_vertices = 0;
  Conditions_3 conditions;              // of prescribed vertices that have slid; none if none has
  int number_of_open_motions = 0;       // of the image as a whole, by conditions and energy
  bool has_slid_on_surfaces = false;    // whose facets may intersect each other if they did before
  std::size_t number_of_inverted_cells_at_start = 0;
  Splits_3 splits;                      // of edges, if few cells are left inverted: with which they are fewer, or all of theirs
  std::optional<Diagnosis_3> diagnosis; // why there is no map with fixed boundary
  std::size_t number_of_raises = 0;     // of the weight of the soft boundary
  double unavoidable_angle_distortion = 0; // forced by the prescribed vertices; known where the largest one is minimized
  double missed_angle_distortion = 0;      // the largest bound that was not reached

  // The condition that the map was checked for.
  Vertex_condition_3 condition(const Numbered_mesh_3& mesh, const int v) const
  { return conditions.empty() || mesh.is_free(v) ? mesh.condition(v) : conditions[v - mesh.number_of_free_vertices]; }

  // Are cells left inverted, and splits known that make them fewer?
  bool is_stuck() const { return !splits.edges.empty(); }

  // Is a map missing, or does it miss the boundary, such that a refinement may help?
  bool is_blocked() const
  { return is_stuck() || status == ERROR_BOUNDARY_NOT_REACHED || (status == ERROR_NOT_CONVERGED && !map.meets_boundary); }
};

// Start of a search for a map, and what the searches before the last refinements have reached.
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
  std::size_t number_of_rounds = 0; // of splits
  std::size_t number_of_vain_rounds = 0; // those at the end that did not make them fewer
  bool may_split = false;           // may edges be split after the search?
  std::size_t patience = (std::numeric_limits<std::size_t>::max)(); // raises in vain, one after the other, that end it

  // Returns whether the cells that untangling leaves inverted are left to the soft boundary: after three rounds in vain, a guess.
  bool has_given_up_splits() const { return number_of_vain_rounds >= 3; }
  bool may_split_inverted_cells() const { return may_split && !has_given_up_splits(); }
};

// The parts of the seam of the map, which processes that share a mesh call one by one.
// Can there be a map? Names the first reason against it.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Input_check_3 check_input_3(const Numbered_mesh_3& mesh, const Budget& budget = Budget());

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Found_map_3 find_map_3(const Numbered_mesh_3& mesh, const Input_check_3& check, const Map_problem_3& problem,
                       const Search_start_3& start = Search_start_3());

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Parameterization_result make_result_3(const Numbered_mesh_3& mesh, const Input_check_3& check, const Found_map_3& found,
                                      const Map_problem_3& problem);

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Parameterization_result refused_result(const Input_check_3& check, const Progress_3& progress);

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_FOUND_MAP_3_H
