// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_CHECK_TETRAHEDRON_SOUP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_CHECK_TETRAHEDRON_SOUP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <cmath>

namespace CGAL::Volume_mesh_parameterization::internal {

inline std::array<Exact_point_3, 4> cell_points(const Tetrahedron_soup_3& soup, std::size_t c)
{
  const auto point = [&](const std::size_t i) { return exact_point(soup.points[soup.cells[c][i]]); };
  return { point(0), point(1), point(2), point(3) };
}

inline void check_points(const Tetrahedron_soup_3& soup)
{
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    for(double x : soup.points[v])
      if(!std::isfinite(x))
        throw Input_error(sentence("vertex ", v, " (counted from 0) has a coordinate that is not finite"));
}

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

inline void check_data(const std::vector<Data_array_3>& arrays, const std::size_t number_of_elements)
{
  for(const Data_array_3& array : arrays)
    if(array.values.size() != number_of_elements * array.number_of_components)
      throw Input_error("the data '" + array.name + "' have not the size of the mesh");
}

inline void check_simplices(const Tetrahedron_soup_3& soup)
{
  if(soup.cell_references.size() != soup.cells.size() || soup.facet_references.size() != soup.facets.size()
     || soup.edge_references.size() != soup.edges.size())
    throw Input_error("there is not one reference per cell, facet and edge");
  check_data(soup.point_data, soup.points.size());
  check_data(soup.cell_data, soup.cells.size());
  check_data(soup.facet_data, soup.facets.size());
  check_data(soup.edge_data, soup.edges.size());
  check_cells(soup.cells, soup.points.size());
  for(std::size_t f = 0; f < soup.facets.size(); ++f)
    check_simplex(soup.facets[f], soup.points.size(), "triangle ", f);
  for(std::size_t e = 0; e < soup.edges.size(); ++e)
    check_simplex(soup.edges[e], soup.points.size(), "edge ", e);
  for(std::size_t c = 0; c < soup.corners.size(); ++c)
    check_simplex(std::array{ soup.corners[c] }, soup.points.size(), "corner ", c);
}

inline std::vector<Orientation> orientations_of_cells(const Tetrahedron_soup_3& soup, const bool is_parallel)
{
  return values_of_indices(is_parallel, soup.cells.size(), [&](const std::size_t c)
  {
    const auto [p, q, r, s] = cell_points(soup, c);
    return CGAL::orientation(p, q, r, s);
  });
}

// Are the cells negatively oriented? All must be oriented alike, and none may be flat.
inline bool has_negative_cells(const Tetrahedron_soup_3& soup, const bool is_parallel = false)
{
  const std::vector<Orientation> orientations = orientations_of_cells(soup, is_parallel);
  const std::size_t none = soup.cells.size();
  std::size_t first_positive = none, first_negative = none;
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
  {
    if(orientations[c] == ZERO)
      throw Input_error(sentence("cell ", c, " (counted from 0) has zero volume"));
    std::size_t& first = orientations[c] == POSITIVE ? first_positive : first_negative;
    first = (std::min)(first, c);
  }
  const auto volume = [&](const std::size_t c)
  {
    const auto [p, q, r, s] = cell_points(soup, c);
    return CGAL::volume(p, q, r, s);
  };
  if(first_positive != none && first_negative != none)
    throw Input_error(sentence("cell ", first_negative, " (counted from 0) has the negative volume ", volume(first_negative),
                               ", but cell ", first_positive, " has the positive volume ", volume(first_positive)));
  return first_negative != none;
}

// Do the vertices of a facet, as they turn around its cell, become sorted by an odd permutation? Where two cells meet, they turn
// the other way round.
inline bool is_odd_facet(const std::array<std::size_t, 3>& facet)
{
  const auto [u, v, w] = facet;
  return ((u > v) != (v > w)) != (u > w);
}

// Finds the two sides of each facet of a soup of cells of equal orientation.
// The number `4 * c + i` stands for the facet of cell `c` that is opposite to its vertex `i`.
class Facet_matching_3
{
public:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // `numbers` of the cells are for messages; without them, they are those in the soup.
  explicit Facet_matching_3(const Tetrahedron_soup_3& soup, std::vector<std::size_t> numbers = {},
                            const bool is_parallel = false)
    : m_soup(soup), m_numbers(std::move(numbers)), m_mirrors(4 * soup.cells.size()),
      m_marked_facets(soup.facets.size(), none)
  {
    try
    {
      match_facets(is_parallel);
    }
    catch(const Input_error&)
    {
      match_facets(false); // which throws the first of several mistakes, whatever threads have found
    }
  }

  // The facet seen from the other cell, or `none` on the boundary.
  std::size_t mirror(std::size_t facet) const { return m_mirrors[facet]; }

  // the facets of one cell only
  std::vector<std::size_t> sides_on_boundary() const
  {
    std::vector<std::size_t> result;
    for(std::size_t facet = 0; facet < 4 * m_soup.cells.size(); ++facet)
      if(m_mirrors[facet] == none)
        result.push_back(facet);
    return result;
  }

  // the facets of cells that are marked by `soup.facets`, with their references, each once
  std::vector<std::pair<std::size_t, int> > marks() const
  {
    std::vector<std::pair<std::size_t, int> > result;
    for(std::size_t mark = 0; mark < m_marked_facets.size(); ++mark)
      if(m_marked_facets[mark] != none)
        result.emplace_back(m_marked_facets[mark], m_soup.facet_references[mark]);
    return result;
  }

private:
  // The vertices of a facet of a cell, or of the marked facet `number - 4 * number_of_cells`, and its number.
  using Side = std::pair<std::array<std::size_t, 3>, std::size_t>;

  void match_facets(const bool is_parallel)
  {
    const std::size_t n = 4 * m_soup.cells.size();
    for_each_group(n + m_marked_facets.size(), [&](const std::size_t side)
    {
      return Side(sorted(side < n ? facet_of_cell(m_soup.cells[side / 4], side % 4) : m_soup.facets[side - n]), side);
    },
    [&](const auto begin, const auto end) { match_facet(begin, end); }, is_parallel);
  }

  // Matches the sides of one facet: those of cells come before the marks.
  template <typename Iterator>
  void match_facet(const Iterator begin, const Iterator end)
  {
    const std::size_t n = 4 * m_soup.cells.size();
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

  bool is_odd(const std::size_t facet) const { return is_odd_facet(facet_of_cell(m_soup.cells[facet / 4], facet % 4)); }

  std::string cell_name(std::size_t facet) const
  { return "cell " + std::to_string(m_numbers.empty() ? facet / 4 : m_numbers[facet / 4]); }

  const Tetrahedron_soup_3& m_soup;
  std::vector<std::size_t> m_numbers;
  Dynamic_matrix<std::size_t, Eigen::Dynamic> m_mirrors; // first written by threads, as the items of compressed rows
  std::vector<std::size_t> m_marked_facets; // the facet of a cell, for each that `soup.facets` marks first
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_CHECK_TETRAHEDRON_SOUP_H
