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

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Soft_boundary_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

class Cell_energy_3;
class Linear_solver_3;
class Progress_3;
struct Found_map_3;

// Where the approach of a boundary starts, and how soon it gives up.
struct Approach_start_3
{
  Matrix3Xd positions;       // the images of all vertices, which invert no cell; none: the aligned source
  std::size_t number_of_raises = 0; // of the weight, that have led there
  // So many raises in a row that have not helped are the end.
  std::size_t patience = (std::numeric_limits<std::size_t>::max)();
};

// Where untangling starts, and when it is left to a refinement to go on.
struct Untangling_start_3
{
  Matrix3Xd positions;                 // the images of all vertices; none: the harmonic map
  std::size_t most_inverted_cells_to_split = 0; // if so many at most are left
};

struct Map_options_3;

// Goes on from a map that meets the boundary, where vertices slide or the largest distortion of angles is bounded.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
void improve_map_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy, Linear_solver_3& solver,
                   const Map_options_3& options, Progress_3& progress, Found_map_3& found);

// What is asked for, and with what means.
struct Map_options_3
{
  Boundary_mode mode = Boundary_mode::AUTO;
  Soft_boundary_parameters soft;
  std::vector<Linear_constraint_3<int> > constraints;
  Untangling_start_3 untangling;
  Approach_start_3 approach;
  decltype(&improve_map_3) improve = nullptr; // that, if what follows is wanted; otherwise it need not be compiled
  bool do_slide = false;
  std::vector<bool> is_held;             // of each vertex: must it not slide? None if there are no entries
  double energy_tolerance = 1e-3;        // a part of the energy that is nothing, if five steps gain it,
  double negligible_gain() const { return (std::max)(1e-8, energy_tolerance / 100); } // or one promises this
  double maximal_angle_distortion = std::numeric_limits<double>::infinity();
  bool minimize_maximal_angle_distortion = false;
};

// What the stages have come to.
struct Found_map_3
{
  Map_3 map;
  Error_code status = ERROR_NOT_CONVERGED;
  std::string reason;                   // for the status; empty if there is nothing to add
  std::string untangling_method;        // that has found the first map
  std::size_t number_of_sliding_vertices = 0;
  std::size_t number_of_inverted_cells_at_start = 0;
  bool is_stuck = false;                // with so few inverted cells that they are to be split
  std::vector<std::array<int, 2> > splits; // edges, if some were found with which fewer cells stay inverted
  std::optional<Diagnosis_3> diagnosis; // why there is no map with fixed boundary
  std::size_t number_of_raises = 0;     // of the weight of the soft boundary
  double unavoidable_angle_distortion = 0; // forced by the prescribed vertices; known where the largest one is minimized
  double missed_angle_distortion = 0;      // the largest bound that was not reached

  void take(const Error_code status_of_map, const std::string& reason_of_status, Map_3 found_map)
  {
    status = status_of_map;
    reason = reason_of_status;
    map = std::move(found_map);
  }

  // Is there a map, but not with the prescribed boundary, although nothing has interrupted the search?
  bool is_blocked() const
  { return is_stuck || status == ERROR_BOUNDARY_NOT_REACHED || (status == ERROR_NOT_CONVERGED && !map.meets_boundary); }
};

// What corners of hexahedra are to become, and how.
struct Corner_goals_3
{
  std::vector<Eigen::Matrix3d> projectors; // of each vertex, onto the directions in which it moves
  std::vector<Eigen::Vector3d> edges;      // of each corner: the lengths of its edges where it has right angles
  double mean_edge = 1;
  std::vector<Linear_constraint_3<int> > constraints; // where vertices are wanted
  double weight = 0;                       // of constraints: how many corners a residual of one edge costs as much as
  int exponent = 1;                        // of the energy: 2 for the sake of the worst corners
  std::size_t number_of_steps = 1;         // with positive corners; three times as many to get there
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_FOUND_MAP_3_H
