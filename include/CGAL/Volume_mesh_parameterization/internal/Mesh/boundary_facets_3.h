// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_BOUNDARY_FACETS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_BOUNDARY_FACETS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The facets that belong to one cell only; where the cells are positive, their normals point outwards.
inline std::vector<std::array<int, 3> > boundary_facets_3(const std::vector<std::array<int, 4> >& cells)
{
  constexpr int outward[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  using Facet = std::array<int, 3>;
  std::vector<std::pair<Facet, Facet> > facets; // with vertices sorted, and as they are
  facets.reserve(4 * cells.size());
  for(const std::array<int, 4>& cell : cells)
    for(const auto& i : outward)
    {
      const Facet facet = { cell[i[0]], cell[i[1]], cell[i[2]] };
      facets.emplace_back(facet, facet);
      std::sort(facets.back().first.begin(), facets.back().first.end());
    }
  std::sort(facets.begin(), facets.end());

  std::vector<Facet> result;
  for(std::size_t i = 0; i < facets.size(); ++i)
    if((i == 0 || facets[i - 1].first != facets[i].first)
       && (i + 1 == facets.size() || facets[i + 1].first != facets[i].first))
      result.push_back(facets[i].second);
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_BOUNDARY_FACETS_3_H
