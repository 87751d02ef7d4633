// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_CORNER_GOALS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_CORNER_GOALS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Soft_boundary_parameters.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

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

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_CORNER_GOALS_3_H
