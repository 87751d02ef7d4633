// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/check_tetrahedron_soup.h>

namespace CGAL::Volume_mesh_parameterization::internal {

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
std::vector<std::array<std::size_t, 3> > facets_of_sides(const std::vector<std::array<std::size_t, 4> >& cells,
                                                         const std::vector<std::size_t>& sides)
{
  std::vector<std::array<std::size_t, 3> > result;
  result.reserve(sides.size());
  for(const std::size_t side : sides)
  {
    const auto [u, v, w] = facet_of_cell(cells[side / 4], side % 4);
    result.push_back({ v, w, u });
  }
  return result;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE Body_3 body_of(Tetrahedron_soup_3 soup, const bool is_parallel)
{
  check_simplices(soup);
  const std::vector<std::size_t> sides = Facet_matching_3(soup, {}, is_parallel).sides_on_boundary();
  const auto boundary = facets_of_sides(soup.cells, sides);
  return { std::move(soup), boundary, sides, {}, {} };
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_3_IMPL_H
