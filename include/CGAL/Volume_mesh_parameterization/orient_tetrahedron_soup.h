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

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// turns the cells of a soup if all are negative, such that all are positive, as the functions for arrays want them.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, if TBB is linked, `Parallel_tag` or `Parallel_if_available_tag`
///
/// \return whether the cells have been turned, by an exchange of their last two vertices
///
/// \exception Input_error as `tetrahedron_soup_to_mesh_complex_3()`, but for facets, which the functions for arrays look
///            at; the soup is then unchanged.
template <typename ConcurrencyTag = Sequential_tag>
bool orient_tetrahedron_soup(Tetrahedron_soup_3& soup)
{
  internal::check_points(soup);
  internal::check_simplices(soup);
  constexpr bool is_parallel = internal::is_parallel<ConcurrencyTag>();
  const bool has_negative_cells = internal::has_negative_cells(soup, is_parallel);
  if(has_negative_cells)
    for(std::array<std::size_t, 4>& cell : soup.cells)
      std::swap(cell[2], cell[3]);
  return has_negative_cells;
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_ORIENT_TETRAHEDRON_SOUP_H
