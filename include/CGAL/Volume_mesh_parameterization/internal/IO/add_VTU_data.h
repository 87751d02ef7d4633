// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_ADD_VTU_DATA_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_ADD_VTU_DATA_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/VTU_writer.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Appends a cell at each simplex of a lower dimension; the number of cells where there is none.
template <std::size_t N>
void append_cells_at(const Tetrahedron_soup_3& soup, const std::vector<std::array<std::size_t, N> >& simplices,
                     std::vector<std::size_t>& result)
{
  std::vector<std::vector<std::size_t> > incident(simplices.empty() ? 0 : soup.points.size()); // by their first vertex
  for(std::size_t s = 0; s < simplices.size(); ++s)
    incident[simplices[s][0]].push_back(s);
  const std::size_t first = result.size();
  result.resize(first + simplices.size(), soup.cells.size());
  for(std::size_t c = 0; c < soup.cells.size() && !simplices.empty(); ++c)
    for(const std::size_t v : soup.cells[c])
      for(const std::size_t s : incident[v])
        if(std::all_of(simplices[s].begin(), simplices[s].end(), [&](const std::size_t w)
           { return std::find(soup.cells[c].begin(), soup.cells[c].end(), w) != soup.cells[c].end(); }))
          result[first + s] = c;
}

// A cell at each cell of a VTU file: tetrahedra come first, then triangles, then lines.
inline std::vector<std::size_t> cells_of_VTU(const Tetrahedron_soup_3& soup)
{
  std::vector<std::size_t> result(soup.cells.size());
  std::iota(result.begin(), result.end(), std::size_t(0));
  append_cells_at(soup, soup.facets, result);
  append_cells_at(soup, soup.edges, result);
  return result;
}

// The data of cells, facets and edges, one array for each name. Where one of them has no such data, they are not numbers, or
// 0 for integers.
inline std::vector<Data_array_3> joined_cell_data(const Tetrahedron_soup_3& soup)
{
  const std::pair<const std::vector<Data_array_3>*, std::size_t> kinds[]
    = { { &soup.cell_data, soup.cells.size() }, { &soup.facet_data, soup.facets.size() }, { &soup.edge_data, soup.edges.size() } };
  std::vector<Data_array_3> result;
  std::set<std::string> names;
  for(const auto& [arrays, number] : kinds)
    for(const Data_array_3& array : *arrays)
    {
      if(!names.insert(array.name).second)
        continue;
      result.push_back({ array.name, array.number_of_components, array.has_integers, {} });
      std::vector<double>& values = result.back().values;
      for(const auto& [others, number_of_elements] : kinds)
      {
        const auto same = std::find_if(others->begin(), others->end(), [&](const Data_array_3& other)
        { return other.name == array.name && other.number_of_components == array.number_of_components; });
        if(same != others->end())
          values.insert(values.end(), same->values.begin(), same->values.end());
        else
          values.insert(values.end(), number_of_elements * array.number_of_components,
                        array.has_integers ? 0 : std::numeric_limits<double>::quiet_NaN());
      }
    }
  return result;
}

// Adds arrays to a section, but for those with the names of others in it.
inline void add_VTU_data(VTU_writer& writer, const std::vector<Data_array_3>& arrays, const std::set<std::string>& other_names)
{
  for(const Data_array_3& array : arrays)
  {
    const auto value = [&](const std::size_t i) { return array.values[i]; };
    if(other_names.count(array.name) != 0)
      continue;
    if(array.has_integers)
      writer.add<std::int64_t>(array.name, array.values.size(), value, array.number_of_components);
    else
      writer.add<double>(array.name, array.values.size(), value, array.number_of_components);
  }
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_ADD_VTU_DATA_H
