// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PLAN_REFINEMENT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PLAN_REFINEMENT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_body_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Edges to split, those inside of them, in the order of the user's cells; and the start of the next search.
struct Refinement_plan_3
{
  Edges_3 edges;
  std::vector<Vector_3> new_images; // of their new vertices, or empty
  Search_start_3 start;
};

inline void sort_by_user_number(const Numbered_mesh_3& mesh, std::vector<std::size_t>& cells)
{
  std::sort(cells.begin(), cells.end(),
            [&](const std::size_t c, const std::size_t d) { return mesh.user_number(c) < mesh.user_number(d); });
}

inline Edges_3 edges_of_cells(const Numbered_mesh_3& mesh, const std::vector<std::size_t>& cells)
{
  Edges_3 result;
  for(const std::size_t c : cells)
    for(int i = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j)
        result.push_back({mesh.cells[c][i], mesh.cells[c][j]});
  return result;
}

// Plans to split the edges that untangling has found, and to continue from its map. After rounds in vain, nothing is split.
inline Refinement_plan_3 plan_splits_3(const Found_map_3& found, const Search_start_3& before)
{
  const std::size_t number = found.splits.are_all ? 0 : found.map.number_of_inverted_cells;
  Refinement_plan_3 plan;
  plan.start.number_of_rounds = before.number_of_rounds + 1;
  plan.start.number_of_vain_rounds = number < before.fewest_inverted_cells ? 0 : before.number_of_vain_rounds + 1;
  plan.start.fewest_inverted_cells = (std::min)(number, before.fewest_inverted_cells);
  if(plan.start.has_given_up_splits())
    return plan;
  plan.edges = found.splits.edges;
  plan.new_images = found.splits.new_images;
  plan.start.stage = Search_start_3::Stage::UNTANGLING;
  plan.start.positions = found.splits.positions;
  plan.start.method = found.splits.are_all ? "expansion of a core" : "splits";
  return plan;
}

// Returns the cells that block the boundary most. A cell blocks it if it were not positive with all prescribed vertices on their
// targets. Of these cells, those count that have a vertex at more than half of the largest distance to its target: once they give
// way, the others often do so, too.
inline std::vector<std::size_t> blocking_cells_3(const Numbered_mesh_3& mesh, const Matrix3Xd& positions)
{
  const Matrix3Xd at_targets = snapped(mesh, positions);
  const auto distance = [&](const std::size_t c)
  {
    double result = 0;
    for(const int v : mesh.cells[c])
      result = (std::max)(result, (positions.col(v) - at_targets.col(v)).norm());
    return result;
  };

  std::vector<std::size_t> result = inverted_cells(mesh, at_targets).cells;
  double farthest = 0;
  for(const std::size_t c : result)
    farthest = (std::max)(farthest, distance(c));
  const auto is_near = [&](const std::size_t c) { return distance(c) < farthest / 2; };
  result.erase(std::remove_if(result.begin(), result.end(), is_near), result.end());
  return result;
}

// Plans to split the edges of the cells that block the boundary, or, if these are fewer, of the cells that the fixed boundary has
// left inverted. The soft boundary continues from its map; if the last refinement has hardly helped, all starts anew. If several
// refinements have not helped, nothing is split.
inline Refinement_plan_3 plan_refinement_3(const Numbered_mesh_3& mesh, const Found_map_3& found,
                                           const Search_start_3& before)
{
  if(found.is_stuck())
    return plan_splits_3(found, before);
  constexpr double notable = 0.9; // a guess; a distance that is shorter by a tenth
  constexpr std::size_t patience = 3; // a guess: maps that were found needed no more than one such round
  Refinement_plan_3 plan;
  plan.start.distance = found.map.distance_to_boundary;
  plan.start.smallest_distance = (std::min)(plan.start.distance, before.smallest_distance);
  plan.start.number_of_vain_refinements
    = plan.start.distance < notable * before.smallest_distance ? 0 : before.number_of_vain_refinements + 1;
  if(plan.start.number_of_vain_refinements >= patience)
    return plan;
  std::vector<std::size_t> cells = blocking_cells_3(mesh, found.map.positions);
  const bool is_easier_fixed = !before.has_given_up_splits() && found.diagnosis && !found.diagnosis->inverted_cells.empty()
    && found.diagnosis->inverted_cells.size() < cells.size();
  if(is_easier_fixed)
    cells = found.diagnosis->inverted_cells;
  sort_by_user_number(mesh, cells);
  plan.edges = edges_of_cells(mesh, cells);

  if(before.has_given_up_splits())
    plan.start.number_of_vain_rounds = before.number_of_vain_rounds;
  const bool has_helped
    = before.stage != Search_start_3::Stage::SOFT_BOUNDARY || plan.start.distance < notable * before.distance;
  if(!is_easier_fixed && has_helped)
  {
    plan.start.stage = Search_start_3::Stage::SOFT_BOUNDARY;
    plan.start.positions = found.map.positions;
    plan.start.number_of_raises = (std::max)(found.number_of_raises, std::size_t(1)) - 1; // the last one was useless
  }
  return plan;
}

// Renumbers the positions of a start after a refinement. `points_before` are the points of the vertices before it. New vertices
// have the images of the plan, or else those of midpoints. If rounding there inverts a cell, the soft boundary starts anew.
inline Search_start_3 renumbered_start_3(const Refinement_plan_3& plan, const std::vector<std::size_t>& points_before,
                                         const std::vector<Insertion_3>& insertions, const Numbered_body_3& after)
{
  Search_start_3 start = plan.start;
  if(start.stage == Search_start_3::Stage::NONE)
    return start;
  Matrix3Xd images(3, after.vertices.size()); // of the points
  for(std::size_t v = 0; v < points_before.size(); ++v)
    images.col(points_before[v]) = start.positions.col(v);
  for(const Insertion_3& i : insertions)
    images.col(i.point) = (images.col(i.simplex[0]) + images.col(i.simplex[1])) / 2;
  for(std::size_t e = 0; e < plan.new_images.size(); ++e)
    for(const Insertion_3& i : insertions)
      if(i.simplex == Simplex_3{ points_before[plan.edges[e][0]], points_before[plan.edges[e][1]] })
        images.col(i.point) = plan.new_images[e];
  start.positions.resize(3, after.points.size());
  for(std::size_t v = 0; v < after.points.size(); ++v)
    start.positions.col(v) = images.col(after.points[v]);
  if(start.stage == Search_start_3::Stage::SOFT_BOUNDARY && inverted_cells(after.mesh, start.positions).number > 0)
  {
    start.stage = Search_start_3::Stage::NONE;
    start.number_of_raises = 0;
  }
  return start;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PLAN_REFINEMENT_3_H
