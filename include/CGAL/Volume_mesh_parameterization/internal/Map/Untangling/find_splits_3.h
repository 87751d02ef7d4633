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

#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/untangle_patches_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Calls f for the edges of a cell, in ascending order of their vertices, that join two prescribed ones.
template <typename Function>
void for_each_prescribed_edge(const Numbered_mesh_3& mesh, const std::array<int, 4>& cell, const Function& f)
{
  for(const int a : cell)
    for(const int b : cell)
      if(a < b && mesh.is_fixed(a) && mesh.is_fixed(b))
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

// Returns edges of a patch that may be split: each edge at a vertex of an inverted cell, if this vertex moves, and each interior
// edge between two prescribed vertices, if it is in a cell at a vertex of an inverted cell. Edges of inverted cells come last.
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
  for(const bool are_of_inverted : {false, true})
    for(const auto& [edge, is_of_inverted] : is_of_inverted_cell)
      if(is_of_inverted == are_of_inverted && ((patch.is_free(edge[0]) && !patch.alignment) || is_inside(patch, edge)))
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

// Splits edges of a patch, the longest first, as it is done to a body, at their midpoints in source and image. The new
// vertices move. Takes time linear in the numbers of cells and, if the degrees of vertices are bounded, of edges.
inline void split_patch_edges_3(Numbered_mesh_3& patch, Matrix3Xd& image, const Edges_3& edges)
{
  const int n = patch.number_of_free_vertices;
  const int number_of_edges = static_cast<int>(edges.size());
  const auto squared_length = [source = patch.source, &edges](const int i)
  { return (source.col(edges[i][0]) - source.col(edges[i][1])).squaredNorm(); };
  std::vector<int> order(number_of_edges);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](const int i, const int j) { return squared_length(i) > squared_length(j); });
  patch.source = with_midpoints(patch.source, edges, n);
  image = with_midpoints(image, edges, n);
  patch.number_of_free_vertices += number_of_edges;
  patch.set_targets(image, patch.base_point);

  const auto number = [&](const int v) { return v < n ? v : v + number_of_edges; };
  for(std::array<int, 4>& cell : patch.cells)
    std::transform(cell.begin(), cell.end(), cell.begin(), number);
  std::vector<std::vector<std::size_t> > cells_at(patch.number_of_vertices()); // ascending, at the ends of edges
  for(std::size_t c = 0; c < patch.cells.size(); ++c)
    for(const int v : patch.cells[c])
      cells_at[v].push_back(c);
  for(const int i : order)
  {
    const int a = number(edges[i][0]), b = number(edges[i][1]), midpoint = n + i;
    const std::vector<std::size_t> cells_at_a = cells_at[a];
    for(auto c = cells_at_a.rbegin(); c != cells_at_a.rend(); ++c)
    {
      std::array<int, 4>& cell = patch.cells[*c];
      if(std::count(cell.begin(), cell.end(), b) == 0)
        continue;
      std::array<int, 4> half = cell;
      std::replace(cell.begin(), cell.end(), a, midpoint);
      cells_at[a].erase(std::find(cells_at[a].begin(), cells_at[a].end(), *c));
      std::replace(half.begin(), half.end(), b, midpoint);
      for(const int v : half)
        cells_at[v].push_back(patch.cells.size());
      patch.cells.push_back(half);
    }
  }
}

// Leaves out halves of some items, then quarters, and so on, where the others suffice (delta debugging: Zeller and Hildebrandt,
// Simplifying and isolating failure-inducing input, IEEE Transactions on Software Engineering 28, 2002). Calls
// `leave_out(first, number)`, which returns whether these can be spared and, if so, does without. To keep k of n items takes
// O(k log n) calls, if few combinations suffice.
template <typename Leave_out>
void leave_out_unneeded(std::size_t number_of_items, const Leave_out& leave_out)
{
  for(std::size_t size = number_of_items; size > 1 && number_of_items > 1; )
  {
    size = ((std::min)(size, number_of_items) + 1) / 2;
    for(std::size_t first = 0; first < number_of_items && size < number_of_items; )
      if(const std::size_t number = (std::min)(size, number_of_items - first); leave_out(first, number))
        number_of_items -= number;
      else
        first += size;
  }
}

