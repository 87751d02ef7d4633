// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_SPARSITY_PATTERN_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_SPARSITY_PATTERN_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Parallel/for_each_index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Which cells and groups are at each unknown vertex, in compressed rows; groups are numbered behind the cells.
class Incidences_of_rows_3
{
public:
  using Groups = std::vector<std::vector<int> >; // of vertices

  Incidences_of_rows_3(const Numbered_mesh_3& mesh, const Unknowns_3& unknowns, const Groups& groups)
    : m_mesh(mesh), m_unknowns(unknowns), m_groups(groups), m_begin(unknowns.size() + 1, 0)
  {
    for_each_incidence([&](const int row, int) { ++m_begin[row + 1]; });
    for(int row = 0; row < unknowns.size(); ++row)
      m_begin[row + 1] += m_begin[row];
    m_items.resize(m_begin.back());
    std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
    for_each_incidence([&](const int row, const int item) { m_items[next[row]++] = item; });
  }

  // Appends the rows that share a cell or a group with this one, itself included, in ascending order.
  void append_neighbors(const int row, std::vector<int>& columns) const
  {
    const std::size_t first = columns.size();
    for(std::size_t i = m_begin[row]; i < m_begin[row + 1]; ++i)
      for_each_row_of(m_items[i], [&](const int neighbor) { columns.push_back(neighbor); });
    std::sort(columns.begin() + first, columns.end());
    columns.erase(std::unique(columns.begin() + first, columns.end()), columns.end());
  }

private:
  template <typename Function>
  void for_each_row_of(const int item, const Function& f) const
  {
    const int number_of_cells = static_cast<int>(m_mesh.cells.size());
    const auto for_each = [&](const auto& vertices)
    {
      for(const int v : vertices)
        if(m_unknowns.contains(v))
          f(m_unknowns.row(v));
    };
    if(item < number_of_cells)
      for_each(m_mesh.cells[item]);
    else
      for_each(m_groups[item - number_of_cells]);
  }

  template <typename Function>
  void for_each_incidence(const Function& f) const
  {
    const int number_of_items = static_cast<int>(m_mesh.cells.size() + m_groups.size());
    for(int item = 0; item < number_of_items; ++item)
      for_each_row_of(item, [&](const int row) { f(row, item); });
  }

  const Numbered_mesh_3& m_mesh;
  const Unknowns_3& m_unknowns;
  const Groups& m_groups;
  std::vector<std::size_t> m_begin;
  std::vector<int> m_items;
};

// The pattern of the Hessian: the pairs of unknown vertices that share a cell, or one of the groups.
inline Sparsity_pattern_3 sparsity_pattern_3(const Numbered_mesh_3& mesh, const Unknowns_3& unknowns,
                                             const Incidences_of_rows_3::Groups& groups = {},
                                             const bool is_parallel = false)
{
  constexpr int rows_per_part = 4096;
  const int n = unknowns.size();
  const Incidences_of_rows_3 incidences(mesh, unknowns, groups);
  Sparsity_pattern_3 result;
  result.row_begin.assign(n + 1, 0);
  std::vector<std::vector<int> > parts((n + rows_per_part - 1) / rows_per_part);
  for_each_index(is_parallel, 0, parts.size(), [&](const std::size_t part)
  {
    const int first = static_cast<int>(part) * rows_per_part;
    for(int row = first; row < (std::min)(n, first + rows_per_part); ++row)
    {
      const std::size_t size = parts[part].size();
      incidences.append_neighbors(row, parts[part]);
      result.row_begin[row + 1] = static_cast<int>(parts[part].size() - size);
    }
  });
  for(int row = 0; row < n; ++row)
    result.row_begin[row + 1] += result.row_begin[row];
  result.columns.reserve(result.row_begin[n]);
  for(std::vector<int>& part : parts)
  {
    result.columns.insert(result.columns.end(), part.begin(), part.end());
    part = std::vector<int>();
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_SPARSITY_PATTERN_3_H
