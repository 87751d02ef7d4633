// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_REFINEMENT_VERTEX_INSERTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_REFINEMENT_VERTEX_INSERTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_of_complex_3.h>

#include <CGAL/assertions.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Makes a vertex of a point of an edge, or of an interior facet or cell, of a complex. The new cells, facets and feature
// edges belong to the complex with the indices of those that contain them, and the new vertex gets the
// dimension and the index of the face of the complex it lies in. `Refinement_3` has found that all cells of the complex become
// positive. Around an edge of the boundary, the cells outside are split as well.
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
  using Simplex = boost::container::static_vector<Vertex_handle, 4>;

public:
  Vertex_insertion_3(C3t3& c3t3, const Simplex& simplex, const std::vector<Cell_handle>& cells_around)
    : m_c3t3(c3t3), m_simplex(simplex), m_cells(cells_around)
  { add_cells_outside(); }

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

  // The cells of the complex around the new vertex: of each old one, in order, those without one vertex of the simplex after the
  // other.
  std::vector<Cell_handle> new_cells() const
  {
    std::vector<Cell_handle> cells;
    for(const Outer_facet& outer : m_outer_facets)
      if(outer.is_of_complex)
        cells.push_back(outer.new_cell());
    return cells;
  }

private:
  // A facet opposite to the new vertex, seen from the cell behind it, which stays as it is.
  struct Outer_facet
  {
    Facet facet;
    bool is_of_complex; // is the old cell?
    Subdomain_index subdomain;
    boost::container::static_vector<std::pair<Vertex_handle, Surface_patch_index>, 2> split_facets;

    Cell_handle new_cell() const { return facet.first->neighbor(facet.second); }
  };

  void add_cells_outside()
  {
    if(m_simplex.size() != 2)
      return;
    const Cell_handle first = m_cells.front();
    const auto begin = m_c3t3.triangulation().incident_cells(first, first->index(m_simplex[0]), first->index(m_simplex[1]));
    auto next = begin;
    do
      if(const Cell_handle c = next; !m_c3t3.is_in_complex(c))
        m_cells.push_back(c);
    while(++next != begin);
  }

  // Each vertex of the cell that is not in the simplex is opposite to a facet that will be split.
  template <typename Function>
  void for_each_split_facet(const Cell_handle c, const Function& f) const
  {
    for(int i = 0; i < 4; ++i)
      if(std::find(m_simplex.begin(), m_simplex.end(), c->vertex(i)) == m_simplex.end())
        f(i);
  }

  void record(const Cell_handle c)
  {
    Outer_facet outer;
    outer.is_of_complex = m_c3t3.is_in_complex(c);
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
    if(outer.is_of_complex)
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
    if(outer.is_of_complex)
      m_c3t3.add_to_complex(c, outer.subdomain);
    if(m_c3t3.is_in_complex(outer.facet)) // adds it again, since its side in the new cell is not marked yet
    {
      const Surface_patch_index patch = m_c3t3.surface_patch_index(outer.facet);
      m_c3t3.remove_from_complex(outer.facet);
      m_c3t3.add_to_complex(outer.facet, patch);
    }
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
  const Simplex& m_simplex;
  std::vector<Cell_handle> m_cells; // around the simplex, those of the complex first
  std::vector<Outer_facet> m_outer_facets;
  int m_dimension = 3;
  Subdomain_index m_subdomain = Subdomain_index();
  Surface_patch_index m_surface_patch = Surface_patch_index();
};

// Makes the insertions into the body of a complex in the complex, too.
template <typename C3t3>
void insert_vertices(C3t3& c3t3, Body_of_complex_3<C3t3>& body, const std::vector<Insertion_3>& insertions)
{
  for(const Insertion_3& insertion : insertions)
  {
    boost::container::static_vector<typename C3t3::Vertex_handle, 4> simplex;
    for(const std::size_t v : insertion.simplex)
      simplex.push_back(body.vertices[v]);
    std::vector<typename C3t3::Cell_handle> cells;
    for(const std::size_t c : insertion.cells)
      cells.push_back(body.cells_of_complex[c]);

    Vertex_insertion_3<C3t3> in_complex(c3t3, simplex, cells);
    body.vertices.push_back(in_complex.insert(exact_point(body.points[insertion.point])));
    // in the order of `Incident_simplices_3::insert()`
    const std::vector<typename C3t3::Cell_handle> new_cells = in_complex.new_cells();
    CGAL_assertion(body.vertices.size() == insertion.point + 1);
    CGAL_assertion(new_cells.size() == simplex.size() * cells.size());
    for(std::size_t i = 0; i < new_cells.size(); ++i)
      if(i % simplex.size() == 0)
        body.cells_of_complex[insertion.cells[i / simplex.size()]] = new_cells[i];
      else
        body.cells_of_complex.push_back(new_cells[i]);
  }
}

// Returns the numbers that the cells of a complex have in its body, in the order of the complex.
template <typename C3t3>
std::vector<std::size_t> order_of_cells(const C3t3& c3t3, const Body_of_complex_3<C3t3>& body)
{
  std::unordered_map<typename C3t3::Cell_handle, std::size_t> numbers;
  for(std::size_t c = 0; c < body.cells_of_complex.size(); ++c)
    numbers.emplace(body.cells_of_complex[c], c);
  std::vector<std::size_t> result;
  for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    result.push_back(numbers.at(it));
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_REFINEMENT_VERTEX_INSERTION_3_H
