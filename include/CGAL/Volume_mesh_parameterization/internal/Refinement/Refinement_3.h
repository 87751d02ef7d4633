// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_REFINEMENT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_REFINEMENT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Inserted_vertex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refinement/Vertex_insertion_3.h>

#include <boost/functional/hash.hpp>

#include <cstddef>
#include <optional>
#include <unordered_map>

namespace CGAL::Volume_mesh_parameterization::internal {

// A point of a simplex that can become a vertex, as all cells it makes are positive after rounding: the centroid, or else
// one up to a third of the way towards a vertex.
template <typename Tr>
std::optional<Exact_point_3> point_in_simplex_3(const Tr& tr, const Simplex_3<typename Tr::Vertex_handle>& simplex,
                                                const std::vector<typename Tr::Cell_handle>& cells_around)
{
  using Vertex_handle = typename Tr::Vertex_handle;

  const auto weighted_mean = [&](const Vertex_handle preferred, const double additional_weight)
  {
    std::array<double, 3> sum = { 0, 0, 0 };
    double total_weight = 0;
    for(const Vertex_handle v : simplex)
    {
      const double weight = (v == preferred) ? 1 + additional_weight : 1;
      const Exact_point_3 p = exact_point(point_of_vertex(tr, v));
      for(int i = 0; i < 3; ++i)
        sum[i] += weight * p[i];
      total_weight += weight;
    }
    return Exact_point_3(sum[0] / total_weight, sum[1] / total_weight, sum[2] / total_weight);
  };
  const auto makes_positive_cells = [&](const Exact_point_3& p)
  {
    for(const auto c : cells_around)
      for(const Vertex_handle replaced : simplex)
      {
        const auto point = [&](const int i)
        {
          return c->vertex(i) == replaced ? p : exact_point(point_of_vertex(tr, c->vertex(i)));
        };
        if(!is_positive_cell({ point(0), point(1), point(2), point(3) }))
          return false;
      }
    return true;
  };

  for(const double additional_weight : { 0., 0.125, 0.25, 0.5, 1. })
    for(const Vertex_handle v : simplex)
    {
      const Exact_point_3 p = weighted_mean(v, additional_weight);
      if(makes_positive_cells(p))
        return p;
    }
  return std::nullopt;
}

// Inserts vertices into chosen edges, facets and cells of a complex, and knows where the other chosen ones are then.
//
// The triangulation could find an edge by its vertices, but not all of them at a vertex where the boundary is no manifold.
template <typename C3t3>
class Refinement_3
{
  using Vertex_handle = typename C3t3::Vertex_handle;
  using Cell_handle = typename C3t3::Cell_handle;
  using Simplex = Simplex_3<Vertex_handle>;

public:
  explicit Refinement_3(C3t3& c3t3) : m_c3t3(c3t3) {}

  // Chooses a simplex, of a cell if one is known; false if it was chosen before.
  bool choose(const Simplex& simplex, const Cell_handle c = Cell_handle())
  {
    return m_cells.emplace(simplex, c).second;
  }

  // Finds the chosen simplices among the faces of a cell.
  void locate_faces(const Cell_handle c) { set_cell_of_faces(c, c); }

  // A cell that contains a chosen simplex, `Cell_handle()` if there is none.
  Cell_handle cell(const Simplex& simplex) const { return m_cells.at(simplex); }

  // Inserts a vertex into a chosen simplex. The result is `Vertex_handle()` if the simplex does not exist (any more), is
  // not interior, or has no point that makes positive cells after rounding.
  Vertex_handle insert(const Simplex& simplex)
  {
    const Cell_handle c = cell(simplex);
    if(c == Cell_handle() || !is_interior(m_c3t3, simplex, c))
      return Vertex_handle();
    const std::vector<Cell_handle> cells = cells_around(m_c3t3.triangulation(), simplex, c);
    const auto point = point_in_simplex_3(m_c3t3.triangulation(), simplex, cells);
    if(!point)
      return Vertex_handle();

    for(const Cell_handle old_cell : cells)
      set_cell_of_faces(old_cell, Cell_handle());
    Vertex_insertion_3<C3t3> insertion(m_c3t3, simplex, cells);
    const Vertex_handle v = insertion.insert(*point);
    for(const Cell_handle new_cell : insertion.new_cells())
      locate_faces(new_cell);
    return v;
  }

private:
  // The order of the vertices does not matter.
  struct Hash
  {
    std::size_t operator()(const Simplex& simplex) const
    {
      std::size_t sum = 0;
      for(const Vertex_handle v : simplex)
      {
        std::size_t hash = 0;
        boost::hash_combine(hash, v);
        sum += hash;
      }
      return sum;
    }
  };

  struct Has_same_vertices
  {
    bool operator()(const Simplex& a, const Simplex& b) const { return a.size() == b.size() && contains(a, b); }
  };

  void set_cell_of_faces(const Cell_handle c, const Cell_handle value)
  {
    for_each_face(vertices_of_cell(c), [&](const Simplex& face)
    {
      const auto found = m_cells.find(face);
      if(found != m_cells.end())
        found->second = value;
    });
  }

  C3t3& m_c3t3;
  std::unordered_map<Simplex, Cell_handle, Hash, Has_same_vertices> m_cells;
};

// Splits the interior edges among the given pairs of vertices, longest first. Pairs that are no interior edge are ignored.
// The time is linear in the number of cells.
template <typename C3t3>
std::vector<Inserted_vertex_3<typename C3t3::Vertex_handle> >
split_edges_3(C3t3& c3t3, const std::vector<std::array<typename C3t3::Vertex_handle, 2> >& edges)
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

  std::vector<Inserted_vertex_3<Vertex_handle> > result;
  for(const auto& [size, edge] : sorted)
    if(const Vertex_handle v = refinement.insert(edge); v != Vertex_handle())
      result.push_back({ v, { edge.begin(), edge.end() } });
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_REFINEMENT_3_H