// Edges of a patch whose splits leave as few cells inverted as possible: splits all edges around inverted cells, and if that
// helps, keeps only those that are needed for it. Splits help if they leave no cell inverted, which they must, or at least
// fewer than now. New vertices are left out first where all others can stay, and then where untangling from there suffices, as
// long as these attempts have no more cells in all than given: in large patches they would take longer than they save. Calls
// `after_attempt()` each time, and goes on with no more than it has as soon as that returns false.
template <typename After_attempt>
std::optional<Splits_3> splits_of_patch_3(const Patch_mesh_3& patch, Linear_solver_3& solver, const bool must_untangle,
                                         std::size_t cells_left, const Budget& budget,
                                         const After_attempt& after_attempt)
{
  const int n = patch.mesh.number_of_free_vertices;
  bool may_continue = true;
  Edges_3 edges = edges_around_inverted_cells(patch.mesh, patch.positions);
  Matrix3Xd image; // after their splits
  std::size_t fewest = must_untangle ? 1 : inverted_cells(patch.mesh, patch.positions).number;
  std::optional<Untangling_attempt_3> best;
  const auto split_patch = [&](const Edges_3& some_edges)
  {
    Patch_mesh_3 split = patch;
    split_patch_edges_3(split.mesh, split.positions, some_edges);
    return split;
  };
  const auto inverted_cells_after = [&](const Untangling_attempt_3& attempt, Patch_mesh_3& split)
  {
    Newton_system_3 system(split.mesh, free_vertices(split.mesh), solver);
    split.positions = untangle_patch_with_3(attempt, system, split.positions, budget);
    may_continue = after_attempt();
    return inverted_cells(split.mesh, split.positions).number;
  };
  for(const Untangling_attempt_3& attempt : patch_attempts())
  {
    if(fewest == 0 || !may_continue)
      break;
    Patch_mesh_3 split = split_patch(edges);
    if(const std::size_t number = inverted_cells_after(attempt, split); number < fewest)
    {
      fewest = number;
      best = attempt;
      image = std::move(split.positions);
    }
  }
  if(!best)
    return std::nullopt;
  best->is_harmonic = false;
  const auto leave_out = [&](const std::size_t first, const std::size_t number, const bool may_move)
  {
    if(budget.is_exhausted())
      return false;
    Edges_3 other_edges = edges;
    other_edges.erase(other_edges.begin() + first, other_edges.begin() + first + number);
    Patch_mesh_3 split = split_patch(other_edges);
    const Eigen::Index column = n + first;
    split.positions << image.leftCols(column), image.rightCols(image.cols() - column - number);
    if(inverted_cells(split.mesh, split.positions).number > fewest)
    {
      if(!may_move || !may_continue || split.mesh.cells.size() > cells_left)
        return false;
      cells_left -= split.mesh.cells.size();
      if(inverted_cells_after(*best, split) > fewest)
        return false;
    }
    edges = std::move(other_edges);
    image = std::move(split.positions);
    return true;
  };
  for(const bool may_move : {false, true})
    leave_out_unneeded(edges.size(), [&](const std::size_t first, const std::size_t number)
                   { return leave_out(first, number, may_move); });
  Splits_3 result{ edges, {}, image.leftCols(n) };
  for(std::size_t i = 0; i < edges.size(); ++i)
    result.new_images.push_back(image.col(n + i));
  return result;
}

// Edges to split where untangling is stuck, as few as possible: so that the patches of inverted cells can be untangled or, if
// that cannot be in the largest patches either, so that fewer cells are inverted. A step is an attempt at a patch.
inline Splits_3 find_splits_3(const Numbered_mesh_3& mesh, Linear_solver_3& solver, const Map_3& map, Progress_3& progress)
{
  constexpr int maximum_number_of_rings = 3; // a guess: with 2, single cells stay inverted now and then that 3 have room for
  constexpr std::size_t maximum_number_of_cells = 100000; // a guess: a few seconds; patches of 300 cells need a tenth of it
  Parameterization_step step;
  step.phase = Phase::UNTANGLING;
  step.kind = Step_kind::SPLIT;
  step.number_of_inverted_cells = map.number_of_inverted_cells;
  const auto after_attempt = [&]
  {
    progress.after_step(step);
    return progress.may_continue();
  };
  Splits_3 result{ {}, {}, map.positions };
  std::vector<bool> is_solved(mesh.number_of_vertices(), false); // the vertices that move in a patch
  const auto is_chosen = [&](const Matrix3Xd& image, const std::array<int, 4>& cell)
  {
    return !is_positive(image, cell) && std::none_of(cell.begin(), cell.end(), [&](const int v) { return is_solved[v]; });
  };
  for(int rings = 1; rings <= maximum_number_of_rings; ++rings)
  {
    const bool must_untangle = rings < maximum_number_of_rings;
    std::vector<Patch_3> patches = patches_3(mesh, map.positions, is_chosen, rings);
    for(; !patches.empty() && progress.may_continue(); patches.pop_back())
    {
      std::set<int>& moving = patches.back().moving;
      moving.erase(moving.lower_bound(mesh.number_of_free_vertices), moving.end()); // those in planes or on lines stay
      if(std::any_of(moving.begin(), moving.end(), [&](const int v) { return bool(is_solved[v]); }))
        continue;
      const Patch_mesh_3 patch(mesh, map.positions,
                               with_cells_around_prescribed_edges(mesh, map, std::move(patches.back())));
      const auto splits
        = splits_of_patch_3(patch, solver, must_untangle, maximum_number_of_cells, progress.budget(), after_attempt);
      if(!splits)
        continue;
      for(const auto& [a, b] : splits->edges)
        result.edges.push_back({ patch.vertices[a], patch.vertices[b] });
      result.new_images.insert(result.new_images.end(), splits->new_images.begin(), splits->new_images.end());
      for(int i = 0; i < patch.mesh.number_of_free_vertices; ++i)
      {
        result.positions.col(patch.vertices[i]) = splits->positions.col(i);
        is_solved[patch.vertices[i]] = true;
      }
    }
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_FIND_SPLITS_3_H
