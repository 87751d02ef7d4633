// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_MESH_COMPLEX_3_BUILDER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_MESH_COMPLEX_3_BUILDER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_of_complex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Soups/check_tetrahedron_soup.h>

#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Builds a complex from a checked soup through the functions of the triangulation data structure.
template <typename C3t3>
class Mesh_complex_3_builder
{
  using Triangulation = typename C3t3::Triangulation;
  using Tds = typename Triangulation::Triangulation_data_structure;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Cell_handle = typename Triangulation::Cell_handle;
  using Subdomain_index = typename C3t3::Subdomain_index;
  using Surface_patch_index = typename C3t3::Surface_patch_index;
  using Index = typename C3t3::Index;

public:
  Mesh_complex_3_builder(const Tetrahedron_soup_3& soup, const Facet_matching_3& matching, C3t3& c3t3,
                         std::vector<Vertex_handle>& vertices, std::vector<Cell_handle>& cells)
    : m_soup(soup), m_matching(matching), m_c3t3(c3t3), m_vertices(vertices), m_cells(cells)
  {}

  void build(bool has_negative_cells)
  {
    clear();
    add_vertices();
    add_cells(has_negative_cells);
    join_cells();
    close_boundary();
    add_facets();
    add_edges();
    add_corners();
  }

private:
  Triangulation& triangulation() { return m_c3t3.triangulation(); }
  Tds& tds() { return triangulation().tds(); }

  // Clears the complex. An empty triangulation is the infinite vertex in a cell of dimension -1.
  void clear()
  {
    m_c3t3 = C3t3();
    const Vertex_handle infinite = triangulation().infinite_vertex();
    tds().delete_cell(infinite->cell());
    infinite->set_cell(Cell_handle());
    tds().set_dimension(3);
  }

  void add_vertices()
  {
    using Point_3 = typename Triangulation::Geom_traits::Point_3;
    const std::vector<bool> is_used = used_points(m_soup.cells, m_soup.points.size());
    m_vertices.assign(m_soup.points.size(), Vertex_handle());
    for(std::size_t v = 0; v < m_vertices.size(); ++v)
      if(is_used[v])
      {
        const auto& [x, y, z] = m_soup.points[v];
        m_vertices[v] = tds().create_vertex();
        m_vertices[v]->set_point(typename Triangulation::Point(Point_3(x, y, z)));
        m_c3t3.set_dimension(m_vertices[v], 3);
      }
  }

  void add_cells(bool has_negative_cells)
  {
    const int zero_replacement = unused_reference(m_soup.cell_references);
    m_cells.clear();
    m_cells.reserve(m_soup.cells.size());
    for(std::size_t c = 0; c < m_soup.cells.size(); ++c)
    {
      std::array<Vertex_handle, 4> v;
      for(std::size_t i = 0; i < 4; ++i)
        v[i] = m_vertices[m_soup.cells[c][i]];
      if(has_negative_cells)
        std::swap(v[2], v[3]);

      const int reference = m_soup.cell_references[c];
      const Subdomain_index subdomain(reference == 0 ? zero_replacement : reference);
      const Cell_handle cell = tds().create_cell(v[0], v[1], v[2], v[3]);
      m_c3t3.add_to_complex(cell, subdomain);
      m_cells.push_back(cell);
      for(const Vertex_handle vh : v)
      {
        vh->set_cell(cell);
        m_c3t3.set_index(vh, Index(subdomain));
      }
    }
  }

  // Returns the smallest positive number that is not a reference.
  static int unused_reference(const std::vector<int>& references)
  {
    const std::set<int> used(references.begin(), references.end());
    int unused = 1;
    while(used.count(unused) != 0)
      ++unused;
    return unused;
  }

  // Returns the index of a facet in its cell, by the opposite vertex, whichever vertices were swapped.
  int facet_index(std::size_t facet) const
  { return m_cells[facet / 4]->index(m_vertices[m_soup.cells[facet / 4][facet % 4]]); }

  void join_cells()
  {
    for(std::size_t f = 0; f < 4 * m_cells.size(); ++f)
    {
      const std::size_t g = m_matching.mirror(f);
      if(g != Facet_matching_3::none && f < g)
        tds().set_adjacency(m_cells[f / 4], facet_index(f), m_cells[g / 4], facet_index(g));
    }
  }

  void close_boundary()
  {
    std::vector<Cell_handle> infinite_cells;
    for(std::size_t f = 0; f < 4 * m_cells.size(); ++f)
      if(m_matching.mirror(f) == Facet_matching_3::none)
        infinite_cells.push_back(add_infinite_cell(m_cells[f / 4], facet_index(f)));
    for(Cell_handle cell : infinite_cells)
      join_infinite_cell(cell);
  }

