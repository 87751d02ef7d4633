// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_COMPLEX_3_BUILDER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_COMPLEX_3_BUILDER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Facet_matching_3.h>

#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Builds a complex from a checked soup through the functions of the triangulation data structure.
template <typename C3t3>
class Mesh_complex_3_builder
{
  typedef typename C3t3::Triangulation                    Triangulation;
  typedef typename Triangulation::Triangulation_data_structure Tds;
  typedef typename Triangulation::Vertex_handle           Vertex_handle;
  typedef typename Triangulation::Cell_handle             Cell_handle;
  typedef typename C3t3::Subdomain_index                  Subdomain_index;
  typedef typename C3t3::Surface_patch_index              Surface_patch_index;
  typedef typename C3t3::Index                            Index;

public:
  Mesh_complex_3_builder(const Tetrahedron_soup_3& soup,
                         const Facet_matching_3& matching,
                         C3t3& c3t3,
                         std::vector<Vertex_handle>& vertices,
                         std::vector<Cell_handle>& cells)
    : soup_(soup), matching_(matching), c3t3_(c3t3), vertices_(vertices), cells_(cells)
  {}

  void build(bool has_negative_cells)
  {
    clear();
    add_vertices();
    add_cells(has_negative_cells);
    join_cells();
    close_boundary();
    add_facets();
  }

private:
  Triangulation& triangulation() { return c3t3_.triangulation(); }
  Tds& tds() { return triangulation().tds(); }

  // An empty triangulation is the infinite vertex in a cell of dimension -1.
  void clear()
  {
    c3t3_.clear();
    const Vertex_handle infinite = triangulation().infinite_vertex();
    tds().delete_cell(infinite->cell());
    infinite->set_cell(Cell_handle());
    tds().set_dimension(3);
  }

  void add_vertices()
  {
    typedef typename Triangulation::Point Point;
    typedef typename Triangulation::Geom_traits::Point_3 Point_3;

    std::vector<bool> is_used(soup_.points.size(), false);
    for(const std::array<std::size_t, 4>& cell : soup_.cells)
      for(std::size_t v : cell)
        is_used[v] = true;

    vertices_.assign(soup_.points.size(), Vertex_handle());
    for(std::size_t v = 0; v < vertices_.size(); ++v)
    {
      if(!is_used[v])
        continue;
      const std::array<double, 3>& p = soup_.points[v];
      vertices_[v] = tds().create_vertex();
      vertices_[v]->set_point(Point(Point_3(p[0], p[1], p[2])));
      c3t3_.set_dimension(vertices_[v], 3);
    }
  }

  void add_cells(bool has_negative_cells)
  {
    const int zero_replacement = unused_reference(soup_.cell_references);

    cells_.clear();
    cells_.reserve(soup_.cells.size());
    for(std::size_t c = 0; c < soup_.cells.size(); ++c)
    {
      std::array<Vertex_handle, 4> v;
      for(std::size_t i = 0; i < 4; ++i)
        v[i] = vertices_[soup_.cells[c][i]];
      if(has_negative_cells)
        std::swap(v[2], v[3]);

      const int reference = soup_.cell_references[c];
      const Subdomain_index subdomain(reference == 0 ? zero_replacement : reference);
      const Cell_handle cell = tds().create_cell(v[0], v[1], v[2], v[3]);
      c3t3_.add_to_complex(cell, subdomain);
      cells_.push_back(cell);

      for(Vertex_handle vh : v)
      {
        vh->set_cell(cell);
        c3t3_.set_index(vh, Index(subdomain));
      }
    }
  }

  // the smallest positive number that is not a reference
  static int unused_reference(const std::vector<int>& references)
  {
    const std::set<int> used(references.begin(), references.end());
    int unused = 1;
    while(used.count(unused) != 0)
      ++unused;
    return unused;
  }

  // The handle of the vertex opposite to a facet also finds the index of the facet, whichever vertices were swapped.
  int facet_index(std::size_t facet) const
  {
    return cells_[facet / 4]->index(vertices_[soup_.cells[facet / 4][facet % 4]]);
  }

  void join_cells()
  {
    for(std::size_t f = 0; f < 4 * cells_.size(); ++f)
    {
      const std::size_t g = matching_.mirror(f);
      if(g != Facet_matching_3::none && f < g)
        tds().set_adjacency(cells_[f / 4], facet_index(f), cells_[g / 4], facet_index(g));
    }
  }

  void close_boundary()
  {
    std::vector<Cell_handle> infinite_cells;
    for(std::size_t f = 0; f < 4 * cells_.size(); ++f)
      if(matching_.mirror(f) == Facet_matching_3::none)
        infinite_cells.push_back(add_infinite_cell(cells_[f / 4], facet_index(f)));

    for(Cell_handle cell : infinite_cells)
      join_infinite_cell(cell);
  }

  Cell_handle add_infinite_cell(Cell_handle cell, int i)
  {
    const Vertex_handle infinite = triangulation().infinite_vertex();
    std::array<Vertex_handle, 4> v = {cell->vertex(0), cell->vertex(1), cell->vertex(2), cell->vertex(3)};
    v[static_cast<std::size_t>(i)] = infinite;
    std::swap(v[static_cast<std::size_t>((i + 1) % 4)], v[static_cast<std::size_t>((i + 2) % 4)]);

    const Cell_handle infinite_cell = tds().create_cell(v[0], v[1], v[2], v[3]);
    infinite->set_cell(infinite_cell);
    tds().set_adjacency(cell, i, infinite_cell, i);
    return infinite_cell;
  }

  // From each edge of its finite facet, turns through the finite cells around that edge to the next infinite cell.
  // A non-manifold edge so gets one closed circle of cells for each fan of finite cells.
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

  // The complex has the marked facets and those between different subdomains, the outside being one.
  void add_facets()
  {
    const int default_reference = unused_reference(soup_.facet_references);
    for(const auto& [facet, reference] : matching_.marks())
      add_facet(cells_[facet / 4], facet_index(facet), reference == 0 ? default_reference : reference);

    for(Cell_handle cell : cells_)
      for(int i = 0; i < 4; ++i)
        if(!c3t3_.is_in_complex(cell, i)
           && !(c3t3_.subdomain_index(cell) == c3t3_.subdomain_index(cell->neighbor(i))))
          add_facet(cell, i, default_reference);
  }

  void add_facet(Cell_handle cell, int i, int reference)
  {
    const Surface_patch_index patch(reference);
    c3t3_.add_to_complex(cell, i, patch);
    for(int j = 1; j < 4; ++j)
    {
      const Vertex_handle v = cell->vertex((i + j) % 4);
      c3t3_.set_dimension(v, 2);
      c3t3_.set_index(v, Index(patch));
    }
  }

  const Tetrahedron_soup_3& soup_;
  const Facet_matching_3& matching_;
  C3t3& c3t3_;
  std::vector<Vertex_handle>& vertices_;
  std::vector<Cell_handle>& cells_;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_COMPLEX_3_BUILDER_H
