// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_VERTEX_INSERTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_VERTEX_INSERTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_point_3.h>

#include <boost/container/static_vector.hpp>

#include <utility>
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

// Makes a vertex of a point of an interior edge, facet or cell of a complex. The new cells, facets and feature
// edges belong to the complex with the indices of those that contain them, and the new vertex gets the
// dimension and the index of the face of the complex it lies in.
template <typename C3t3>
class Vertex_insertion_3
{
  using Triangulation = typename C3t3::Triangulation;
  using Vertex_handle = typename C3t3::Vertex_handle;
  using Cell_handle = typename C3t3::Cell_handle;
  using Facet = typename C3t3::Facet;
  using Subdomain_index = typename C3t3::Subdomain_index;
  using Surface_patch_index = typename C3t3::Surface_patch_index;
  using Index = typename C3t3::Index;

public:
  Vertex_insertion_3(C3t3& c3t3, const Simplex_3<Vertex_handle>& simplex, const std::vector<Cell_handle>& cells_around)
    : m_c3t3(c3t3), m_simplex(simplex), m_cells(cells_around)
  {}

  Vertex_handle insert(const Exact_point_3& p)
  {
    for(const Cell_handle c : m_cells)
      record(c);
    for(const Cell_handle c : m_cells)
      remove_from_complex(c);

    const Cell_handle first = m_cells.front();
    const Vertex_handle v = m_c3t3.triangulation().tds().insert_in_hole(m_cells.begin(), m_cells.end(),
                                                                        first, first->index(m_simplex[0]));
    v->set_point(typename Triangulation::Point(typename Triangulation::Geom_traits::Point_3(p.x(), p.y(), p.z())));
    set_dimension_and_index(v);
    for(const Outer_facet& outer : m_outer_facets)
      add_to_complex(outer);
    return v;
  }

  // The cells around the new vertex.
  std::vector<Cell_handle> new_cells() const
  {
    std::vector<Cell_handle> cells;
    for(const Outer_facet& outer : m_outer_facets)
      cells.push_back(outer.new_cell());
    return cells;
  }

private:
  // A facet opposite to the new vertex, seen from the cell behind it, which stays as it is.
  struct Outer_facet
  {
    Facet facet;
    Subdomain_index subdomain;
    boost::container::static_vector<std::pair<Vertex_handle, Surface_patch_index>, 2> split_facets;

    Cell_handle new_cell() const { return facet.first->neighbor(facet.second); }
  };

  // Each vertex of the cell that is not in the simplex is opposite to a facet that will be split.
  template <typename Function>
  void for_each_split_facet(const Cell_handle c, const Function& f) const
  {
    for(int i = 0; i < 4; ++i)
      if(!contains(m_simplex, c->vertex(i)))
        f(i);
  }

  void record(const Cell_handle c)
  {
    Outer_facet outer;
    outer.subdomain = m_c3t3.subdomain_index(c);
    for_each_split_facet(c, [&](const int i)
    {
      if(m_c3t3.is_in_complex(c, i))
      {
        outer.split_facets.emplace_back(c->vertex(i), m_c3t3.surface_patch_index(c, i));
        m_surface_patch = m_c3t3.surface_patch_index(c, i);
        m_dimension = 2;
      }
    });
    m_subdomain = outer.subdomain;
    for(const Vertex_handle v : m_simplex)
    {
      outer.facet = m_c3t3.triangulation().mirror_facet(Facet(c, c->index(v)));
      m_outer_facets.push_back(outer);
    }
  }

  void remove_from_complex(const Cell_handle c)
  {
    for_each_split_facet(c, [&](const int i) { m_c3t3.remove_from_complex(c, i); });
    m_c3t3.remove_from_complex(c);
  }

  void add_to_complex(const Outer_facet& outer)
  {
    const Cell_handle c = outer.new_cell();
    m_c3t3.add_to_complex(c, outer.subdomain);
    // The outer facet has been in the complex or not all the time: only its new side must be told.
    const Facet inner = m_c3t3.triangulation().mirror_facet(outer.facet);
    m_c3t3.set_surface_patch_index(inner, m_c3t3.surface_patch_index(outer.facet));
    for(const auto& [opposite, patch] : outer.split_facets)
      m_c3t3.add_to_complex(c, c->index(opposite), patch);
  }

  void set_dimension_and_index(const Vertex_handle v)
  {
    if(m_simplex.size() == 2 && m_c3t3.is_in_complex(m_simplex[0], m_simplex[1]))
    {
      split_feature_edge(v);
      return;
    }
    m_c3t3.set_dimension(v, m_dimension);
    m_c3t3.set_index(v, m_dimension == 2 ? Index(m_surface_patch) : Index(m_subdomain));
  }

  void split_feature_edge(const Vertex_handle v)
  {
    const auto curve = m_c3t3.curve_index(m_simplex[0], m_simplex[1]);
    m_c3t3.remove_from_complex(m_simplex[0], m_simplex[1]);
    m_c3t3.add_to_complex(m_simplex[0], v, curve);
    m_c3t3.add_to_complex(v, m_simplex[1], curve);
    m_c3t3.set_dimension(v, 1);
    m_c3t3.set_index(v, Index(curve));
  }

  C3t3& m_c3t3;
  const Simplex_3<Vertex_handle>& m_simplex;
  const std::vector<Cell_handle>& m_cells;
  std::vector<Outer_facet> m_outer_facets;
  int m_dimension = 3;
  Subdomain_index m_subdomain = Subdomain_index();
  Surface_patch_index m_surface_patch = Surface_patch_index();
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_VERTEX_INSERTION_3_H
