// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_SPLIT_PATCH_EDGES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_SPLIT_PATCH_EDGES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/patches_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

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
inline Patch_3 with_cells_around_prescribed_edges(const Numbered_mesh_3& mesh, const Eigen::Matrix3Xd& image, Patch_3 patch)
{
  std::set<std::array<int, 2> > edges;
  std::set<int> centers;
  for(const std::size_t c : patch.cells)
  {
    for_each_prescribed_edge(mesh, mesh.cells[c], [&](const std::array<int, 2>& edge) { edges.insert(edge); });
    if(!is_positive(image, mesh.cells[c]))
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
inline std::vector<std::array<int, 2> > edges_around_inverted_cells(const Numbered_mesh_3& patch,
                                                                    const Eigen::Matrix3Xd& image)
{
  std::set<int> centers;
  for(const std::array<int, 4>& cell : patch.cells)
    if(!is_positive(image, cell))
      centers.insert(cell.begin(), cell.end());
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
      {
        is_of_inverted_cell[edge] |= is_inverted;
      });
  }
  std::vector<std::array<int, 2> > result;
  for(const bool is_last : {false, true})
    for(const auto& [edge, is_of_inverted] : is_of_inverted_cell)
      if(is_of_inverted == is_last && (patch.is_free(edge[0]) || is_inside(patch, edge)))
        result.push_back(edge);
  return result;
}

// The points with the midpoints of edges, which come after the first n points.
inline Eigen::Matrix3Xd with_midpoints(const Eigen::Matrix3Xd& points, const std::vector<std::array<int, 2> >& edges,
                                       const int n)
{
  Eigen::Matrix3Xd result(3, points.cols() + edges.size());
  result.leftCols(n) = points.leftCols(n);
  result.rightCols(points.cols() - n) = points.rightCols(points.cols() - n);
  for(std::size_t i = 0; i < edges.size(); ++i)
    result.col(n + i) = (points.col(edges[i][0]) + points.col(edges[i][1])) / 2;
  return result;
}

// Splits edges of a patch, one after the other, at their midpoints in source and image. The new vertices move.
inline void split_patch_edges_3(Numbered_mesh_3& patch, Eigen::Matrix3Xd& image,
                                const std::vector<std::array<int, 2> >& edges)
{
  const int n = patch.number_of_free_vertices;
  const int number_of_edges = static_cast<int>(edges.size());
  patch.source = with_midpoints(patch.source, edges, n);
  image = with_midpoints(image, edges, n);
  patch.number_of_free_vertices += number_of_edges;
  patch.target = image;
  patch.target.leftCols(patch.number_of_free_vertices).setZero();

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

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_SPLIT_PATCH_EDGES_3_H
