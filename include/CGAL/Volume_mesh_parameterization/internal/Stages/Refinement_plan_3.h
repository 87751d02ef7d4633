// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_REFINEMENT_PLAN_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_REFINEMENT_PLAN_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// What a refinement keeps of the approach that was blocked.
struct Blocked_approach_3
{
  bool goes_on = false;             // from the map reached; otherwise, all starts again with the refined complex
  std::size_t number_of_raises = 0; // of the weight of the soft boundary
  double distance = std::numeric_limits<double>::infinity(); // the largest one to a target
};

struct Refinement_plan_3
{
  std::vector<std::size_t> cells; // whose interior edges are to be split, in the order of the user
  Blocked_approach_3 approach;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_REFINEMENT_PLAN_3_H
