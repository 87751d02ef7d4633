// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_FACET_MATCHING_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_FACET_MATCHING_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Input_error.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Finds the two sides of each facet of a soup of cells of equal orientation.
// The number `4 * c + i` stands for the facet of cell `c` that is opposite to its vertex `i`.
class Facet_matching_3
{
public:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // `numbers` of the cells are for messages; without them, they are those in the soup.
  explicit Facet_matching_3(const Tetrahedron_soup_3& soup, std::vector<std::size_t> numbers = {})
    : m_soup(soup),
      m_numbers(std::move(numbers)),
      m_mirrors(4 * soup.cells.size(), none)
  {
    const std::vector<std::size_t> bucket_ends = collect_sides();
    std::size_t begin = 0;
    for(std::size_t end : bucket_ends)
    {
      match_bucket(begin, end);
      begin = end;
    }
    m_sides = std::vector<Side>();
  }

  // the same facet seen from the other cell, or `none` on the boundary
  std::size_t mirror(std::size_t facet) const { return m_mirrors[facet]; }

  // the facets of cells that are marked by `soup.facets`, with their references
  const std::vector<std::pair<std::size_t, int> >& marks() const { return m_marks; }

private:
  // A facet of a cell, or the marked facet `owner - 4 * number_of_cells`, without its smallest vertex.
  struct Side
  {
    std::size_t middle, largest, owner;
  };

  template <typename Visit>
  void visit_sides(const Visit& visit) const
  {
    std::size_t owner = 0;
    for(const std::array<std::size_t, 4>& c : m_soup.cells)
      for(std::size_t i = 0; i < 4; ++i)
        visit(sorted({c[(i + 1) % 4], c[(i + 2) % 4], c[(i + 3) % 4]}), owner++);
    for(const std::array<std::size_t, 3>& f : m_soup.facets)
      visit(sorted(f), owner++);
  }

  static std::array<std::size_t, 3> sorted(std::array<std::size_t, 3> f)
  {
    std::sort(f.begin(), f.end());
    return f;
  }

  // Fills `m_sides`, in one bucket for each smallest vertex, and returns the ends of the buckets.
  std::vector<std::size_t> collect_sides()
  {
    std::vector<std::size_t> ends(m_soup.points.size() + 1, 0);
    visit_sides([&](const std::array<std::size_t, 3>& f, std::size_t) { ++ends[f[0] + 1]; });
    std::partial_sum(ends.begin(), ends.end(), ends.begin());

    m_sides.resize(ends.back());
    visit_sides([&](const std::array<std::size_t, 3>& f, std::size_t owner)
    {
      m_sides[ends[f[0]]++] = {f[1], f[2], owner};
    });
    return ends;
  }

  void match_bucket(std::size_t begin, std::size_t end)
  {
    const auto first = m_sides.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = m_sides.begin() + static_cast<std::ptrdiff_t>(end);
    std::sort(first, last, [](const Side& a, const Side& b)
    {
      return std::tie(a.middle, a.largest, a.owner) < std::tie(b.middle, b.largest, b.owner);
    });

    while(begin != end)
    {
      const Side& front = m_sides[begin];
      std::size_t next = begin + 1;
      while(next != end && m_sides[next].middle == front.middle && m_sides[next].largest == front.largest)
        ++next;
      match_facet(begin, next);
      begin = next;
    }
  }

  // Handles the sides `[begin, end)` of one facet; those of cells come before the marks.
  void match_facet(std::size_t begin, std::size_t end)
  {
    std::size_t first_mark = begin;
    while(first_mark != end && m_sides[first_mark].owner < m_mirrors.size())
      ++first_mark;

    const std::size_t number_of_cells = first_mark - begin;
    if(number_of_cells == 0)
      return;
    const std::size_t facet = m_sides[begin].owner;
    if(number_of_cells > 2)
      throw Input_error("more than two cells share a facet, among them " + cell_name(facet) + ", "
                        + cell_name(m_sides[begin + 1].owner) + " and " + cell_name(m_sides[begin + 2].owner));
    if(number_of_cells == 2)
      join(facet, m_sides[begin + 1].owner);
    if(first_mark != end)
      m_marks.emplace_back(facet, m_soup.facet_references[m_sides[first_mark].owner - m_mirrors.size()]);
  }

  void join(std::size_t f, std::size_t g)
  {
    if(!are_on_two_sides(f, g))
      throw Input_error(cell_name(f) + " and " + cell_name(g)
                        + " overlap, they lie on the same side of their common facet");
    m_mirrors[f] = g;
    m_mirrors[g] = f;
  }

  // The apex of one cell, put in place of the apex of the other, must give an odd permutation of the first cell.
  bool are_on_two_sides(std::size_t f, std::size_t g) const
  {
    const std::array<std::size_t, 4>& c = m_soup.cells[f / 4];
    std::array<std::size_t, 4> d = m_soup.cells[g / 4];
    d[g % 4] = c[f % 4];

    bool is_odd = false;
    for(std::size_t i = 0; i < 4; ++i)
    {
      const std::size_t j = static_cast<std::size_t>(std::find(d.begin(), d.end(), c[i]) - d.begin());
      if(i != j)
      {
        std::swap(d[i], d[j]);
        is_odd = !is_odd;
      }
    }
    return is_odd;
  }

  std::string cell_name(std::size_t facet) const
  {
    return "cell " + std::to_string(m_numbers.empty() ? facet / 4 : m_numbers[facet / 4]);
  }

  const Tetrahedron_soup_3& m_soup;
  std::vector<std::size_t> m_numbers;
  std::vector<std::size_t> m_mirrors;
  std::vector<std::pair<std::size_t, int> > m_marks;
  std::vector<Side> m_sides;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_FACET_MATCHING_3_H
