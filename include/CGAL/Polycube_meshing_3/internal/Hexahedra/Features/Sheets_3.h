// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_SHEETS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_SHEETS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/scaled_jacobians.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>

namespace CGAL::Polycube_meshing_3::internal {

// Sheets of hexahedra: those along edges that are opposite to each other in quadrangles. Some sheets can be cut in two.
class Sheets_3
{
public:
  explicit Sheets_3(const Hexahedra_3& mesh) : m_mesh(mesh)
  {
    const auto for_each_edge_of_cell = [&](const auto& f)
    {
      for(const std::array<std::size_t, 8>& cell : mesh.cells)
        for(const std::array<std::size_t, 4>& corner : corners_of_hexahedron)
          for(std::size_t i = 1; i < 4; ++i)
            f(cell, sorted(Edge{ cell[corner[0]], cell[corner[i]] }), axis_of_edge(corner[0], corner[i]));
    };
    for_each_edge_of_cell([&](const auto&, const Edge& e, int) { m_sheets.emplace(e, m_sheets.size()); });
    Disjoint_sets sets(m_sheets.size());
    for_each_edge_of_cell([&](const auto& cell, const Edge& e, const int axis)
                          { sets.unite(m_sheets.at(e), m_sheets.at(first_edge(cell, axis))); });
    for(auto& [e, number] : m_sheets)
      number = sets.find(number);
    for(const std::array<std::size_t, 8>& cell : mesh.cells)
      for(std::size_t axis = 0; axis < 3; ++axis)
        ++m_sizes[m_sheets.at(first_edge(cell, axis))];
  }

  std::size_t sheet(const std::array<std::size_t, 2>& e) const { return m_sheets.at(sorted(e)); } // across an edge
  std::size_t size(const std::size_t sheet) const { return m_sizes.at(sheet); } // number of hexahedra that a cut adds

  // Adds a sheet to others, unless it is among them or larger than the number left of hexahedra that cuts may add. Lowers this
  // number. Returns whether the sheet is added.
  bool take(const std::size_t sheet, std::set<std::size_t>& sheets, std::size_t& number_left) const
  {
    if(size(sheet) > number_left || !sheets.insert(sheet).second)
      return false;
    number_left -= size(sheet);
    return true;
  }

  // Returns the hexahedra with these sheets cut in two.
  Hexahedra_3 cut(const std::set<std::size_t>& sheets) const
  {
    Hexahedra_3 result;
    result.points = m_mesh.points;
    std::vector<std::vector<std::size_t> > facets(m_mesh.cells.size());
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
      facets[m_mesh.facet_cells[f]].push_back(f);
    std::map<std::vector<std::size_t>, std::size_t> middles; // new vertices, by the sorted old ones around them
    for(std::size_t c = 0; c < m_mesh.cells.size(); ++c)
    {
      std::array<std::size_t, 3> numbers; // of parts along each axis
      for(std::size_t axis = 0; axis < 3; ++axis)
        numbers[axis] = 1 + sheets.count(m_sheets.at(first_edge(m_mesh.cells[c], axis)));
      for(std::size_t part = 0; part < numbers[0] * numbers[1] * numbers[2]; ++part)
      {
        const std::array<std::size_t, 3> at // position of the part along each axis
          = { part % numbers[0], part / numbers[0] % numbers[1], part / (numbers[0] * numbers[1]) };
        std::array<std::size_t, 8> cell;
        for(std::size_t k = 0; k < 8; ++k)
          cell[k] = vertex(c, k, numbers, at, middles, result);
        const auto& [i, j, k] = m_mesh.cell_indices[c];
        add_cell(cell, m_mesh.cell_blocks[c], { 2 * i + at[0], 2 * j + at[1], 2 * k + at[2] }, m_mesh.cell_references[c], result);
        for(const std::size_t f : facets[c])
        {
          const std::size_t side = side_of_facet(m_mesh, f), axis = axis_across(side);
          if(at[axis] == (is_upper(quadrangles_of_hexahedron[side][0], axis) ? numbers[axis] - 1 : 0))
            add_facet({ result.cells.size() - 1, side }, m_mesh.polycube_faces[f], result);
        }
      }
    }
    number_indices(result);
    return result;
  }

private:
  using Edge = std::array<std::size_t, 2>;

  // Returns the edge of a hexahedron from its first vertex along an axis.
  static Edge first_edge(const std::array<std::size_t, 8>& cell, const std::size_t axis)
  { return sorted(Edge{ cell[0], cell[corners_of_hexahedron[0][1 + axis]] }); }

  // Returns the axis that the quadrangle on a side is orthogonal to.
  static std::size_t axis_across(const std::size_t side)
  { return 3 - axes_of_quadrangle[side][0] - axes_of_quadrangle[side][1]; }

  // Returns vertex k of a part of hexahedron c: an old one, or the middle of an edge, a quadrangle or the hexahedron. Adds the
  // point of a new middle. Takes the number of parts and the position of the part along each axis.
  std::size_t vertex(const std::size_t c, const std::size_t k, const std::array<std::size_t, 3>& numbers,
                     const std::array<std::size_t, 3>& at, std::map<std::vector<std::size_t>, std::size_t>& middles,
                     Hexahedra_3& result) const
  {
    std::vector<std::size_t> around;
    for(std::size_t l = 0; l < 8; ++l)
    {
      bool is_near = true;
      for(std::size_t axis = 0; axis < 3; ++axis)
        is_near = is_near && (is_upper(l, axis) == is_upper(k, axis)
                              || (numbers[axis] == 2 && is_upper(k, axis) == (at[axis] == 0)));
      if(is_near)
        around.push_back(m_mesh.cells[c][l]);
    }
    std::sort(around.begin(), around.end());
    if(around.size() == 1)
      return around[0];
    const auto [middle, is_new] = middles.emplace(around, result.points.size());
    if(is_new)
      result.points.push_back(mean_of(m_mesh.points, around));
    return middle->second;
  }

  // Numbers the indices of hexahedra along each axis of a block anew, from 0 without gaps.
  static void number_indices(Hexahedra_3& mesh)
  {
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      std::map<std::array<std::size_t, 2>, std::size_t> numbers; // by block and index
      for(std::size_t c = 0; c < mesh.cells.size(); ++c)
        numbers[{ mesh.cell_blocks[c], mesh.cell_indices[c][axis] }] = 0;
      for(auto it = numbers.begin(); it != numbers.end(); ++it)
        if(it != numbers.begin() && std::prev(it)->first[0] == it->first[0])
          it->second = std::prev(it)->second + 1;
      for(std::size_t c = 0; c < mesh.cells.size(); ++c)
        mesh.cell_indices[c][axis] = numbers.at({ mesh.cell_blocks[c], mesh.cell_indices[c][axis] });
    }
  }

  const Hexahedra_3& m_mesh;
  std::map<Edge, std::size_t> m_sheets; // of each edge
  std::map<std::size_t, std::size_t> m_sizes;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_SHEETS_3_H