  Cell_handle add_infinite_cell(Cell_handle cell, int i)
  {
    const Vertex_handle infinite = triangulation().infinite_vertex();
    std::array<Vertex_handle, 4> v = {cell->vertex(0), cell->vertex(1), cell->vertex(2), cell->vertex(3)};
    v[i] = infinite;
    std::swap(v[(i + 1) % 4], v[(i + 2) % 4]);
    const Cell_handle infinite_cell = tds().create_cell(v[0], v[1], v[2], v[3]);
    infinite->set_cell(infinite_cell);
    tds().set_adjacency(cell, i, infinite_cell, i);
    return infinite_cell;
  }

  // Joins an infinite cell to its neighbors: at each edge of its finite facet, turns through the finite cells around the edge
  // to the next infinite cell. A non-manifold edge so gets one closed circle of cells for each fan of finite cells.
  void join_infinite_cell(Cell_handle infinite_cell)
  {
    const int i = infinite_cell->index(triangulation().infinite_vertex());
    for(int j = 0; j < 4; ++j)
    {
      if(j == i || infinite_cell->neighbor(j) != Cell_handle())
        continue;
      Vertex_handle behind = infinite_cell->vertex(j);
      Cell_handle cell = infinite_cell->neighbor(i);
      Vertex_handle ahead = cell->vertex(cell->index(infinite_cell));
      Cell_handle next = cell->neighbor(cell->index(behind));
      while(!triangulation().is_infinite(next))
      {
        behind = ahead;
        ahead = next->vertex(next->index(cell));
        cell = next;
        next = cell->neighbor(cell->index(behind));
      }
      tds().set_adjacency(infinite_cell, j, next, next->index(ahead));
    }
  }

  // Adds the marked facets and the facets between different subdomains, the outside being one.
  void add_facets()
  {
    const int default_reference = unused_reference(m_soup.facet_references);
    for(std::size_t mark = 0; mark < m_matching.marks().size(); ++mark)
      if(const std::size_t facet = m_matching.marks()[mark]; facet != Facet_matching_3::none)
      {
        const int reference = m_soup.facet_references[mark];
        add_facet(m_cells[facet / 4], facet_index(facet), reference == 0 ? default_reference : reference);
      }
    for(Cell_handle cell : m_cells)
      for(int i = 0; i < 4; ++i)
        if(!m_c3t3.is_in_complex(cell, i)
           && !(m_c3t3.subdomain_index(cell) == m_c3t3.subdomain_index(cell->neighbor(i))))
          add_facet(cell, i, default_reference);
  }

  void add_facet(Cell_handle cell, int i, int reference)
  {
    const Surface_patch_index patch(reference);
    m_c3t3.add_to_complex(cell, i, patch);
    for(int j = 1; j < 4; ++j)
    {
      const Vertex_handle v = cell->vertex((i + j) % 4);
      m_c3t3.set_dimension(v, 2);
      m_c3t3.set_index(v, Index(patch));
    }
  }

  // Adds the marked edges of cells as features, if the complex can have any.
  void add_edges()
  {
    if constexpr(boost::is_detected<Edges_of_complex, C3t3>::value)
    {
      const int default_reference = unused_reference(m_soup.edge_references);
      for(std::size_t e = 0; e < m_soup.edges.size(); ++e)
      {
        const Vertex_handle v = m_vertices[m_soup.edges[e][0]], w = m_vertices[m_soup.edges[e][1]];
        Cell_handle cell;
        int i, k;
        if(v == Vertex_handle() || w == Vertex_handle() || v == w || !triangulation().is_edge(v, w, cell, i, k))
          continue;
        const int reference = m_soup.edge_references[e] == 0 ? default_reference : m_soup.edge_references[e];
        m_c3t3.add_to_complex(v, w, typename C3t3::Curve_index(reference));
      }
    }
  }

  // Adds the marked corners of cells, numbered from 1, likewise.
  void add_corners()
  {
    if constexpr(boost::is_detected<Corners_of_complex, C3t3>::value)
      for(std::size_t c = 0; c < m_soup.corners.size(); ++c)
        if(const Vertex_handle v = m_vertices[m_soup.corners[c]]; v != Vertex_handle())
        {
          const typename C3t3::Corner_index corner(static_cast<int>(c) + 1);
          m_c3t3.add_to_complex(v, corner);
          m_c3t3.set_index(v, Index(corner));
        }
  }

  const Tetrahedron_soup_3& m_soup;
  const Facet_matching_3& m_matching;
  C3t3& m_c3t3;
  std::vector<Vertex_handle>& m_vertices;
  std::vector<Cell_handle>& m_cells;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_MESH_COMPLEX_3_BUILDER_H
