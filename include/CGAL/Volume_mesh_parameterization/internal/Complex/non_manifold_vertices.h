// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_NON_MANIFOLD_VERTICES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_NON_MANIFOLD_VERTICES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The vertices at an edge that has not two facets, and those whose corners of facets are not all joined by such edges.
inline std::vector<std::size_t> non_manifold_vertices(const std::size_t number_of_vertices,
                                                      const std::vector<std::array<std::size_t, 3> >& facets)
{
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  using Edge = std::pair<std::array<std::size_t, 2>, std::array<std::size_t, 2> >; // vertices, corners there
  std::vector<Edge> edges;
  for(std::size_t f = 0; f < facets.size(); ++f)
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t l = (k + 1) % 3;
      edges.push_back({ { facets[f][k], facets[f][l] }, { 3 * f + k, 3 * f + l } });
      if(facets[f][k] > facets[f][l])
      {
        std::swap(edges.back().first[0], edges.back().first[1]);
        std::swap(edges.back().second[0], edges.back().second[1]);
      }
    }
  std::sort(edges.begin(), edges.end());

  std::vector<bool> is_bad(number_of_vertices, false);
  Disjoint_sets corners(3 * facets.size());
  for(auto begin = edges.begin(), end = begin; begin != edges.end(); begin = end)
  {
    end = std::find_if(begin, edges.end(), [&](const Edge& edge) { return edge.first != begin->first; });
    for(std::size_t i = 0; i < 2; ++i)
      if(end - begin == 2)
        corners.unite(begin->second[i], (begin + 1)->second[i]);
      else
        is_bad[begin->first[i]] = true;
  }

  std::vector<std::size_t> umbrella(number_of_vertices, none);
  for(std::size_t corner = 0; corner < 3 * facets.size(); ++corner)
  {
    const std::size_t v = facets[corner / 3][corner % 3], set = corners.find(corner);
    is_bad[v] = is_bad[v] || (umbrella[v] != none && umbrella[v] != set);
    umbrella[v] = set;
  }
  std::vector<std::size_t> result;
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    if(is_bad[v])
      result.push_back(v);
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_NON_MANIFOLD_VERTICES_H
