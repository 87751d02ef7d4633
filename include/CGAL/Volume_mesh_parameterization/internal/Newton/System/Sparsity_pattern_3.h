// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_SPARSITY_PATTERN_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_SPARSITY_PATTERN_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Unknowns_3.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Which blocks the Hessian has, in compressed rows as in `Block_sparse_matrix_3`.
struct Sparsity_pattern_3
{
  std::vector<int> row_begin, columns;

  int position(const int row, const int column) const
  {
    const auto begin = columns.begin();
    return static_cast<int>(std::lower_bound(begin + row_begin[row], begin + row_begin[row + 1], column) - begin);
  }
};

// The pattern of the Hessian: the pairs of unknown vertices that share a cell, or one of the groups.
inline Sparsity_pattern_3 sparsity_pattern_3(const Numbered_mesh_3& mesh, const Unknowns_3& unknowns,
                                             const std::vector<std::vector<int> >& groups = {})
{
  const int n = unknowns.size();
  std::vector<int> row_begin(n + 1, 0);
  const auto for_each_pair_of = [&](const auto& vertices, const auto& f)
  {
    for(const int v : vertices)
      for(const int w : vertices)
        if(unknowns.contains(v) && unknowns.contains(w))
          f(unknowns.row(v), unknowns.row(w));
  };
  const auto for_each_pair = [&](const auto& f)
  {
    for(const std::array<int, 4>& cell : mesh.cells)
      for_each_pair_of(cell, f);
    for(const std::vector<int>& group : groups)
      for_each_pair_of(group, f);
  };

  for_each_pair([&](const int v, int) { ++row_begin[v + 1]; });
  for(int v = 0; v < n; ++v)
    row_begin[v + 1] += row_begin[v];
  std::vector<int> columns(row_begin[n]);
  std::vector<int> next(row_begin.begin(), row_begin.end() - 1);
  for_each_pair([&](const int v, const int w) { columns[next[v]++] = w; });

  // sort each row and remove what occurs more than once
  auto end = columns.begin();
  for(int v = 0; v < n; ++v)
  {
    const auto first = columns.begin() + row_begin[v];
    const auto last = columns.begin() + row_begin[v + 1];
    std::sort(first, last);
    row_begin[v] = static_cast<int>(end - columns.begin());
    end = std::move(first, std::unique(first, last), end);
  }
  row_begin[n] = static_cast<int>(end - columns.begin());
  columns.erase(end, columns.end());
  columns.shrink_to_fit();
  return { std::move(row_begin), std::move(columns) };
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_SPARSITY_PATTERN_3_H
