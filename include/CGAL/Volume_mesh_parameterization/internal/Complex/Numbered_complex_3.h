// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_NUMBERED_COMPLEX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_NUMBERED_COMPLEX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Engine/engine.h>

#include <unordered_map>

namespace CGAL::Volume_mesh_parameterization::internal {

// The arrays of a mesh, and which of its vertices, a handle or an index, has which number in them. Only vertices of
// cells have one. The base of those classes that know where the cells come from.
template <typename Vertex>
class Numbered_vertices_3
{
public:
  const Numbered_mesh_3& mesh() const { return m_mesh; }
  const std::vector<Vertex>& vertices() const { return m_vertices; }
  std::size_t number_of_boundary_vertices() const { return m_number_of_boundary_vertices; }
  int number(const Vertex& v) const { return m_numbers.at(v); }

  // Takes the image of each vertex from which the search is to start.
  template <typename ImageOfVertex>
  void set_initial(const ImageOfVertex& image_of)
  {
    m_mesh.initial.resize(3, m_mesh.number_of_vertices());
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      m_mesh.initial.col(v) = image_of(m_vertices[v]);
  }

  std::vector<Linear_constraint_3<int> > constraints(const std::vector<Linear_constraint_3<Vertex> >& of_vertices) const
  {
    std::vector<Linear_constraint_3<int> > result;
    for(const auto& constraint : of_vertices)
    {
      result.emplace_back();
      result.back().value = constraint.value;
      for(const auto& term : constraint.terms)
        result.back().terms.push_back({ number(term.vertex), term.coefficient });
    }
    return result;
  }

protected:
  void reserve(const std::size_t number_of_vertices) { m_numbers.reserve(number_of_vertices); }

  // The number of a vertex of a cell, the next one if it has none yet; to be called before `set_mesh()`.
  int add_vertex(const Vertex& v)
  {
    const auto inserted = m_numbers.emplace(v, static_cast<int>(m_vertices.size()));
    if(inserted.second)
      m_vertices.push_back(v);
    return inserted.first->second;
  }

  // Prescribes the image of the vertices of the boundary, and of those that `is_constrained` tells, by `target`.
  template <typename PointOfVertex, typename VertexIsConstrainedMap, typename BoundaryMap>
  void set_mesh(const std::vector<std::array<int, 4> >& cells, const PointOfVertex& point_of,
                std::vector<bool> is_prescribed, const VertexIsConstrainedMap& is_constrained,
                const BoundaryMap& target, const bool has_volume_weights)
  {
    m_number_of_boundary_vertices = std::count(is_prescribed.begin(), is_prescribed.end(), true);
    Eigen::Matrix3Xd points(3, m_vertices.size());
    for(std::size_t v = 0; v < m_vertices.size(); ++v)
    {
      points.col(v) = to_vector(point_of(m_vertices[v]));
      if(get(is_constrained, m_vertices[v]))
        is_prescribed[v] = true;
    }
    m_mesh.has_volume_weights = has_volume_weights;
    renumber(set_numbered_mesh(cells, points, is_prescribed, m_mesh));

    m_mesh.target.resize(3, m_mesh.number_of_vertices());
    for(int v = m_mesh.number_of_free_vertices; v < m_mesh.number_of_vertices(); ++v)
      m_mesh.target.col(v) = to_vector(get(target, m_vertices[v]));
    set_base_point(m_mesh);
  }

private:
  // Once and for all: all arrays have this order from now on.
  void renumber(const std::vector<std::size_t>& order)
  {
    std::vector<int> places(order.size());
    std::vector<Vertex> vertices(order.size());
    for(std::size_t i = 0; i < order.size(); ++i)
    {
      places[order[i]] = static_cast<int>(i);
      vertices[i] = m_vertices[order[i]];
    }
    m_vertices.swap(vertices);
    for(auto& vertex_and_number : m_numbers)
      vertex_and_number.second = places[vertex_and_number.second];
  }

  Numbered_mesh_3 m_mesh;
  std::vector<Vertex> m_vertices;
  std::unordered_map<Vertex, int> m_numbers;
  std::size_t m_number_of_boundary_vertices = 0;
};

// The cells of a complex as plain arrays, and the way back to its vertices.
template <typename C3t3>
class Numbered_complex_3 : public Numbered_vertices_3<typename C3t3::Vertex_handle>
{
public:
  using Vertex_handle = typename C3t3::Vertex_handle;

  template <typename VertexIsConstrainedMap, typename BoundaryMap>
  Numbered_complex_3(const C3t3& c3t3, const VertexIsConstrainedMap is_constrained, const BoundaryMap target,
                     const bool has_volume_weights = false)
  {
    const auto& tr = c3t3.triangulation();
    std::vector<std::array<int, 4> > cells;
    cells.reserve(c3t3.number_of_cells_in_complex());
    this->reserve(tr.number_of_vertices());
    std::vector<bool> is_on_boundary;
    for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    {
      cells.emplace_back();
      for(int i = 0; i < 4; ++i)
        cells.back()[i] = this->add_vertex(it->vertex(i));
      is_on_boundary.resize(this->vertices().size(), false);
      for(int i = 0; i < 4; ++i)
        if(!c3t3.is_in_complex(it->neighbor(i)))
          for(int k = 1; k < 4; ++k)
            is_on_boundary[cells.back()[(i + k) % 4]] = true;
    }
    this->set_mesh(cells, [&](const Vertex_handle v) { return point_of_vertex(tr, v); }, is_on_boundary, is_constrained,
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
