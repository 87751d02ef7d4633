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

// Those of the faces of all cells that occur once, in whatever order of their vertices.
template <typename Face>
std::vector<Face> faces_of_one_cell(const std::vector<Face>& faces)
{
  std::vector<std::pair<Face, Face> > sorted; // with vertices sorted, and as they are
  sorted.reserve(faces.size());
  for(const Face& face : faces)
  {
    sorted.emplace_back(face, face);
    std::sort(sorted.back().first.begin(), sorted.back().first.end());
  }
  std::sort(sorted.begin(), sorted.end());

  std::vector<Face> result;
  for(std::size_t i = 0; i < sorted.size(); ++i)
    if((i == 0 || sorted[i - 1].first != sorted[i].first)
       && (i + 1 == sorted.size() || sorted[i + 1].first != sorted[i].first))
      result.push_back(sorted[i].second);
  return result;
}

// The facets that belong to one cell only; where the cells are positive, their normals point outwards.
inline std::vector<std::array<int, 3> > boundary_facets_3(const std::vector<std::array<int, 4> >& cells)
{
  constexpr int outward[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  std::vector<std::array<int, 3> > facets;
  facets.reserve(4 * cells.size());
  for(const std::array<int, 4>& cell : cells)
    for(const auto& i : outward)
      facets.push_back({ cell[i[0]], cell[i[1]], cell[i[2]] });
  return faces_of_one_cell(facets);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_BOUNDARY_FACETS_3_H
