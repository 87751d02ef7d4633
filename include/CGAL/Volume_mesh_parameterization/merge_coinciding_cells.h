// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MERGE_COINCIDING_CELLS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MERGE_COINCIDING_CELLS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/check_tetrahedron_soup.h>

#include <set>

namespace CGAL::Volume_mesh_parameterization {

namespace internal {

// The cell data with the reference number `i` of cells in several groups.
inline std::string name_of_reference(const std::size_t i) { return "reference_" + std::to_string(i); }

} // namespace internal

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// finds cells with the same vertices, as those that a file repeats in each of its groups, in O(n log n) time for n cells.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, if TBB is linked, `Parallel_tag` or `Parallel_if_available_tag`
///
/// \return for each cell, the first one with its four vertices
template <typename ConcurrencyTag = Sequential_tag>
std::vector<std::size_t> first_coinciding_cells(const std::vector<std::array<std::size_t, 4> >& cells)
{
  std::vector<std::size_t> result(cells.size());
  internal::for_each_group(cells.size(),
                           [&](const std::size_t c) { return std::make_pair(internal::sorted(cells[c]), c); },
                           [&](const auto begin, const auto end)
  {
    for(auto it = begin; it != end; ++it)
      result[it->second] = begin->second;
  }, internal::is_parallel<ConcurrencyTag>());
  return result;
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// removes each cell with the vertices of an earlier one, and adds a note to the soup. If the references of such cells differ, the
/// further ones become the cell data `reference_2`, `reference_3`, ... of the cell that stays, with 0 for none.
///
/// \return that of `first_coinciding_cells()` for the cells before
///
/// \exception Input_error as the functions for arrays; the soup is then unchanged.
template <typename ConcurrencyTag = Sequential_tag>
std::vector<std::size_t> merge_coinciding_cells(Tetrahedron_soup_3& soup)
{
  internal::check_simplices(soup);
  const std::vector<std::size_t> first = first_coinciding_cells<ConcurrencyTag>(soup.cells);
  const std::size_t n = soup.cells.size();
  std::vector<std::set<int> > references(n);
  std::vector<std::size_t> kept, repeated;
  std::size_t number_of_references = 1;
  for(std::size_t c = 0; c < n; ++c)
  {
    (first[c] == c ? kept : repeated).push_back(c);
    if(soup.cell_references[c] != soup.cell_references[first[c]])
      references[first[c]].insert(soup.cell_references[c]);
    number_of_references = (std::max)(number_of_references, 1 + references[first[c]].size());
  }
  if(repeated.empty())
    return first;
  for(std::size_t i = 2; i <= number_of_references; ++i)
  {
    soup.cell_data.push_back({ internal::name_of_reference(i), 1, true, std::vector<double>(n, 0) });
    for(std::size_t c = 0; c < n; ++c)
      if(references[c].size() + 1 >= i)
        soup.cell_data.back().values[c] = *std::next(references[c].begin(), static_cast<std::ptrdiff_t>(i - 2));
  }
  const auto keep = [&](auto& values, const std::size_t number_of_components)
  {
    for(std::size_t k = 0; k < kept.size(); ++k)
      for(std::size_t i = 0; i < number_of_components; ++i)
        values[k * number_of_components + i] = values[kept[k] * number_of_components + i];
    values.resize(kept.size() * number_of_components);
  };
  keep(soup.cells, 1);
  keep(soup.cell_references, 1);
  for(auto& array : soup.cell_data)
    keep(array.values, array.number_of_components);
  soup.notes.push_back(std::to_string(repeated.size()) + " cells have the vertices of an earlier cell, such as cell "
    + std::to_string(repeated[0]) + " those of cell " + std::to_string(first[repeated[0]]) + " (counted from 0), and are left out"
    + (number_of_references == 1 ? "" : "; their references are the cell data '" + internal::name_of_reference(2)
        + (number_of_references == 2 ? "'" : "' to '" + internal::name_of_reference(number_of_references) + "'")
        + ", which files *.vtu and *.msh hold"));
  return first;
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MERGE_COINCIDING_CELLS_H
