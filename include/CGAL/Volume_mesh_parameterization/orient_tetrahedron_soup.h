// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_ORIENT_TETRAHEDRON_SOUP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_ORIENT_TETRAHEDRON_SOUP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Soups/check_tetrahedron_soup.h>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

// The negative cells. None may be flat.
inline std::vector<std::size_t> negative_cells(const Tetrahedron_soup_3& soup, const bool is_parallel)
{
  const std::vector<Orientation> orientations = orientations_of_cells(soup, is_parallel);
  std::vector<std::size_t> negative, flat;
  for(std::size_t c = 0; c < orientations.size(); ++c)
    if(orientations[c] != POSITIVE)
      (orientations[c] == ZERO ? flat : negative).push_back(c);
  if(flat.size() > 1)
    throw Input_error(sentence(flat.size(), " cells have zero volume, among them cells ", flat[0], " and ", flat[1],
                               " (counted from 0)"));
  if(flat.size() == 1)
    throw Input_error(sentence("cell ", flat[0], " (counted from 0) has zero volume"));
  return negative;
}

inline void turn_cells(const std::vector<std::size_t>& cells, Tetrahedron_soup_3& soup)
{
  for(const std::size_t c : cells)
    std::swap(soup.cells[c][2], soup.cells[c][3]);
}

} // namespace internal

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// turns the negative cells of a soup. Then all cells are positive, as the functions for arrays need them. If only some cells
/// are negative, facets decide whether these are reversed, or inverted by vertices at a wrong place.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, if TBB is linked, `Parallel_tag` or `Parallel_if_available_tag`
///
/// \return the number of cells that have been turned, by an exchange of their last two vertices
///
/// \exception Input_error is thrown as by tetrahedron_soup_to_mesh_complex_3(), with one difference. If all cells are oriented
///            alike, facets are not checked, because the functions for arrays check them. It is also thrown if turned cells lie
///            on the same side of a facet as others. The soup is then unchanged.
template <typename ConcurrencyTag = Sequential_tag>
std::size_t orient_tetrahedron_soup(Tetrahedron_soup_3& soup)
{
  internal::check_points(soup);
  internal::check_simplices(soup);
  constexpr bool is_parallel = internal::is_parallel<ConcurrencyTag>();
  const std::vector<std::size_t> negative = internal::negative_cells(soup, is_parallel);
  internal::turn_cells(negative, soup);
  if(!negative.empty() && negative.size() != soup.cells.size())
  {
    try { internal::Facet_matching_3(soup.cells, is_parallel); }
    catch(const Input_error&)
    {
      internal::turn_cells(negative, soup);
      internal::has_negative_cells(soup, is_parallel); // which throws
    }
  }
  return negative.size();
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// turns cells of a soup that may be tangled. Then two cells at a facet lie on different sides of it, and the cells that facets
/// join have a positive total volume. Cells that are negative or flat then are inverted by vertices at a wrong place. The time
/// is O(n log n) for n cells.
///
/// \return the number of cells that have been turned, by an exchange of their last two vertices
///
/// \exception Input_error if facets do not determine the orientation, for instance because three cells share one. The soup is then
///            unchanged.
inline std::size_t orient_tetrahedron_soup_by_facets(Tetrahedron_soup_3& soup)
{
  internal::check_points(soup);
  internal::check_simplices(soup);
  struct Neighbor
  {
    std::size_t cell;
    bool is_reversed; // relative to the other cell
  };
  std::vector<std::vector<Neighbor> > neighbors(soup.cells.size());
  const auto facet = [&](const std::size_t side) { return internal::facet_of_cell(soup.cells[side / 4], side % 4); };
  internal::for_each_group(4 * soup.cells.size(),
                           [&](const std::size_t side) { return std::make_pair(internal::sorted(facet(side)), side); },
                           [&](const auto begin, const auto end)
  {
    if(end - begin != 2)
      return;
    const std::size_t side = begin->second, other = (begin + 1)->second;
    const bool is_reversed = internal::is_odd_facet(facet(side)) == internal::is_odd_facet(facet(other));
    neighbors[side / 4].push_back({ other / 4, is_reversed });
    neighbors[other / 4].push_back({ side / 4, is_reversed });
  });

  std::vector<char> is_known(soup.cells.size(), false), is_turned(soup.cells.size(), false);
  for(std::size_t first = 0; first < soup.cells.size(); ++first)
  {
    if(is_known[first])
      continue;
    std::vector<std::size_t> component = { first };
    is_known[first] = true;
    double volume = 0;
    for(std::size_t i = 0; i < component.size(); ++i)
    {
      const std::size_t c = component[i];
      const auto [p, q, r, s] = internal::cell_points(soup, c);
      volume += is_turned[c] ? -CGAL::volume(p, q, r, s) : CGAL::volume(p, q, r, s);
      for(const Neighbor& neighbor : neighbors[c])
        if(!is_known[neighbor.cell])
        {
          is_known[neighbor.cell] = true;
          is_turned[neighbor.cell] = is_turned[c] != neighbor.is_reversed;
          component.push_back(neighbor.cell);
        }
    }
    for(const std::size_t c : component)
      is_turned[c] = is_turned[c] != (volume < 0);
  }
  std::vector<std::size_t> turned;
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    if(is_turned[c])
      turned.push_back(c);
  internal::turn_cells(turned, soup);
  try { internal::Facet_matching_3 matching(soup.cells); }
  catch(const Input_error&)
  {
    internal::turn_cells(turned, soup);
    throw;
  }
  return turned.size();
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_ORIENT_TETRAHEDRON_SOUP_H
