// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_PLAN_REFINEMENT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_PLAN_REFINEMENT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Found_map_3.h>

#include <Eigen/Core>

#include <algorithm>
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

// The cells that keep the prescribed vertices farthest from their targets away from there: not positive if all prescribed
// vertices were put on their targets, and with a vertex more than half as far from it as any of these cells has.
// What keeps the others away often resolves itself once these cells give way.
inline std::vector<std::size_t> blocking_cells_3(const Numbered_mesh_3& mesh, const Eigen::Matrix3Xd& positions)
{
  const Eigen::Matrix3Xd at_targets = snapped(mesh, positions);
  const auto distance = [&](const std::size_t c)
  {
    double result = 0;
    for(const int v : mesh.cells[c])
      result = (std::max)(result, (positions.col(v) - at_targets.col(v)).norm());
    return result;
  };

  std::vector<std::size_t> result;
  double farthest = 0;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    if(!is_positive(at_targets, mesh.cells[c]))
    {
      result.push_back(c);
      farthest = (std::max)(farthest, distance(c));
    }
  const auto is_near = [&](const std::size_t c) { return distance(c) < farthest / 2; };
  result.erase(std::remove_if(result.begin(), result.end(), is_near), result.end());
  return result;
}

// Chooses the cells that keep the boundary from its targets; or, where these are fewer, those that the fixed boundary has
// left inverted, to try it again. If the last refinement has not helped, it is better to start all again as well.
inline Refinement_plan_3 plan_refinement_3(const Numbered_mesh_3& mesh, const Found_map_3& found,
                                           const Blocked_approach_3& before)
{
  Refinement_plan_3 plan;
  plan.cells = blocking_cells_3(mesh, found.map.positions);
  const bool is_easier_fixed = found.diagnosis && !found.diagnosis->inverted_cells.empty()
    && found.diagnosis->inverted_cells.size() < plan.cells.size();
  if(is_easier_fixed)
    plan.cells = found.diagnosis->inverted_cells;
  std::sort(plan.cells.begin(), plan.cells.end(),
            [&](const std::size_t c, const std::size_t d) { return mesh.user_number(c) < mesh.user_number(d); });

  plan.approach.distance = found.map.distance_to_boundary;
  plan.approach.goes_on = !is_easier_fixed && (!before.goes_on || plan.approach.distance < 0.9 * before.distance);
  plan.approach.number_of_raises = (std::max)(found.number_of_raises, std::size_t(1)) - 1; // the last one was useless
  return plan;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_PLAN_REFINEMENT_3_H
