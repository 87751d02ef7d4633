// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_FACET_MATCHING_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_FACET_MATCHING_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

namespace CGAL::Volume_mesh_parameterization::internal {

template <std::size_t N>
void check_simplex(const std::array<std::size_t, N>& simplex, const std::size_t number_of_points, const char* kind,
                   const std::size_t index)
{
  for(auto it = simplex.begin(); it != simplex.end(); ++it)
  {
    if(*it >= number_of_points)
      throw Input_error(sentence(kind, index, " (counted from 0) has a vertex ", *it, " that does not exist"));
    if(std::find(simplex.begin(), it, *it) != it)
      throw Input_error(sentence(kind, index, " (counted from 0) has the vertex ", *it, " twice"));
  }
}

inline void check_cells(const std::vector<std::array<std::size_t, 4> >& cells, const std::size_t number_of_points)
{
  for(std::size_t c = 0; c < cells.size(); ++c)
    check_simplex(cells[c], number_of_points, "cell ", c);
}

// Do the vertices of a facet, as they turn around its cell, become sorted by an odd permutation? Where two cells meet, they turn
// the other way round.
inline bool is_odd_facet(const std::array<std::size_t, 3>& facet)
{
  const auto [u, v, w] = facet;
  return ((u > v) != (v > w)) != (u > w);
}

// Finds the two sides of each facet of cells of equal orientation.
// The number `4 * c + i` stands for the facet of cell `c` that is opposite to its vertex `i`.
class Facet_matching_3
{
public:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // `numbers` of the cells are for messages; without them, they are those of the array.
  explicit Facet_matching_3(const std::vector<std::array<std::size_t, 4> >& cells, const bool is_parallel = false,
                            const std::vector<std::array<std::size_t, 3> >& marked_facets = {},
                            std::vector<std::size_t> numbers = {})
    : m_cells(cells), m_numbers(std::move(numbers)), m_mirrors(4 * cells.size()), m_marked_facets(marked_facets.size(), none)
  {
    try
    {
      match_facets(marked_facets, is_parallel);
    }
    catch(const Input_error&)
    {
      match_facets(marked_facets, false); // which throws the first of several mistakes, whatever threads have found
    }
  }

  // The facet seen from the other cell, or `none` on the boundary.
  std::size_t mirror(std::size_t facet) const { return m_mirrors[facet]; }

  // The facets of one cell only.
  std::vector<std::size_t> sides_on_boundary() const
  {
    std::vector<std::size_t> result;
    for(std::size_t facet = 0; facet < 4 * m_cells.size(); ++facet)
      if(m_mirrors[facet] == none)
        result.push_back(facet);
    return result;
  }

  // The facet of a cell that is marked first by each of the marked facets, or `none`.
  const std::vector<std::size_t>& marks() const { return m_marked_facets; }

private:
  // The vertices of a facet of a cell, or of the marked facet `number - 4 * number_of_cells`, and its number.
  using Side = std::pair<std::array<std::size_t, 3>, std::size_t>;

  void match_facets(const std::vector<std::array<std::size_t, 3> >& marked_facets, const bool is_parallel)
  {
    const std::size_t n = 4 * m_cells.size();
    for_each_group(n + m_marked_facets.size(), [&](const std::size_t side)
    {
      return Side(sorted(side < n ? facet_of_cell(m_cells[side / 4], side % 4) : marked_facets[side - n]), side);
    },
    [&](const auto begin, const auto end) { match_facet(begin, end); }, is_parallel);
  }

  // Matches the sides of one facet: those of cells come before the marks.
  template <typename Iterator>
  void match_facet(const Iterator begin, const Iterator end)
  {
    const std::size_t n = 4 * m_cells.size();
    const auto first_mark = std::find_if(begin, end, [&](const Side& side) { return side.second >= n; });
    const auto number_of_cells = first_mark - begin;
    if(number_of_cells == 0)
      return;
    const std::size_t facet = begin->second;
    if(number_of_cells > 2)
      throw Input_error("more than two cells share a facet, among them " + cell_name(facet) + ", "
                        + cell_name((begin + 1)->second) + " and " + cell_name((begin + 2)->second));
    m_mirrors[facet] = none;
    if(number_of_cells == 2)
      join(facet, (begin + 1)->second);
    if(first_mark != end)
      m_marked_facets[first_mark->second - n] = facet;
  }

  void join(std::size_t f, std::size_t g)
  {
    if(is_odd(f) == is_odd(g))
      throw Input_error(cell_name(f) + " and " + cell_name(g)
                        + " overlap, they lie on the same side of their common facet");
    m_mirrors[f] = g;
    m_mirrors[g] = f;
  }

  bool is_odd(const std::size_t facet) const { return is_odd_facet(facet_of_cell(m_cells[facet / 4], facet % 4)); }

  std::string cell_name(std::size_t facet) const
  { return "cell " + std::to_string(m_numbers.empty() ? facet / 4 : m_numbers[facet / 4]); }

  const std::vector<std::array<std::size_t, 4> >& m_cells;
  std::vector<std::size_t> m_numbers;
  Dynamic_matrix<std::size_t, Eigen::Dynamic> m_mirrors; // first written by threads, as the items of compressed rows
  std::vector<std::size_t> m_marked_facets;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_FACET_MATCHING_3_H
