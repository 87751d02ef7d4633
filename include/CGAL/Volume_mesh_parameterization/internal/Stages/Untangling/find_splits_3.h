// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_FIND_SPLITS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_FIND_SPLITS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/attempts_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/patches_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/split_patch_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/untangle_patches_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Some of many items that suffice, none of which can be spared, where all of them suffice: leaves out halves, then
// quarters, and so on (delta debugging: Zeller and Hildebrandt, Simplifying and isolating failure-inducing input, IEEE
// Transactions on Software Engineering 28, 2002). Of n items k take O(k log n) questions, if few combinations suffice.
template <typename Item, typename Suffice>
std::vector<Item> minimal_subset(std::vector<Item> items, const Suffice& suffice)
{
  for(std::size_t size = items.size(); size > 1 && items.size() > 1; )
  {
    size = ((std::min)(size, items.size()) + 1) / 2;
    for(std::size_t first = 0; first < items.size() && size < items.size(); )
    {
      std::vector<Item> others(items.begin(), items.begin() + first);
      others.insert(others.end(), items.begin() + first + (std::min)(size, items.size() - first), items.end());
      if(suffice(others))
        items = std::move(others);
      else
        first += size;
    }
  }
  return items;
}

using Edges_3 = std::vector<std::array<int, 2> >;

// The edges of a patch whose splits leave as few cells inverted as possible: splits all edges around inverted cells, and if
// that helps, keeps only those that are needed for it. Splits help if they leave no cell inverted, which they must, or at
// least fewer than now. First the attempt that has helped is asked whether fewer edges suffice, and then, with these, all.
// Calls `after_attempt()` each time, and goes on with no more than it has as soon as that returns false.
template <typename After_attempt>
std::optional<Edges_3> splits_of_patch_3(const Patch_mesh_3& patch, Linear_solver_3& solver, const bool must_untangle,
                                         const Budget& budget, const After_attempt& after_attempt)
{
  bool goes_on = true;
  const auto inverted_cells_after = [&](const Edges_3& edges, const Untangling_attempt_3& attempt)
  {
    Patch_mesh_3 split = patch;
    split_patch_edges_3(split.mesh, split.positions, edges);
    Newton_system_3 system = system_of_patch_3(split.mesh, solver);
    const Eigen::Matrix3Xd found = untangle_patch_by_3(attempt, split.mesh, system, split.positions, budget);
    goes_on = after_attempt();
    return inverted_cells(split.mesh, found).number;
  };
  const std::vector<Untangling_attempt_3> attempts = patch_attempts();
  const Edges_3 all_edges = edges_around_inverted_cells(patch.mesh, patch.positions);
  std::size_t fewest = must_untangle ? 1 : inverted_cells(patch.mesh, patch.positions).number;
  std::optional<Untangling_attempt_3> best;
  for(auto attempt = attempts.begin(); attempt != attempts.end() && fewest > 0 && goes_on; ++attempt)
    if(const std::size_t number = inverted_cells_after(all_edges, *attempt); number < fewest)
    {
      fewest = number;
      best = *attempt;
    }
  if(!best)
    return std::nullopt;
  const auto suffice = [&](const Edges_3& edges, const Untangling_attempt_3& attempt)
  { return goes_on && inverted_cells_after(edges, attempt) <= fewest; };
  const Edges_3 edges = minimal_subset(all_edges, [&](const Edges_3& some) { return suffice(some, *best); });
  return minimal_subset(edges, [&](const Edges_3& some)
  {
    return std::any_of(attempts.begin(), attempts.end(), [&](const auto& attempt) { return suffice(some, attempt); });
  });
}

// Edges to split where untangling is stuck, as few as possible: first so that the patches of inverted cells can be
// untangled, and where that cannot be, so that fewer cells are inverted. A step is an attempt at a patch.
inline Edges_3 find_splits_3(const Numbered_mesh_3& mesh, Linear_solver_3& solver, const Eigen::Matrix3Xd& positions,
                             Progress_3& progress)
{
  struct Level
  {
    int number_of_rings;
    bool must_untangle; // or may cells stay inverted?
  };
  Parameterization_step step;
  step.phase = Phase::UNTANGLING;
  step.kind = Step_kind::SPLIT;
  step.number_of_inverted_cells = inverted_cells(mesh, positions).number;
  const auto after_attempt = [&]
  {
    progress.after_step(step);
    return progress.goes_on();
  };
  Edges_3 result;
  std::vector<bool> is_solved(mesh.number_of_vertices(), false); // the vertices that move in a patch
  const auto is_chosen = [&](const Eigen::Matrix3Xd& image, const std::array<int, 4>& cell)
  {
    return !is_positive(image, cell) && std::none_of(cell.begin(), cell.end(), [&](const int v) { return is_solved[v]; });
  };
  for(const Level level : { Level{1, true}, Level{2, true}, Level{2, false} })
  {
    std::vector<Patch_3> patches = patches_3(mesh, positions, is_chosen, level.number_of_rings);
    for(; !patches.empty() && progress.goes_on(); patches.pop_back())
    {
      const Patch_mesh_3 patch(mesh, positions,
                               with_cells_around_prescribed_edges(mesh, positions, std::move(patches.back())));
      const auto splits = splits_of_patch_3(patch, solver, level.must_untangle, progress.budget(), after_attempt);
      if(!splits)
        continue;
      for(const auto& [a, b] : *splits)
        result.push_back({ patch.vertices[a], patch.vertices[b] });
      for(int i = 0; i < patch.mesh.number_of_free_vertices; ++i)
        is_solved[patch.vertices[i]] = true;
    }
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_FIND_SPLITS_3_H
