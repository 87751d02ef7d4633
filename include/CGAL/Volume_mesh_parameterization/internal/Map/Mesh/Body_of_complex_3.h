// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_OF_COMPLEX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_OF_COMPLEX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>

#include <boost/type_traits/is_detected.hpp>

#include <unordered_map>

namespace CGAL::Volume_mesh_parameterization::internal {

template <typename C3t3>
using Edges_of_complex = decltype(std::declval<const C3t3&>().edges_in_complex_begin());

// No function of the concept: the number of feature edges, which saves a traversal of all edges.
template <typename C3t3>
using Number_of_edges = decltype(std::declval<const C3t3&>().number_of_edges_in_complex());

template <typename C3t3>
bool may_have_edges(const C3t3& c3t3)
{
  if constexpr(boost::is_detected<Number_of_edges, C3t3>::value)
    return c3t3.number_of_edges_in_complex() > 0;
  return true;
}

template <typename C3t3>
using Corners_of_complex = decltype(std::declval<const C3t3&>().vertices_in_complex_begin());

// The body of a complex, whose 1-dimensional features are its marked edges, and the way back.
template <typename C3t3>
struct Body_of_complex_3 : Body_3
{
  static_assert(Is_complex<C3t3>::value, "c3t3 must be a complex: a triangulation has no subset of cells.");
  static_assert(!is_periodic<typename C3t3::Triangulation>,
                "c3t3 must not be periodic: a vertex of a periodic triangulation has several points, and so several images.");
  using Vertex_handle = typename C3t3::Vertex_handle;

  std::vector<Vertex_handle> vertices; // of each point
  std::vector<typename C3t3::Cell_handle> cells_of_complex;
  std::vector<int> curves;          // of the marked edges: their indices if these are integers, otherwise 1
  std::vector<std::size_t> corners; // points of 0-dimensional features

  explicit Body_of_complex_3(const C3t3& c3t3)
  {
    point_type = coordinate_type<Coordinate_of<typename C3t3::Triangulation::Geom_traits::Point_3> >();
    Indices indices;
    indices.reserve(c3t3.triangulation().number_of_vertices());
    for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    {
      cells_of_complex.push_back(it);
      cells.emplace_back();
      for(int i = 0; i < 4; ++i)
      {
        const Vertex_handle v = it->vertex(i);
        const auto [entry, is_new] = indices.emplace(v, vertices.size());
        cells.back()[i] = entry->second;
        if(is_new)
        {
          vertices.push_back(v);
          points.push_back(coordinates(point_of_vertex(c3t3.triangulation(), v)));
        }
        if(!c3t3.is_in_complex(it->neighbor(i)))
          sides.push_back(4 * (cells.size() - 1) + i);
      }
    }
    mark_edges(c3t3, indices);
    mark_corners(c3t3, indices);
    boundary = facets_of_sides(cells, sides);
  }

private:
  using Indices = std::unordered_map<Vertex_handle, std::size_t>; // of the points of vertices

  void mark_edges(const C3t3& c3t3, const Indices& indices)
  {
    if constexpr(boost::is_detected<Edges_of_complex, C3t3>::value)
      if(may_have_edges(c3t3))
        for(auto it = c3t3.edges_in_complex_begin(); it != c3t3.edges_in_complex_end(); ++it)
        {
          const auto v = indices.find(it->first->vertex(it->second)), w = indices.find(it->first->vertex(it->third));
          if(v == indices.end() || w == indices.end())
            continue;
          edges.push_back({ v->second, w->second });
          if constexpr(std::is_integral<typename C3t3::Curve_index>::value)
            curves.push_back(static_cast<int>(c3t3.curve_index(*it)));
          else
            curves.push_back(1);
        }
  }

  void mark_corners(const C3t3& c3t3, const Indices& indices)
  {
    if constexpr(boost::is_detected<Corners_of_complex, C3t3>::value)
    {
      std::vector<bool> is_corner(points.size(), false); // the complex has corners in the order of their addresses
      for(auto it = c3t3.vertices_in_complex_begin(); it != c3t3.vertices_in_complex_end(); ++it)
        if(const auto v = indices.find(it); v != indices.end())
          is_corner[v->second] = true;
      for(std::size_t v = 0; v < is_corner.size(); ++v)
        if(is_corner[v])
          corners.push_back(v);
    }
  }
};

// Returns the points that a property map has for vertices, in the order of the vertices.
template <typename Vertex_handle, typename VertexPointMap>
std::vector<std::array<double, 3> > points_of(const std::vector<Vertex_handle>& vertices, const VertexPointMap& map)
{
  static_assert(Is_map_of<VertexPointMap, Vertex_handle>::value,
                "uvw_map must be a property map of vertices: for a container, pass make_vertex_point_map(container).");
  std::vector<std::array<double, 3> > result;
  result.reserve(vertices.size());
  for(const Vertex_handle v : vertices)
    result.push_back(coordinates(get(map, v)));
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_OF_COMPLEX_3_H
