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
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Compressed_rows.h>

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <tuple>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

constexpr int vertices_per_range = 4096; // a guess; of an array that threads share

// Sorts indices of points such that neighbors in space follow each other.
template <typename ConcurrencyTag, typename Iterator>
void sort_in_space(const Iterator begin, const Iterator end, const std::vector<Exact_point_3>& points)
{
  using Point_map = Pointer_property_map<Exact_point_3>::const_type;
  using Traits = Spatial_sort_traits_adapter_3<Exact_predicates_inexact_constructions_kernel, Point_map>;
  hilbert_sort<ConcurrencyTag>(begin, end, Traits(make_property_map(points.data())));
}

// An order of the vertices, the free ones first, in which neighbors in space are neighbors in memory: of the free ones
// only, the others keep their order.
inline std::vector<std::size_t> spatial_order_3(const Matrix3Xd& source, const std::vector<bool>& is_prescribed,
                                                const bool is_parallel = false)
{
  const std::vector<Exact_point_3> points
    = values_of_indices(is_parallel, source.cols(), [&](const std::size_t v) { return exact_point(source.col(v)); });

  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto end_of_free
    = std::stable_partition(order.begin(), order.end(), [&](const std::size_t v) { return !is_prescribed[v]; });
#ifdef CGAL_LINKED_WITH_TBB
  if(is_parallel)
  {
    sort_in_space<Parallel_tag>(order.begin(), end_of_free, points);
    return order;
  }
#endif
  static_cast<void>(is_parallel);
  sort_in_space<Sequential_tag>(order.begin(), end_of_free, points);
  return order;
}

// Returns the place of each vertex in an order, which lists the vertices from place to place.
inline std::vector<int> inverse_order(const std::vector<std::size_t>& order)
{
  std::vector<int> indices(order.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    indices[order[i]] = static_cast<int>(i);
  return indices;
}

// The cells with their vertices renumbered, in the order of their first vertices; `user_numbers` receives their old indices.
inline std::vector<std::array<int, 4> > renumbered_cells(const std::vector<std::array<int, 4> >& cells,
                                                         const std::vector<int>& new_numbers,
                                                         std::vector<std::size_t>& user_numbers, const bool is_parallel)
{
  const Compressed_rows<std::size_t> rows(new_numbers.size(), cells.size(), [&](const std::size_t c, const auto& f)
  {
    const auto& [i, j, k, l] = cells[c];
    f((std::min)({ new_numbers[i], new_numbers[j], new_numbers[k], new_numbers[l] }));
  }, is_parallel);
  user_numbers = values_of_indices(is_parallel, cells.size(), [&](const std::size_t i) { return rows.items[i]; });
  return values_of_indices(is_parallel, cells.size(), [&](const std::size_t i)
  {
    std::array<int, 4> cell = cells[user_numbers[i]];
    for(int& v : cell)
      v = new_numbers[v];
    return cell;
  });
}

// Returns a mesh with vertices and cells in the order of all that follows: free vertices first, neighbors in space are
// neighbors in memory; and the old number of each vertex.
inline std::pair<Numbered_mesh_3, std::vector<std::size_t> >
ordered_mesh_3(const std::vector<std::array<int, 4> >& cells, const Matrix3Xd& points, const std::vector<bool>& is_prescribed,
               const bool is_parallel = false)
{
  std::vector<std::size_t> order = spatial_order_3(points, is_prescribed, is_parallel);
  std::vector<std::size_t> user_numbers;
  std::vector<std::array<int, 4> > ordered_cells = renumbered_cells(cells, inverse_order(order), user_numbers, is_parallel);
  Matrix3Xd source(3, points.cols());
  for_each_in_ranges(is_parallel, order.size(), vertices_per_range,
                     [&](const std::size_t i) { source.col(i) = points.col(order[i]); });
  Numbered_mesh_3 mesh(std::move(source), std::move(ordered_cells),
                       static_cast<int>(std::count(is_prescribed.begin(), is_prescribed.end(), false)));
  mesh.user_numbers = std::move(user_numbers);
  mesh.is_parallel = is_parallel;
  return { std::move(mesh), std::move(order) };
}

// The mesh that the engine takes of a body. A point without a cell is no vertex of it.
struct Numbered_body_3
{
  Numbered_mesh_3 mesh;
  std::vector<std::size_t> points; // of each vertex
  std::vector<int> vertices;       // of each point, or -1

  // Vertices with a target that is not among the prescribed ones are free.
  Numbered_body_3(const Body_3& body, const std::vector<bool>& is_point_prescribed,
                  const std::vector<std::array<double, 3> >& targets, const bool has_volume_weights = false,
                  const bool is_parallel = false)
  {
    Numbered_points numbered(body.cells, body.points.size());
    points = std::move(numbered.points);
    vertices = std::move(numbered.numbers);
    const auto cells = values_of_indices(is_parallel, body.cells.size(), [&](const std::size_t c) -> std::array<int, 4>
    {
      const auto& [p, q, r, s] = body.cells[c];
      return { vertices[p], vertices[q], vertices[r], vertices[s] };
    });
    std::vector<bool> is_prescribed;
    for(const std::size_t p : points)
      is_prescribed.push_back(is_point_prescribed[p]);

    std::vector<std::size_t> order;
    mesh.is_parallel = is_parallel;
    std::tie(mesh, order) = ordered_mesh_3(cells, columns(body.points), is_prescribed, is_parallel);
    mesh.has_volume_weights = has_volume_weights;
    const std::vector<std::size_t> points_before = points;
    for(std::size_t v = 0; v < order.size(); ++v)
    {
      points[v] = points_before[order[v]];
      vertices[points[v]] = static_cast<int>(v);
    }
    for(const auto& [p, q] : body.edges)
      if(vertices[p] >= 0 && vertices[q] >= 0)
        mesh.marked_edges.push_back({ vertices[p], vertices[q] });
    set_targets(mesh, columns(targets));
  }

  // The columns of the vertices of an array over the points.
  Matrix3Xd columns(const std::vector<std::array<double, 3> >& of_points) const
  {
    Matrix3Xd result(3, points.size());
    for_each_in_ranges(mesh.is_parallel, points.size(), vertices_per_range,
                       [&](const std::size_t v) { result.col(v) = to_vector(of_points[points[v]]); });
    return result;
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_NUMBERED_BODY_3_H
