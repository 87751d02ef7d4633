// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_FIND_SPLITS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_FIND_SPLITS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/untangle_patches_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

using Edges_3 = std::vector<std::array<int, 2> >;

// Calls f for the edges of a cell, in ascending order of their vertices, that join two prescribed ones.
template <typename Function>
void for_each_prescribed_edge(const Numbered_mesh_3& mesh, const std::array<int, 4>& cell, const Function& f)
{
  for(const int a : cell)
    for(const int b : cell)
      if(a < b && !mesh.is_free(a) && !mesh.is_free(b))
        f(std::array<int, 2>{a, b});
}

// The patch with all cells around edges that join two prescribed vertices: those in the patch, and those at the vertices of
// its inverted cells. Such edges have prescribed directions, which can be what keeps cells between them from being positive;
// and an edge can be split only with all cells around it.
inline Patch_3 with_cells_around_prescribed_edges(const Numbered_mesh_3& mesh, const Map_3& map, Patch_3 patch)
{
  std::set<std::array<int, 2> > edges;
  std::set<int> centers;
  for(const std::size_t c : patch.cells)
  {
    for_each_prescribed_edge(mesh, mesh.cells[c], [&](const std::array<int, 2>& edge) { edges.insert(edge); });
    if(std::binary_search(map.inverted_cells.begin(), map.inverted_cells.end(), c))
      centers.insert(mesh.cells[c].begin(), mesh.cells[c].end());
  }
  std::set<std::size_t> cells(patch.cells.begin(), patch.cells.end());
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    for_each_prescribed_edge(mesh, mesh.cells[c], [&](const std::array<int, 2>& edge)
    {
      if(edges.count(edge) > 0 || centers.count(edge[0]) > 0 || centers.count(edge[1]) > 0)
        cells.insert(c);
    });
  patch.cells.assign(cells.begin(), cells.end());
  return patch;
}

// Do cells lie all around an edge?
inline bool is_inside(const Numbered_mesh_3& mesh, const std::array<int, 2>& edge)
{
  std::map<int, int> number_of_cells; // at the facets of the edge and a third vertex
  for(const std::array<int, 4>& cell : mesh.cells)
    if(std::count(cell.begin(), cell.end(), edge[0]) > 0 && std::count(cell.begin(), cell.end(), edge[1]) > 0)
      for(const int v : cell)
        if(v != edge[0] && v != edge[1])
          ++number_of_cells[v];
  return std::all_of(number_of_cells.begin(), number_of_cells.end(), [](const auto& facet) { return facet.second == 2; });
}

// The edges of a patch at vertices of inverted cells that move; and those inside that join two prescribed vertices, and are
// in a cell at any vertex of an inverted one. Those of inverted cells come last.
inline Edges_3 edges_around_inverted_cells(const Numbered_mesh_3& patch, const Matrix3Xd& image)
{
  std::set<int> centers;
  for(const std::size_t c : inverted_cells(patch, image).cells)
    centers.insert(patch.cells[c].begin(), patch.cells[c].end());
  std::map<std::array<int, 2>, bool> is_of_inverted_cell;
  for(const std::array<int, 4>& cell : patch.cells)
  {
    const bool is_inverted = !is_positive(image, cell);
    const auto is_center = [&](const int v) { return centers.count(v) > 0; };
    for(const int v : cell)
      for(const int w : cell)
        if(patch.is_free(v) && is_center(v) && v != w)
          is_of_inverted_cell[{(std::min)(v, w), (std::max)(v, w)}] |= is_inverted;
    if(std::any_of(cell.begin(), cell.end(), is_center))
      for_each_prescribed_edge(patch, cell, [&](const std::array<int, 2>& edge)
      { is_of_inverted_cell[edge] |= is_inverted; });
  }
  Edges_3 result;
  for(const bool is_last : {false, true})
    for(const auto& [edge, is_of_inverted] : is_of_inverted_cell)
      if(is_of_inverted == is_last && (patch.is_free(edge[0]) || is_inside(patch, edge)))
        result.push_back(edge);
  return result;
}

// The points with the midpoints of edges, which come after the first n points.
inline Matrix3Xd with_midpoints(const Matrix3Xd& points, const Edges_3& edges, const int n)
{
  Matrix3Xd result(3, points.cols() + edges.size());
  result.leftCols(n) = points.leftCols(n);
  result.rightCols(points.cols() - n) = points.rightCols(points.cols() - n);
  for(std::size_t i = 0; i < edges.size(); ++i)
    result.col(n + i) = (points.col(edges[i][0]) + points.col(edges[i][1])) / 2;
  return result;
}

