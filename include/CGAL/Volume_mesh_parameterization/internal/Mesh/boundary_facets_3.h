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

#include <CGAL/Volume_mesh_parameterization/internal/parallel.h>

#include <CGAL/Union_find.h>

#include <array>
#include <limits>

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

// Which items are in each row, in ascending order; `for_each_row_of(item, f)` calls f for the rows of an item.
template <typename Item>
struct Compressed_rows
{
  std::vector<std::size_t> begin; // of each row; while items are filled in, one place further
  std::vector<Item> items;

  template <typename For_each_row_of>
  Compressed_rows(const std::size_t number_of_rows, const std::size_t number_of_items,
                  const For_each_row_of& for_each_row_of)
    : begin(number_of_rows + 2, 0)
  {
    for(std::size_t i = 0; i < number_of_items; ++i)
      for_each_row_of(static_cast<Item>(i), [&](const int row) { ++begin[row + 2]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    items.resize(begin.back());
    for(std::size_t i = 0; i < number_of_items; ++i)
      for_each_row_of(static_cast<Item>(i), [&](const int row) { items[begin[row + 1]++] = static_cast<Item>(i); });
  }
};

// Sorts the n pairs `pair_of(i)`, and calls `f(begin, end)` for all that have the same first element, an array of vertices.
// They are put into compressed rows by their first vertex, which takes linear time, and the short rows are sorted, in
// parallel if asked for.
template <typename PairOf, typename Function>
void for_each_group(const std::size_t n, const PairOf& pair_of, const Function& f, const bool is_parallel = false)
{
  using Pair = std::decay_t<decltype(pair_of(0))>;
  constexpr int rows_per_range = 1024;
  const auto row_of = [](const Pair& pair) { return static_cast<std::size_t>(pair.first[0]); };
  std::vector<std::size_t> row_begin(2, 0); // while it is filled, one place further
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t row = row_of(pair_of(i));
    if(row_begin.size() < row + 3)
      row_begin.resize(row + 3, 0);
    ++row_begin[row + 2];
  }
  std::partial_sum(row_begin.begin(), row_begin.end(), row_begin.begin());
  std::vector<Pair> pairs(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    const Pair pair = pair_of(i);
    pairs[row_begin[row_of(pair) + 1]++] = pair;
  }
  for_each_in_ranges(is_parallel, row_begin.size() - 2, rows_per_range, [&](const std::size_t row)
  { std::sort(pairs.begin() + row_begin[row], pairs.begin() + row_begin[row + 1]); });
  for(auto begin = pairs.begin(), end = begin; begin != pairs.end(); begin = end)
  {
    end = std::find_if(begin, pairs.end(), [&](const Pair& pair) { return pair.first != begin->first; });
    f(begin, end);
  }
}

// An array of vertices in ascending order.
template <typename Simplex>
Simplex sorted(Simplex simplex)
{
  std::sort(simplex.begin(), simplex.end());
  return simplex;
}

// Calls `f(begin, end)` for each edge, with a pair for each of its facets: its vertices, the smaller first, and the corners
// there, where corner k of facet i is 3 i + k.
template <typename Vertex, typename Function>
void for_each_edge(const std::vector<std::array<Vertex, 3> >& facets, const Function& f)
{
  for_each_group(3 * facets.size(), [&](const std::size_t corner)
  {
    const std::array<Vertex, 3>& facet = facets[corner / 3];
    const std::size_t k = corner % 3, l = (k + 1) % 3;
    const std::size_t next = corner - k + l;
    return facet[k] < facet[l] ? std::make_pair(std::array<Vertex, 2>{ facet[k], facet[l] }, std::array<std::size_t, 2>{ corner, next })
                               : std::make_pair(std::array<Vertex, 2>{ facet[l], facet[k] }, std::array<std::size_t, 2>{ next, corner });
  }, f);
}

// The vertices of the facets of a cell, each opposite to one vertex; they turn counterclockwise as seen from outside.
constexpr int facets_of_cell[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

// The facets that belong to one cell only; where the cells are positive, their normals point outwards.
template <typename Vertex>
std::vector<std::array<Vertex, 3> > boundary_facets_3(const std::vector<std::array<Vertex, 4> >& cells,
                                                      const bool is_parallel = false)
{
  using Facet = std::array<Vertex, 3>;
  std::vector<Facet> result;
  for_each_group(4 * cells.size(), [&](const std::size_t side)
  {
    const auto& [i, j, k] = facets_of_cell[side % 4];
    const std::array<Vertex, 4>& cell = cells[side / 4];
    const Facet facet = { cell[i], cell[j], cell[k] };
    return std::make_pair(sorted(facet), facet);
  },
  [&](const auto begin, const auto end)
  {
    if(end - begin == 1)
      result.push_back(begin->second);
  }, is_parallel);
  return result;
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
