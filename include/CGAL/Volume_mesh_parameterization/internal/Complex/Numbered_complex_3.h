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

#include <CGAL/Volume_mesh_parameterization/Linear_constraint_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Engine/engine.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

template <typename Point>
Eigen::Vector3d to_vector(const Point& p)
{
  return Eigen::Vector3d(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

// The cells of a complex as plain arrays, and the way back to its vertices.
template <typename C3t3>
class Numbered_complex_3
{
public:
  using Vertex_handle = typename C3t3::Vertex_handle;
  using Cell_handle = typename C3t3::Cell_handle;

  // Prescribes the image of the vertices of the boundary, and of those that `is_constrained` tells,
  // by `target`. The images of the others are 0.
  template <typename VertexIsConstrainedMap, typename BoundaryMap>
  Numbered_complex_3(const C3t3& c3t3, const VertexIsConstrainedMap is_constrained, const BoundaryMap target,
                     const bool has_volume_weights = false)
  {
    m_mesh.has_volume_weights = has_volume_weights;
    std::vector<std::array<int, 4> > cells = number_cells(c3t3);
    const std::vector<bool> is_prescribed = find_prescribed_vertices(c3t3, is_constrained);
    const Eigen::Matrix3Xd points = points_of_vertices(c3t3);
    renumber(cells, points, is_prescribed);
    copy_targets(target);
  }

  const Numbered_mesh_3& mesh() const { return m_mesh; }
  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }
  std::size_t number_of_boundary_vertices() const { return m_number_of_boundary_vertices; }
  int number(const Vertex_handle v) const { return m_numbers.at(v); }

  std::vector<Linear_constraint_3<int> >
  constraints(const std::vector<Linear_constraint_3<Vertex_handle> >& of_handles) const
  {
    std::vector<Linear_constraint_3<int> > result;
    for(const auto& constraint : of_handles)
    {
      result.emplace_back();
      result.back().value = constraint.value;
      for(const auto& term : constraint.terms)
        result.back().terms.push_back({ number(term.vertex), term.coefficient });
    }
    return result;
  }

  template <typename VertexUVWMap>
  void write(const Eigen::Matrix3Xd& image, VertexUVWMap uvw_map) const
  {
    using Point_3 = typename C3t3::Triangulation::Geom_traits::Point_3;
    for(std::size_t v = 0; v < m_vertices.size(); ++v)
      put(uvw_map, m_vertices[v], Point_3(image(0, v), image(1, v), image(2, v)));
  }

private:
  // Vertices that belong to no cell of the complex receive no number.
  std::vector<std::array<int, 4> > number_cells(const C3t3& c3t3)
  {
    std::vector<std::array<int, 4> > cells;
    cells.reserve(c3t3.number_of_cells_in_complex());
    m_numbers.reserve(c3t3.triangulation().number_of_vertices());
    for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    {
      std::array<int, 4> cell;
      for(int i = 0; i < 4; ++i)
      {
        const auto inserted = m_numbers.emplace(it->vertex(i), static_cast<int>(m_vertices.size()));
        if(inserted.second)
          m_vertices.push_back(it->vertex(i));
        cell[i] = inserted.first->second;
      }
      cells.push_back(cell);
    }
    return cells;
  }

  template <typename VertexIsConstrainedMap>
  std::vector<bool> find_prescribed_vertices(const C3t3& c3t3, const VertexIsConstrainedMap is_constrained)
  {
    std::vector<bool> is_prescribed(m_vertices.size(), false);
    for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    {
      const Cell_handle c = it;
      for(int i = 0; i < 4; ++i)
        if(!c3t3.is_in_complex(c->neighbor(i)))
          for(int k = 1; k < 4; ++k)
            is_prescribed[m_numbers.at(c->vertex((i + k) % 4))] = true;
    }
    m_number_of_boundary_vertices = std::count(is_prescribed.begin(), is_prescribed.end(), true);
    for(std::size_t v = 0; v < m_vertices.size(); ++v)
      if(get(is_constrained, m_vertices[v]))
        is_prescribed[v] = true;
    return is_prescribed;
  }

  Eigen::Matrix3Xd points_of_vertices(const C3t3& c3t3) const
  {
    const auto& tr = c3t3.triangulation();
    const auto point = tr.geom_traits().construct_point_3_object(); // of a bare or a weighted point
    Eigen::Matrix3Xd points(3, m_vertices.size());
    for(std::size_t v = 0; v < m_vertices.size(); ++v)
      points.col(v) = to_vector(point(tr.point(m_vertices[v])));
    return points;
  }

  // Once and for all: all arrays have this order from now on.
  void renumber(const std::vector<std::array<int, 4> >& cells, const Eigen::Matrix3Xd& points,
                const std::vector<bool>& is_prescribed)
  {
    const std::vector<std::size_t> order = engine::set_numbered_mesh(cells, points, is_prescribed, m_mesh);
    std::vector<int> places(order.size());
    std::vector<Vertex_handle> vertices(order.size());
    for(std::size_t i = 0; i < order.size(); ++i)
    {
      places[order[i]] = static_cast<int>(i);
      vertices[i] = m_vertices[order[i]];
    }
    m_vertices.swap(vertices);
    for(auto& vertex_and_number : m_numbers)
      vertex_and_number.second = places[vertex_and_number.second];
  }

  template <typename BoundaryMap>
  void copy_targets(const BoundaryMap target)
  {
    m_mesh.target.setZero(3, m_mesh.number_of_vertices());
    for(int v = m_mesh.number_of_free_vertices; v < m_mesh.number_of_vertices(); ++v)
      m_mesh.target.col(v) = to_vector(get(target, m_vertices[v]));
  }

  Numbered_mesh_3 m_mesh;
  std::vector<Vertex_handle> m_vertices;
  std::unordered_map<Vertex_handle, int> m_numbers;
  std::size_t m_number_of_boundary_vertices = 0;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_NUMBERED_COMPLEX_3_H
