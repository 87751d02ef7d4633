// Cells that a file repeats, for example if each of its groups lists its cells.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MERGE_REPEATED_CELLS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MERGE_REPEATED_CELLS_H

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Finds for each cell the first one with its four vertices.
inline std::vector<std::size_t> first_equal_cells(const std::vector<std::array<std::size_t, 4> >& cells, const bool is_parallel)
{
  namespace internal = CGAL::Volume_mesh_parameterization::internal;
  std::vector<std::size_t> result(cells.size());
  internal::for_each_group(cells.size(), [&](const std::size_t c) { return std::make_pair(internal::sorted(cells[c]), c); },
                           [&](const auto begin, const auto end)
  {
    for(auto it = begin; it != end; ++it)
      result[it->second] = begin->second;
  }, is_parallel);
  return result;
}

// The cell data with the reference number `i` of cells in several groups.
inline std::string name_of_reference(const std::size_t i) { return "reference_" + std::to_string(i); }

// Lets only those cells stay that are the first ones of equal cells. References of the others become their cell data `reference_2`
// and so on, with 0 for none. Returns a sentence about cells that are left out.
inline std::string merge_repeated_cells(const std::vector<std::size_t>& first,
                                        CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3& soup)
{
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
  for(std::size_t i = 2; i <= number_of_references; ++i)
  {
    soup.cell_data.push_back({ name_of_reference(i), 1, true, std::vector<double>(n, 0) });
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
  return std::to_string(repeated.size()) + " cells have the vertices of an earlier cell, such as cell "
    + std::to_string(repeated[0]) + " those of cell " + std::to_string(first[repeated[0]]) + " (counted from 0), and are left out"
    + (number_of_references == 1 ? "" : "; their references are the cell data '" + name_of_reference(2)
        + (number_of_references == 2 ? "'" : "' to '" + name_of_reference(number_of_references) + "'")
        + ", which files *.vtu and *.msh hold");
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_MERGE_REPEATED_CELLS_H
