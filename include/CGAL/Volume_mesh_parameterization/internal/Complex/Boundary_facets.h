// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_BOUNDARY_FACETS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_BOUNDARY_FACETS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The facets with a cell of a complex on one side and none on the other, as triples of indices of their vertices, which
// turn counterclockwise as seen from outside.
template <typename C3t3>
struct Boundary_facets
{
  using Vertex_handle = typename C3t3::Vertex_handle;

  std::vector<Vertex_handle> vertices;
  std::unordered_map<Vertex_handle, std::size_t> indices;
  std::vector<std::array<std::size_t, 3> > facets;
  std::vector<typename C3t3::Facet> facets_of_complex; // on the side of the cell

  explicit Boundary_facets(const C3t3& c3t3)
  {
    for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    {
      const typename C3t3::Cell_handle c = it;
      for(int i = 0; i < 4; ++i)
        if(!c3t3.is_in_complex(c->neighbor(i)))
          add_facet(c3t3, c, i);
    }
  }

private:
  // The vertex triple of a facet turns counterclockwise as seen from inside the cell.
  void add_facet(const C3t3& c3t3, const typename C3t3::Cell_handle c, const int i)
  {
    std::array<std::size_t, 3> facet;
    for(int k = 0; k < 3; ++k)
    {
      const Vertex_handle v = c->vertex(c3t3.triangulation().vertex_triple_index(i, 2 - k));
      const auto inserted = indices.emplace(v, vertices.size());
      if(inserted.second)
        vertices.push_back(v);
      facet[k] = inserted.first->second;
    }
    facets.push_back(facet);
    facets_of_complex.emplace_back(c, i);
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_BOUNDARY_FACETS_H
