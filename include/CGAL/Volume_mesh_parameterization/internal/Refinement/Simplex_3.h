// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_SIMPLEX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_SIMPLEX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_point_3.h>

#include <boost/container/static_vector.hpp>

#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// An edge, facet or cell, given by its two, three or four vertices. Those of a cell are in its order.
template <typename VertexHandle>
using Simplex_3 = boost::container::static_vector<VertexHandle, 4>;

template <typename CellHandle>
auto vertices_of_cell(const CellHandle c)
{
  const auto vertices = { c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) };
  return Simplex_3<typename decltype(vertices)::value_type>(vertices.begin(), vertices.end());
}

template <typename VertexHandle>
bool contains(const Simplex_3<VertexHandle>& simplex, const VertexHandle v)
{
  return std::find(simplex.begin(), simplex.end(), v) != simplex.end();
}

template <typename VertexHandle>
bool contains(const Simplex_3<VertexHandle>& simplex, const Simplex_3<VertexHandle>& face)
{
  return std::all_of(face.begin(), face.end(), [&](const VertexHandle v) { return contains(simplex, v); });
}

// Calls f for the edges, facets and cells that are faces of the simplex, itself included.
template <typename VertexHandle, typename Function>
void for_each_face(const Simplex_3<VertexHandle>& simplex, const Function& f)
{
  for(unsigned int subset = 0; subset < (1u << simplex.size()); ++subset)
  {
    Simplex_3<VertexHandle> face;
    for(unsigned int i = 0; i < simplex.size(); ++i)
      if(subset & (1u << i))
        face.push_back(simplex[i]);
    if(face.size() >= 2)
      f(face);
  }
}

// The squared length of the longest edge.
template <typename Tr>
double squared_size(const Tr& tr, const Simplex_3<typename Tr::Vertex_handle>& simplex)
{
  double result = 0;
  for(const auto v : simplex)
    for(const auto w : simplex)
      result = (std::max)(result, CGAL::squared_distance(exact_point(point_of_vertex(tr, v)),
                                                         exact_point(point_of_vertex(tr, w))));
  return result;
}

// The cells that contain a simplex of the cell c.
template <typename Tr>
std::vector<typename Tr::Cell_handle> cells_around(const Tr& tr, const Simplex_3<typename Tr::Vertex_handle>& simplex,
                                                   const typename Tr::Cell_handle c)
{
  if(simplex.size() == 4)
    return { c };
  if(simplex.size() == 3)
    return { c, c->neighbor(6 - c->index(simplex[0]) - c->index(simplex[1]) - c->index(simplex[2])) };

  std::vector<typename Tr::Cell_handle> cells;
  auto circulator = tr.incident_cells(c, c->index(simplex[0]), c->index(simplex[1]));
  const auto end = circulator;
  do
    cells.push_back(circulator);
  while(++circulator != end);
  return cells;
}

// Does a simplex of the cell c lie inside the complex, that is not in a facet between the complex and the outside?
template <typename C3t3>
bool is_interior(const C3t3& c3t3, const Simplex_3<typename C3t3::Vertex_handle>& simplex,
                 const typename C3t3::Cell_handle c)
{
  const auto cells = cells_around(c3t3.triangulation(), simplex, c);
  return std::all_of(cells.begin(), cells.end(), [&](const auto around) { return c3t3.is_in_complex(around); });
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_SIMPLEX_3_H
