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
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the number of corners of a hexahedron, prism or pyramid of any order by its type of VTK; 0 for other cells.
inline std::size_t number_of_polyhedron_corners(const std::int64_t type)
{
  switch(type)
  {
    case 11: case 12: case 25: case 29: case 72: return 8;
    case 13: case 26: case 73: return 6;
    case 14: case 27: case 74: return 5;
    default: return 0;
  }
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
      case 9: case 23: case 28: case 70: // a quadrilateral, which is a facet of a polyhedron
        m_quadrilaterals.push_back({ c, corners(c, vertices, number_of_vertices, 4) }); break;
      default:
        constexpr std::int64_t last_of_surfaces = 9;
        if(const std::size_t n = number_of_polyhedron_corners(type); n > 0)
          add_polyhedron(c, type, vertices, number_of_vertices, n);
        else if(type < 1 || type > last_of_surfaces)
          throw Input_error(sentence_on_other_cells((type == 42 ? "polyhedra" : "cells of VTK's type " + std::to_string(type))
                                                    + ", such as cell " + std::to_string(c) + " (counted from 0)",
                                                    "ParaView's filter Tetrahedralize cuts cells into tetrahedra"));
    }
  }

  // Splits quadrilaterals of polyhedra, and removes mid-edge nodes.
  void finish()
  {
    if(m_number_of_polyhedra > 0)
    {
      for(const auto& [c, vertices] : m_quadrilaterals)
        for_each_triangle(vertices, [&, c = c](const std::array<std::size_t, 3>& facet)
                          { append(c, facet, m_soup.facets, m_soup.facet_references, m_soup.facet_data); });
      m_soup.notes.push_back(note_of_split_cells(m_number_of_polyhedra));
    }
    require_tetrahedra(m_soup.cells.size(), m_soup.facets.size(), "meshio convert");
    if(m_has_higher_order)
      remove_nodes_of_higher_order(m_soup);
    name_sets();
  }

private:
  // Returns the first vertices of cell c, which are its corners.
  template <typename Iterator>
  std::vector<std::size_t> corners(const std::size_t c, const Iterator vertices, const std::size_t number_of_vertices,
                                   const std::size_t number_of_corners)
  {
    if(number_of_vertices < number_of_corners)
      throw Input_error("cell " + std::to_string(c) + " (counted from 0) has only "
                        + counted(number_of_vertices, "vertex", "vertices"));
    m_has_higher_order = m_has_higher_order || number_of_vertices > number_of_corners;
    std::vector<std::size_t> result;
    for(std::size_t i = 0; i < number_of_corners; ++i)
      result.push_back(checked_vertex(vertices[i], 0, m_soup.points.size()));
    return result;
  }

  template <std::size_t N, typename Iterator>
  void add(const std::size_t c, const Iterator vertices, const std::size_t number_of_vertices,
           std::vector<std::array<std::size_t, N> >& simplices, std::vector<int>& references, std::vector<Data_array_3>& copies)
  {
    const std::vector<std::size_t> corners_of_cell = corners(c, vertices, number_of_vertices, N);
    std::array<std::size_t, N> simplex;
    std::copy(corners_of_cell.begin(), corners_of_cell.end(), simplex.begin());
    append(c, simplex, simplices, references, copies);
  }

  template <typename Iterator>
  void add_polyhedron(const std::size_t c, const std::int64_t type, const Iterator vertices, const std::size_t number_of_vertices,
                      const std::size_t number_of_corners)
  {
    std::vector<std::size_t> polyhedron = corners(c, vertices, number_of_vertices, number_of_corners);
    if(type == 11) // a voxel, with the vertices in rows
    {
      std::swap(polyhedron[2], polyhedron[3]);
      std::swap(polyhedron[6], polyhedron[7]);
    }
    if(number_of_corners == 6) // a prism, whose base is seen from outside
    {
      std::swap(polyhedron[1], polyhedron[2]);
      std::swap(polyhedron[4], polyhedron[5]);
    }
    for_each_tetrahedron(polyhedron, [&](const std::array<std::size_t, 4>& cell)
                         { append(c, cell, m_soup.cells, m_soup.cell_references, m_soup.cell_data); });
    ++m_number_of_polyhedra;
  }

  // Appends a simplex with the reference and the data of cell c.
  template <std::size_t N>
  void append(const std::size_t c, const std::array<std::size_t, N>& simplex, std::vector<std::array<std::size_t, N> >& simplices,
              std::vector<int>& references, std::vector<Data_array_3>& copies) const
  {
    simplices.push_back(simplex);
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
  std::vector<std::pair<std::size_t, std::vector<std::size_t> > > m_quadrilaterals; // cells of the file, and their corners
  std::size_t m_number_of_polyhedra = 0;
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
