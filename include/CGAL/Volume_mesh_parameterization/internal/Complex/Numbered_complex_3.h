// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_NUMBERED_COMPLEX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_NUMBERED_COMPLEX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Numbered_vertices_3.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The cells of a complex as plain arrays, and the way back to its vertices.
template <typename C3t3>
class Numbered_complex_3
  : public Numbered_vertices_3<typename C3t3::Vertex_handle>
{
public:
  using Vertex_handle = typename C3t3::Vertex_handle;

  template <typename VertexIsConstrainedMap, typename BoundaryMap>
  Numbered_complex_3(const C3t3& c3t3, const VertexIsConstrainedMap is_constrained, const BoundaryMap target,
                     const bool has_volume_weights = false)
  {
    std::vector<std::array<int, 4> > cells;
    cells.reserve(c3t3.number_of_cells_in_complex());
    this->reserve(c3t3.triangulation().number_of_vertices());
    for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    {
      cells.emplace_back();
      for(int i = 0; i < 4; ++i)
        cells.back()[i] = this->add_vertex(it->vertex(i));
    }

    std::vector<Vertex_handle> on_boundary;
    boundary_vertices(c3t3, std::back_inserter(on_boundary));
    std::vector<bool> is_on_boundary(this->vertices().size(), false);
    for(const Vertex_handle v : on_boundary)
      is_on_boundary[this->number(v)] = true;

    const auto& tr = c3t3.triangulation();
    const auto point = tr.geom_traits().construct_point_3_object(); // of a bare or a weighted point
    this->set_mesh(cells, [&](const Vertex_handle v) { return point(tr.point(v)); }, is_on_boundary, is_constrained,
                   target, has_volume_weights);
  }

  template <typename VertexUVWMap>
  void write(const Eigen::Matrix3Xd& image, VertexUVWMap uvw_map) const
  {
    using Point_3 = typename C3t3::Triangulation::Geom_traits::Point_3;
    for(std::size_t v = 0; v < this->vertices().size(); ++v)
      put(uvw_map, this->vertices()[v], Point_3(image(0, v), image(1, v), image(2, v)));
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_NUMBERED_COMPLEX_3_H
