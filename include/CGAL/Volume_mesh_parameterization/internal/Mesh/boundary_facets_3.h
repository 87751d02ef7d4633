// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_BOUNDARY_FACETS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_BOUNDARY_FACETS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Parallel/for_each_index.h>

#include <CGAL/Union_find.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Union_find for the indices from 0 to n - 1. Those of Boost do not compile after some headers of Boost's graphs.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(const std::size_t n)
  {
    m_handles.reserve(n);
    for(std::size_t i = 0; i < n; ++i)
      m_handles.push_back(m_sets.make_set(i));
  }

  void unite(const std::size_t i, const std::size_t j) { m_sets.unify_sets(m_handles[i], m_handles[j]); }

  // The index that stands for the set of i.
  std::size_t find(const std::size_t i) { return *m_sets.find(m_handles[i]); }

private:
  Union_find<std::size_t> m_sets;
  std::vector<Union_find<std::size_t>::handle> m_handles;
};

// Sorts pairs, and calls `f(begin, end)` for all that have the same first element, an array of vertices. They are put into
// compressed rows by their first vertex, which takes linear time, and the short rows are sorted, in parallel if asked for.
template <typename Pair, typename Function>
void for_each_group(const std::vector<Pair>& pairs, const Function& f, const bool is_parallel = false)
{
  constexpr int rows_per_range = 1024;
  std::size_t number_of_rows = 0;
  for(const Pair& pair : pairs)
    number_of_rows = (std::max)(number_of_rows, static_cast<std::size_t>(pair.first[0]) + 1);
  std::vector<std::size_t> row_begin(number_of_rows + 2, 0); // while it is filled, one place further
  for(const Pair& pair : pairs)
    ++row_begin[pair.first[0] + 2];
  std::partial_sum(row_begin.begin(), row_begin.end(), row_begin.begin());
  std::vector<Pair> sorted(pairs.size());
  for(const Pair& pair : pairs)
    sorted[row_begin[pair.first[0] + 1]++] = pair;
  for_each_range(is_parallel, number_of_rows, rows_per_range, [&](std::size_t, const std::size_t first, const std::size_t last)
  {
    for(std::size_t row = first; row < last; ++row)
      std::sort(sorted.begin() + row_begin[row], sorted.begin() + row_begin[row + 1]);
  });
  for(auto begin = sorted.begin(), end = begin; begin != sorted.end(); begin = end)
  {
    end = std::find_if(begin, sorted.end(), [&](const Pair& pair) { return pair.first != begin->first; });
    f(begin, end);
  }
}

// Calls `f(begin, end)` for each edge, with a pair for each of its facets: its vertices, the smaller first, and the corners
// there, where corner k of facet i is 3 i + k.
template <typename Vertex, typename Function>
void for_each_edge(const std::vector<std::array<Vertex, 3> >& facets, const Function& f)
{
  std::vector<std::pair<std::array<Vertex, 2>, std::array<std::size_t, 2> > > edges;
  edges.reserve(3 * facets.size());
  for(std::size_t i = 0; i < facets.size(); ++i)
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t l = (k + 1) % 3;
      const bool is_sorted = facets[i][k] < facets[i][l];
      const std::size_t first = is_sorted ? k : l, second = is_sorted ? l : k;
      edges.push_back({ { facets[i][first], facets[i][second] }, { 3 * i + first, 3 * i + second } });
    }
  for_each_group(edges, f);
}

// Those of the faces of all cells that occur once, in whatever order of their vertices.
template <typename Face>
std::vector<Face> faces_of_one_cell(const std::vector<Face>& faces, const bool is_parallel)
{
  std::vector<std::pair<Face, Face> > pairs; // with vertices sorted, and as they are
  pairs.reserve(faces.size());
  for(const Face& face : faces)
  {
    pairs.emplace_back(face, face);
    std::sort(pairs.back().first.begin(), pairs.back().first.end());
  }
  std::vector<Face> result;
  for_each_group(pairs, [&](const auto begin, const auto end)
  {
    if(end - begin == 1)
      result.push_back(begin->second);
  }, is_parallel);
  return result;
}

// The vertices of the facets of a cell, each opposite to one vertex; they turn counterclockwise as seen from outside.
constexpr int facets_of_cell[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

// The facets that belong to one cell only; where the cells are positive, their normals point outwards.
template <typename Vertex>
std::vector<std::array<Vertex, 3> > boundary_facets_3(const std::vector<std::array<Vertex, 4> >& cells,
                                                      const bool is_parallel = false)
{
  std::vector<std::array<Vertex, 3> > facets;
  facets.reserve(4 * cells.size());
  for(const std::array<Vertex, 4>& cell : cells)
    for(const auto& i : facets_of_cell)
      facets.push_back({ cell[i[0]], cell[i[1]], cell[i[2]] });
  return faces_of_one_cell(facets, is_parallel);
}

// The vertices at an edge that has not two facets, and those whose corners of facets are not all joined by such edges.
inline std::vector<std::size_t> non_manifold_vertices(const std::size_t number_of_vertices,
                                                      const std::vector<std::array<std::size_t, 3> >& facets)
{
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<bool> is_bad(number_of_vertices, false);
  Disjoint_sets corners(3 * facets.size());
  for_each_edge(facets, [&](const auto begin, const auto end)
  {
    for(std::size_t i = 0; i < 2; ++i)
      if(end - begin == 2)
        corners.unite(begin->second[i], (begin + 1)->second[i]);
      else
        is_bad[begin->first[i]] = true;
  });

  std::vector<std::size_t> umbrella(number_of_vertices, none);
  for(std::size_t corner = 0; corner < 3 * facets.size(); ++corner)
  {
    const std::size_t v = facets[corner / 3][corner % 3], set = corners.find(corner);
    is_bad[v] = is_bad[v] || (umbrella[v] != none && umbrella[v] != set);
    umbrella[v] = set;
  }
  std::vector<std::size_t> result;
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    if(is_bad[v])
      result.push_back(v);
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_BOUNDARY_FACETS_3_H
