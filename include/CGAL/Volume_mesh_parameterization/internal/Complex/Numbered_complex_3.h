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

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <CGAL/number_utils.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

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
  Numbered_complex_3(const C3t3& c3t3, const VertexIsConstrainedMap is_constrained, const BoundaryMap target)
  {
    number_cells(c3t3);
    find_prescribed_vertices(c3t3, is_constrained);
    move_free_vertices_to_front();
    copy_points(c3t3, target);
  }

  const Numbered_mesh_3& mesh() const { return m_mesh; }
  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }
  std::size_t number_of_boundary_vertices() const { return m_number_of_boundary_vertices; }
  int number(const Vertex_handle v) const { return m_numbers.at(v); }

private:
  // Vertices that belong to no cell of the complex receive no number.
  void number_cells(const C3t3& c3t3)
  {
    m_mesh.cells.reserve(c3t3.number_of_cells_in_complex());
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
      m_mesh.cells.push_back(cell);
    }
  }

  template <typename VertexIsConstrainedMap>
  void find_prescribed_vertices(const C3t3& c3t3, const VertexIsConstrainedMap is_constrained)
  {
    m_is_prescribed.assign(m_vertices.size(), false);
    for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    {
      const Cell_handle c = it;
      for(int i = 0; i < 4; ++i)
        if(!c3t3.is_in_complex(c->neighbor(i)))
          for(int k = 1; k < 4; ++k)
            m_is_prescribed[m_numbers.at(c->vertex((i + k) % 4))] = true;
    }
    m_number_of_boundary_vertices = std::count(m_is_prescribed.begin(), m_is_prescribed.end(), true);
    for(std::size_t v = 0; v < m_vertices.size(); ++v)
      if(get(is_constrained, m_vertices[v]))
        m_is_prescribed[v] = true;
  }

  void move_free_vertices_to_front()
  {
    std::vector<int> order;
    for(const bool prescribed : {false, true})
      for(std::size_t v = 0; v < m_vertices.size(); ++v)
        if(m_is_prescribed[v] == prescribed)
          order.push_back(static_cast<int>(v));
    m_mesh.number_of_free_vertices
      = static_cast<int>(std::count(m_is_prescribed.begin(), m_is_prescribed.end(), false));

    std::vector<int> number(order.size());
    std::vector<Vertex_handle> vertices(order.size());
    for(std::size_t i = 0; i < order.size(); ++i)
    {
      number[order[i]] = static_cast<int>(i);
      vertices[i] = m_vertices[order[i]];
    }
    m_vertices.swap(vertices);
    for(std::array<int, 4>& cell : m_mesh.cells)
      for(int& v : cell)
        v = number[v];
    for(auto& vertex_and_number : m_numbers)
      vertex_and_number.second = number[vertex_and_number.second];
  }

  template <typename BoundaryMap>
  void copy_points(const C3t3& c3t3, const BoundaryMap target)
  {
    const auto& tr = c3t3.triangulation();
    const auto point = tr.geom_traits().construct_point_3_object(); // of a bare or a weighted point
    const Eigen::Index n = static_cast<Eigen::Index>(m_vertices.size());
    m_mesh.source.resize(3, n);
    m_mesh.target.setZero(3, n);
    for(Eigen::Index v = 0; v < n; ++v)
    {
      m_mesh.source.col(v) = to_vector(point(tr.point(m_vertices[v])));
      if(!m_mesh.is_free(static_cast<int>(v)))
        m_mesh.target.col(v) = to_vector(get(target, m_vertices[v]));
    }
  }

  Numbered_mesh_3 m_mesh;
  std::vector<Vertex_handle> m_vertices;
  std::unordered_map<Vertex_handle, int> m_numbers;
  std::vector<bool> m_is_prescribed;
  std::size_t m_number_of_boundary_vertices = 0;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_NUMBERED_COMPLEX_3_H
