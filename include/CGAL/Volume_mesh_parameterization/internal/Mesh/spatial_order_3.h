// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_SPATIAL_ORDER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_SPATIAL_ORDER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// An order of the vertices, the free ones first, in which neighbors in space are neighbors in memory.
inline std::vector<std::size_t> spatial_order_3(const Numbered_mesh_3& mesh)
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> points;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    points.emplace_back(mesh.source(0, v), mesh.source(1, v), mesh.source(2, v));

  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  using Point_map = CGAL::Pointer_property_map<Kernel::Point_3>::type;
  const CGAL::Spatial_sort_traits_adapter_3<Kernel, Point_map> traits(CGAL::make_property_map(points));
  CGAL::hilbert_sort(order.begin(), order.begin() + mesh.number_of_free_vertices, traits);
  return order;
}

// The columns in the given order, and back.
inline Eigen::Matrix3Xd reordered(const Eigen::Matrix3Xd& columns, const std::vector<std::size_t>& order)
{
  Eigen::Matrix3Xd result(3, columns.cols());
  for(std::size_t i = 0; i < order.size(); ++i)
    result.col(i) = columns.col(order[i]);
  return result;
}

inline Eigen::Matrix3Xd in_original_order(const Eigen::Matrix3Xd& columns, const std::vector<std::size_t>& order)
{
  Eigen::Matrix3Xd result(3, columns.cols());
  for(std::size_t i = 0; i < order.size(); ++i)
    result.col(order[i]) = columns.col(i);
  return result;
}

// The mesh with its vertices in the given order, and its cells by their first vertex.
inline Numbered_mesh_3 reordered(const Numbered_mesh_3& mesh, const std::vector<std::size_t>& order)
{
  std::vector<int> number(order.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    number[order[i]] = static_cast<int>(i);
  Numbered_mesh_3 result = { reordered(mesh.source, order), reordered(mesh.target, order), mesh.cells,
                             mesh.number_of_free_vertices, mesh.has_volume_weights };
  for(std::array<int, 4>& cell : result.cells)
    for(int& v : cell)
      v = number[v];
  std::stable_sort(result.cells.begin(), result.cells.end(), [](const auto& a, const auto& b)
  {
    return *std::min_element(a.begin(), a.end()) < *std::min_element(b.begin(), b.end());
  });
  return result;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_SPATIAL_ORDER_3_H
