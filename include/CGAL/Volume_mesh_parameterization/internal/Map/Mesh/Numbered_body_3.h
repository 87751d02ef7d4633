// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_NUMBERED_BODY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_NUMBERED_BODY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/spatial_order_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The mesh that the engine takes of a body. A point without a cell is no vertex of it.
struct Numbered_body_3
{
  Numbered_mesh_3 mesh;
  std::vector<std::size_t> points; // of each vertex
  std::vector<int> vertices;       // of each point, or -1

  // Vertices with a target that is not among the prescribed ones are free.
  Numbered_body_3(const Tetrahedron_soup_3& soup, const std::vector<bool>& is_point_prescribed,
                  const std::vector<std::array<double, 3> >& targets, const bool has_volume_weights = false,
                  const bool is_parallel = false)
    : vertices(soup.points.size(), -1)
  {
    for(const std::array<std::size_t, 4>& cell : soup.cells)
      for(const std::size_t p : cell)
        if(vertices[p] == -1)
        {
          vertices[p] = static_cast<int>(points.size());
          points.push_back(p);
        }
    const auto cells = values_of_indices(is_parallel, soup.cells.size(), [&](const std::size_t c) -> std::array<int, 4>
    {
      const auto& [p, q, r, s] = soup.cells[c];
      return { vertices[p], vertices[q], vertices[r], vertices[s] };
    });
    std::vector<bool> is_prescribed;
    for(const std::size_t p : points)
      is_prescribed.push_back(is_point_prescribed[p]);

    mesh.has_volume_weights = has_volume_weights;
    mesh.is_parallel = is_parallel;
    const std::vector<std::size_t> order = set_numbered_mesh(cells, columns(soup.points), is_prescribed, mesh);
    const std::vector<std::size_t> points_before = points;
    for(std::size_t v = 0; v < order.size(); ++v)
    {
      points[v] = points_before[order[v]];
      vertices[points[v]] = static_cast<int>(v);
    }
    mesh.target = columns(targets);
    set_base_point(mesh);
  }

  // The columns of the vertices of an array over the points.
  Matrix3Xd columns(const std::vector<std::array<double, 3> >& of_points) const
  {
    constexpr int vertices_per_range = 4096;
    Matrix3Xd result(3, points.size());
    for_each_in_ranges(mesh.is_parallel, points.size(), vertices_per_range,
                       [&](const std::size_t v) { result.col(v) = to_vector(of_points[points[v]]); });
    return result;
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_NUMBERED_BODY_3_H
