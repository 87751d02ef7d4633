// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_SPLIT_EDGES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_SPLIT_EDGES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Inserted_vertex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refinement/Refinement_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refinement/Simplex_3.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Splits the interior edges among the given pairs of vertices, longest first, and writes an `Inserted_vertex_3` for each
// split. Pairs that are no interior edge are ignored. The time is linear in the number of cells.
template <typename C3t3, typename OutputIterator>
OutputIterator split_edges_3(C3t3& c3t3,
                             const std::vector<std::pair<typename C3t3::Vertex_handle,
                                                         typename C3t3::Vertex_handle> >& edges,
                             OutputIterator out)
{
  using Vertex_handle = typename C3t3::Vertex_handle;
  using Simplex = Simplex_3<Vertex_handle>;

  Refinement_3<C3t3> refinement(c3t3);
  std::vector<std::pair<double, Simplex> > sorted;
  for(const auto& [v, w] : edges)
  {
    const Simplex edge = { v, w };
    if(refinement.choose(edge))
      sorted.emplace_back(squared_size(c3t3.triangulation(), edge), edge);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    refinement.locate_faces(it);

  for(const auto& [size, edge] : sorted)
  {
    const Vertex_handle v = refinement.insert(edge);
    if(v != Vertex_handle())
      *out++ = Inserted_vertex_3<Vertex_handle>{ v, { edge.begin(), edge.end() } };
  }
  return out;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_SPLIT_EDGES_3_H