// Splits edges of a patch, one after the other, at their midpoints in source and image. The new vertices move.
inline void split_patch_edges_3(Numbered_mesh_3& patch, Matrix3Xd& image, const Edges_3& edges)
{
  const int n = patch.number_of_free_vertices;
  const int number_of_edges = static_cast<int>(edges.size());
  patch.source = with_midpoints(patch.source, edges, n);
  image = with_midpoints(image, edges, n);
  patch.number_of_free_vertices += number_of_edges;
  patch.set_targets(image, patch.base_point);

  const auto number = [&](const int v) { return v < n ? v : v + number_of_edges; };
  for(std::array<int, 4>& cell : patch.cells)
    std::transform(cell.begin(), cell.end(), cell.begin(), number);
  for(int i = 0; i < number_of_edges; ++i)
    for(std::size_t c = patch.cells.size(); c-- > 0; )
    {
      std::array<int, 4> halves[2] = { patch.cells[c], patch.cells[c] };
      const auto a = std::find(halves[0].begin(), halves[0].end(), number(edges[i][0]));
      const auto b = std::find(halves[1].begin(), halves[1].end(), number(edges[i][1]));
      if(a == halves[0].end() || b == halves[1].end())
        continue;
      *a = *b = n + i;
      patch.cells[c] = halves[0];
      patch.cells.push_back(halves[1]);
    }
}

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
      std::vector<Item> other_items(items.begin(), items.begin() + first);
      other_items.insert(other_items.end(), items.begin() + first + (std::min)(size, items.size() - first), items.end());
      if(suffice(other_items))
        items = std::move(other_items);
      else
        first += size;
    }
  }
  return items;
}

// The edges of a patch whose splits leave as few cells inverted as possible: splits all edges around inverted cells, and if
// that helps, keeps only those that are needed for it. Splits help if they leave no cell inverted, which they must, or at
// least fewer than now. First the attempt that has helped is asked whether fewer edges suffice, and then, with these, all.
// Calls `after_attempt()` each time, and goes on with no more than it has as soon as that returns false.
template <typename After_attempt>
std::optional<Edges_3> splits_of_patch_3(const Patch_mesh_3& patch, Linear_solver_3& solver, const bool must_untangle,
                                         const Budget& budget, const After_attempt& after_attempt)
{
  bool may_continue = true;
  const auto inverted_cells_after = [&](const Edges_3& edges, const Untangling_attempt_3& attempt)
  {
    Patch_mesh_3 split = patch;
    split_patch_edges_3(split.mesh, split.positions, edges);
    Newton_system_3 system(split.mesh, free_vertices(split.mesh), solver);
    const Matrix3Xd found = untangle_patch_with_3(attempt, system, split.positions, budget);
    may_continue = after_attempt();
    return inverted_cells(split.mesh, found).number;
  };
  const std::vector<Untangling_attempt_3> attempts = patch_attempts();
  const Edges_3 all_edges = edges_around_inverted_cells(patch.mesh, patch.positions);
  std::size_t fewest = must_untangle ? 1 : inverted_cells(patch.mesh, patch.positions).number;
  std::optional<Untangling_attempt_3> best;
  for(auto attempt = attempts.begin(); attempt != attempts.end() && fewest > 0 && may_continue; ++attempt)
    if(const std::size_t number = inverted_cells_after(all_edges, *attempt); number < fewest)
    {
      fewest = number;
      best = *attempt;
    }
  if(!best)
    return std::nullopt;
  const auto suffice = [&](const Edges_3& edges, const Untangling_attempt_3& attempt)
  { return may_continue && inverted_cells_after(edges, attempt) <= fewest; };
  const Edges_3 edges = minimal_subset(all_edges, [&](const Edges_3& some_edges) { return suffice(some_edges, *best); });
  return minimal_subset(edges, [&](const Edges_3& some_edges)
  {
    return std::any_of(attempts.begin(), attempts.end(), [&](const auto& attempt) { return suffice(some_edges, attempt); });
  });
}

// Edges to split where untangling is stuck, as few as possible: first so that the patches of inverted cells can be
// untangled, and where that cannot be, so that fewer cells are inverted. A step is an attempt at a patch.
inline Edges_3 find_splits_3(const Numbered_mesh_3& mesh, Linear_solver_3& solver, const Map_3& map, Progress_3& progress)
{
  struct Level
  {
    int number_of_rings;
    bool must_untangle; // or may cells stay inverted?
  };
  Parameterization_step step;
  step.phase = Phase::UNTANGLING;
  step.kind = Step_kind::SPLIT;
  step.number_of_inverted_cells = map.number_of_inverted_cells;
  const auto after_attempt = [&]
  {
    progress.after_step(step);
    return progress.may_continue();
  };
  Edges_3 result;
  std::vector<bool> is_solved(mesh.number_of_vertices(), false); // the vertices that move in a patch
  const auto is_chosen = [&](const Matrix3Xd& image, const std::array<int, 4>& cell)
  {
    return !is_positive(image, cell) && std::none_of(cell.begin(), cell.end(), [&](const int v) { return is_solved[v]; });
  };
  for(const Level level : { Level{1, true}, Level{2, true}, Level{2, false} })
  {
    std::vector<Patch_3> patches = patches_3(mesh, map.positions, is_chosen, level.number_of_rings);
    for(; !patches.empty() && progress.may_continue(); patches.pop_back())
    {
      const Patch_mesh_3 patch(mesh, map.positions,
                               with_cells_around_prescribed_edges(mesh, map, std::move(patches.back())));
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

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_FIND_SPLITS_3_H
