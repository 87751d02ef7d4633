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
#include <CGAL/Volume_mesh_parameterization/internal/Map/Infeasibility/Diagnosis_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// A map, how the stages that have led to it ended, and why.
struct Found_map_3
{
  Map_3 map;
  Error_code status = ERROR_NOT_FLIP_FREE;
  std::string reason;                   // for the status; empty if there is nothing to add
  std::string untangling_method;        // that has found the first map
  std::size_t number_of_sliding_vertices = 0;
  std::size_t number_of_inverted_cells_at_start = 0;
  bool is_stuck = false;                // with so few inverted cells that edges at them are to be split
  std::vector<std::array<int, 2> > splits; // edges, if some were found with which fewer cells stay inverted
  std::optional<Diagnosis_3> diagnosis; // why there is no map with fixed boundary
  std::size_t number_of_raises = 0;     // of the weight of the soft boundary
  double unavoidable_angle_distortion = 0; // forced by the prescribed vertices; known where the largest one is minimized
  double missed_angle_distortion = 0;      // the largest bound that was not reached

  // Is a map missing, or does it miss the boundary, such that a refinement may help?
  bool is_blocked() const
  { return is_stuck || status == ERROR_BOUNDARY_NOT_REACHED || (status == ERROR_NOT_CONVERGED && !map.meets_boundary); }
};

// The aims for the corners of hexahedra, and how they are pursued.
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
