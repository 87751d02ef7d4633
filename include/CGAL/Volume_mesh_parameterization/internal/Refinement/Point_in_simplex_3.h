// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_POINT_IN_SIMPLEX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_POINT_IN_SIMPLEX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_point_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refinement/Simplex_3.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Finds a point of a simplex that can become a vertex: all cells it makes are positive after rounding.
template <typename Tr>
class Point_in_simplex_3
{
  using Vertex_handle = typename Tr::Vertex_handle;
  using Cell_handle = typename Tr::Cell_handle;

public:
  Point_in_simplex_3(const Tr& tr, const Simplex_3<Vertex_handle>& simplex, const std::vector<Cell_handle>& cells_around)
    : m_tr(tr), m_simplex(simplex), m_cells(cells_around)
  {}

  // The centroid, or else a point up to a third of the way towards a vertex.
  std::optional<Exact_point_3> find() const
  {
    for(const double additional_weight : { 0., 0.125, 0.25, 0.5, 1. })
      for(const Vertex_handle v : m_simplex)
      {
        const Exact_point_3 p = weighted_mean(v, additional_weight);
        if(makes_positive_cells(p))
          return p;
      }
    return std::nullopt;
  }

private:
  Exact_point_3 point(const Vertex_handle v) const
  {
    return exact_point(m_tr.geom_traits().construct_point_3_object()(m_tr.point(v))); // of a bare or a weighted point
  }

  Exact_point_3 weighted_mean(const Vertex_handle preferred, const double additional_weight) const
  {
    std::array<double, 3> sum = { 0, 0, 0 };
    double total_weight = 0;
    for(const Vertex_handle v : m_simplex)
    {
      const double weight = (v == preferred) ? 1 + additional_weight : 1;
      const Exact_point_3 p = point(v);
      for(int i = 0; i < 3; ++i)
        sum[i] += weight * p[i];
      total_weight += weight;
    }
    return Exact_point_3(sum[0] / total_weight, sum[1] / total_weight, sum[2] / total_weight);
  }

  bool makes_positive_cells(const Exact_point_3& p) const
  {
    return std::all_of(m_cells.begin(), m_cells.end(), [&](const Cell_handle c)
    {
      return std::all_of(m_simplex.begin(), m_simplex.end(), [&](const Vertex_handle v)
      {
        return is_positive_with(p, c, v);
      });
    });
  }

  // Is the cell positive with p in the place of its vertex v?
  bool is_positive_with(const Exact_point_3& p, const Cell_handle c, const Vertex_handle v) const
  {
    std::array<Exact_point_3, 4> points;
    for(int i = 0; i < 4; ++i)
      points[i] = (c->vertex(i) == v) ? p : point(c->vertex(i));
    return is_positive_cell(points);
  }

  const Tr& m_tr;
  const Simplex_3<Vertex_handle>& m_simplex;
  const std::vector<Cell_handle>& m_cells;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_POINT_IN_SIMPLEX_3_H
