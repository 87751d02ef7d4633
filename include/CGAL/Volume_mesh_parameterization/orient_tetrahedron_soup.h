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

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/check_tetrahedron_soup.h>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

// The negative cells. None may be flat.
inline std::vector<std::size_t> negative_cells(const Tetrahedron_soup_3& soup, const bool is_parallel)
{
  const std::vector<Orientation> orientations = values_of_indices(is_parallel, soup.cells.size(), [&](const std::size_t c)
  {
    const auto [p, q, r, s] = cell_points(soup, c);
    return CGAL::orientation(p, q, r, s);
  });
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
/// turns the negative cells of a soup, such that all are positive, as the functions for arrays want them. Where only some are
/// negative, facets tell whether they are reversed, or inverted by vertices that are at a wrong place.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, if TBB is linked, `Parallel_tag` or `Parallel_if_available_tag`
///
/// \return the number of cells that have been turned, by an exchange of their last two vertices
///
/// \exception Input_error as `tetrahedron_soup_to_mesh_complex_3()`, but for facets, if all cells are oriented alike: the
///            functions for arrays look at them; and if cells that are turned lie on the same side of a facet as others. The
///            soup is then unchanged.
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
    try { internal::Facet_matching_3(soup, {}, is_parallel); }
    catch(const Input_error&)
    {
      internal::turn_cells(negative, soup);
      internal::has_negative_cells(soup, is_parallel); // which throws
    }
  }
  return negative.size();
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_ORIENT_TETRAHEDRON_SOUP_H
