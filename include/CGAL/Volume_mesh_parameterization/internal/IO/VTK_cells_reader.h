// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTK_CELLS_READER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTK_CELLS_READER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/Binary_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/VTK_references.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/require_tetrahedra.h>

#include <algorithm>
#include <map>

namespace CGAL::Volume_mesh_parameterization::internal {

// The name of cells of a type of VTK, in the plural.
inline std::string name_of_VTK_cells(const std::int64_t type)
{
  static const std::map<std::int64_t, const char*> names = {
    { 11, "voxels" }, { 12, "hexahedra" }, { 13, "prisms" }, { 14, "pyramids" }, { 25, "quadratic hexahedra" },
    { 26, "quadratic prisms" }, { 27, "quadratic pyramids" }, { 29, "quadratic hexahedra" }, { 42, "polyhedra" },
    { 72, "hexahedra of higher order" }, { 73, "prisms of higher order" }, { 74, "pyramids of higher order" } };
  const auto name = names.find(type);
  return name == names.end() ? "cells of VTK's type " + std::to_string(type) : name->second;
}

// Adds cells of an unstructured grid of VTK to a soup that has its points, with their data. References are among these.
class VTK_cells_reader
{
public:
  VTK_cells_reader(Tetrahedron_soup_3& soup, std::vector<Data_array_3> data)
    : m_soup(soup), m_data(std::move(data)), m_references(references_among(m_data))
  {
    m_data.erase(std::remove_if(m_data.begin(), m_data.end(), [](const auto& array) { return array.name == "reference"; }),
                 m_data.end());
    for(std::vector<Data_array_3>* const copies : { &soup.cell_data, &soup.facet_data, &soup.edge_data })
      for(const Data_array_3& array : m_data)
        copies->push_back({ array.name, array.number_of_components, array.has_integers, {} });
  }

  // Adds cell c of the file, with these vertices, as what its type of VTK says.
  template <typename Iterator>
  void add(const std::size_t c, const std::int64_t type, const Iterator vertices, const std::size_t number_of_vertices)
  {
    switch(type)
    {
      case 3: case 21: case 68: // a line; quadratic, or of any order
        add(c, vertices, number_of_vertices, m_soup.edges, m_soup.edge_references, m_soup.edge_data); break;
      case 5: case 22: case 69:
        add(c, vertices, number_of_vertices, m_soup.facets, m_soup.facet_references, m_soup.facet_data); break;
      case 10: case 24: case 71:
        add(c, vertices, number_of_vertices, m_soup.cells, m_soup.cell_references, m_soup.cell_data); break;
      default:
        constexpr std::int64_t last_of_surfaces = 9;
        if(type < 1 || type > last_of_surfaces)
          throw Input_error(sentence_on_other_cells(name_of_VTK_cells(type) + ", such as cell " + std::to_string(c)
                                                    + " (counted from 0)",
                                                    "ParaView's filter Tetrahedralize cuts cells into tetrahedra"));
    }
  }

  // Removes mid-edge nodes.
  void finish()
  {
    require_tetrahedra(m_soup.cells.size(), m_soup.facets.size(), "meshio convert");
    if(m_has_higher_order)
      remove_nodes_of_higher_order(m_soup);
    name_sets();
  }

private:
  template <std::size_t N, typename Iterator>
  void add(const std::size_t c, const Iterator vertices, const std::size_t number_of_vertices,
           std::vector<std::array<std::size_t, N> >& simplices, std::vector<int>& references, std::vector<Data_array_3>& copies)
  {
    if(number_of_vertices < N)
      throw Input_error("cell " + std::to_string(c) + " (counted from 0) has only "
                        + counted(number_of_vertices, "vertex", "vertices"));
    m_has_higher_order = m_has_higher_order || number_of_vertices > N;
    simplices.emplace_back();
    for(std::size_t i = 0; i < N; ++i)
      simplices.back()[i] = checked_vertex(vertices[i], 0, m_soup.points.size());
    references.push_back(m_references.values.empty() ? 0 : checked_reference(static_cast<std::int64_t>(m_references.values[c])));
    for(std::size_t a = 0; a < m_data.size(); ++a)
      for(std::size_t i = 0, n = m_data[a].number_of_components; i < n; ++i)
        copies[a].values.push_back(m_data[a].values[c * n + i]);
  }

  // Makes sets groups of the simplices that are in them.
  void name_sets()
  {
    for(std::size_t i = 0; i < m_references.sets.size(); ++i)
    {
      bool is_empty = true;
      const auto name_in = [&](const int dimension, const std::vector<int>& references)
      {
        if(std::count(references.begin(), references.end(), static_cast<int>(i + 1)) == 0)
          return;
        m_soup.group_names[{ dimension, static_cast<int>(i + 1) }] = m_references.sets[i];
        is_empty = false;
      };
      name_in(3, m_soup.cell_references);
      name_in(2, m_soup.facet_references);
      name_in(1, m_soup.edge_references);
      if(is_empty)
        m_soup.notes.push_back("the set '" + m_references.sets[i] + "' has no cell in the file, because meshio keeps only the "
                               "last set of a cell. Remove larger sets before the conversion");
    }
  }

  Tetrahedron_soup_3& m_soup;
  std::vector<Data_array_3> m_data;
  VTK_references m_references;
  bool m_has_higher_order = false;
};

// Adds all cells: cell c has the vertices from `ends[c - 1]` to `ends[c]` in `connectivity`.
inline void add_VTK_cells(Tetrahedron_soup_3& soup, const std::vector<std::int64_t>& connectivity,
                          const std::vector<std::int64_t>& ends, const std::vector<std::int64_t>& types,
                          std::vector<Data_array_3> data)
{
  if(ends.size() != types.size())
    throw Input_error("the arrays of the cells are not equally long");
  VTK_cells_reader reader(soup, std::move(data));
  std::int64_t begin = 0;
  for(std::size_t c = 0; c < types.size(); begin = ends[c++])
  {
    if(ends[c] < begin || static_cast<std::uint64_t>(ends[c]) > connectivity.size())
      throw Input_error("the offset " + std::to_string(ends[c]) + " of cell " + std::to_string(c)
                        + " (counted from 0) is wrong");
    reader.add(c, types[c], connectivity.begin() + begin, static_cast<std::size_t>(ends[c] - begin));
  }
  reader.finish();
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_VTK_CELLS_READER_H
