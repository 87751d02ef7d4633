// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_COMPRESSED_ROWS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_COMPRESSED_ROWS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Dynamic_matrix.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#include <CGAL/assertions.h>

#include <array>

namespace CGAL::Volume_mesh_parameterization::internal {

// Which items are in each row, in ascending order; `for_each_row_of(item, f)` calls f for the rows of an item. Threads share
// the items, which they put into buckets of neighboring rows, and then the buckets.
template <typename Item>
struct Compressed_rows
{
  std::vector<std::size_t> begin; // of each row; while items are filled in, one place further
  Dynamic_matrix<Item, Eigen::Dynamic> items; // first written by the threads, which so share the clearing of its pages

  template <typename For_each_row_of>
  Compressed_rows(const std::size_t number_of_rows, const std::size_t number_of_items,
                  const For_each_row_of& for_each_row_of, const bool is_parallel = false)
    : begin(number_of_rows + 2, 0)
  {
    constexpr int rows_per_bucket = 2048, items_per_part = 1 << 16; // guesses; a bucket fits into a cache
    using Bucket = std::vector<std::pair<int, Item> >; // items with their rows
    std::vector<std::vector<Bucket> > parts((number_of_items + items_per_part - 1) / items_per_part);
    for_each_range(is_parallel, number_of_items, items_per_part,
                   [&](const std::size_t part, const std::size_t first, const std::size_t last)
    {
      std::vector<Bucket>& buckets = parts[part];
      buckets.resize(number_of_rows / rows_per_bucket + 1);
      for(std::size_t i = first; i < last; ++i)
        for_each_row_of(static_cast<Item>(i), [&](const std::size_t row)
        { buckets[row / rows_per_bucket].emplace_back(static_cast<int>(row), static_cast<Item>(i)); });
    });
    const auto for_each_row_and_item = [&](const auto& f)
    {
      for_each_index(is_parallel, 0, number_of_rows / rows_per_bucket + 1, [&](const std::size_t bucket)
      {
        for(const std::vector<Bucket>& buckets : parts)
          for(const auto& [row, item] : buckets[bucket])
            f(row, item);
      });
    };
    for_each_row_and_item([&](const int row, Item) { ++begin[row + 2]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    items.resize(begin.back());
    for_each_row_and_item([&](const int row, const Item item) { items[begin[row + 1]++] = item; });
    CGAL_assertion(begin[number_of_rows] == begin.back()); // both passes have found the same items in each row
  }

  // Puts each item into one row.
  Compressed_rows(const std::size_t number_of_rows, const std::vector<int>& rows_of, const bool is_parallel)
    : Compressed_rows(number_of_rows, rows_of.size(), [&](const std::size_t i, const auto& f) { f(rows_of[i]); }, is_parallel) {}
};

// The order of pairs in a row, where the first vertices are the same: a type of its own, as a compiler takes long for each sort.
struct Order_in_row
{
  template <typename Pair>
  bool operator()(const Pair& p, const Pair& q) const
  {
    for(std::size_t i = 1; i < p.first.size(); ++i)
      if(p.first[i] != q.first[i])
        return p.first[i] < q.first[i];
    return p.second < q.second;
  }
};

// Sorts the n pairs `pair_of(i)`, and calls `f(begin, end)` for all that have the same first element, an array of vertices:
// one group after the other in ascending order, or in parallel if asked for. They are put into compressed rows by their
// first vertex, which takes linear time, and the short rows are sorted.
template <typename PairOf, typename Function>
void for_each_group(const std::size_t n, const PairOf& pair_of, const Function& f, const bool is_parallel = false)
{
  using Pair = std::decay_t<decltype(pair_of(0))>;
  constexpr int rows_per_range = 1024; // a guess
  const std::vector<int> rows_of
    = values_of_indices(is_parallel, n, [&](const std::size_t i) { return static_cast<int>(pair_of(i).first[0]); });
  const int number_of_rows = n == 0 ? 0 : *std::max_element(rows_of.begin(), rows_of.end()) + 1;
  const Compressed_rows<std::size_t> rows(number_of_rows, rows_of, is_parallel);
  for_each_range(is_parallel, number_of_rows, rows_per_range, [&](std::size_t, const int first, const int last)
  {
    std::vector<Pair> pairs;
    for(int row = first; row < last; ++row)
    {
      pairs.clear();
      for(std::size_t k = rows.begin[row]; k < rows.begin[row + 1]; ++k)
        pairs.push_back(pair_of(rows.items[k]));
      std::sort(pairs.begin(), pairs.end(), Order_in_row());
      for(auto begin = pairs.begin(), end = begin; begin != pairs.end(); begin = end)
      {
        end = std::find_if(begin, pairs.end(), [&](const Pair& pair) { return pair.first != begin->first; });
        f(begin, end);
      }
    }
  });
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_COMPRESSED_ROWS_H
