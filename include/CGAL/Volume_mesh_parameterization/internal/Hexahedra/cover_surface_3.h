// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_COVER_SURFACE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_COVER_SURFACE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

using Triangles_of_boundary = std::vector<std::array<int, 3> >; // triangles of hexahedra on the boundary

inline Exact_predicates_inexact_constructions_kernel::Triangle_3 triangle_at(const Matrix3Xd& positions,
                                                                             const std::array<int, 3>& triangle)
{
  const auto& [a, b, c] = triangle;
  return { exact_point(positions.col(a)), exact_point(positions.col(b)), exact_point(positions.col(c)) };
}

// Calls `f` with each point, the nearest point of the triangles, and the triangle of the latter.
template <typename Function>
void for_each_nearest(const std::vector<Eigen::Vector3d>& points, const Triangles_of_boundary& triangles,
                      const Matrix3Xd& positions, const Function& f)
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Triangle_3> triangles_in_space;
  for(const std::array<int, 3>& triangle : triangles)
    triangles_in_space.push_back(triangle_at(positions, triangle));
  using Primitive = AABB_triangle_primitive<Kernel, std::vector<Kernel::Triangle_3>::const_iterator>;
  AABB_tree<AABB_traits<Kernel, Primitive> > tree(triangles_in_space.cbegin(), triangles_in_space.cend());
  tree.accelerate_distance_queries();
  for(const Eigen::Vector3d& p : points)
  {
    const auto& [nearest, primitive] = tree.closest_point_and_primitive(exact_point(p));
    f(p, to_vector(nearest), triangles[primitive - triangles_in_space.cbegin()]);
  }
}

// Triangles around a vertex, and the points that are nearest to one of the triangles.
struct Cover_of_vertex_3
{
  Triangles_of_boundary triangles;
  std::vector<Eigen::Vector3d> points;
};

inline void add_covers_3(const std::vector<Eigen::Vector3d>& points, const Triangles_of_boundary& triangles,
                         const Matrix3Xd& positions, std::vector<Cover_of_vertex_3>& covers)
{
  for(const std::array<int, 3>& triangle : triangles)
    for(const int v : triangle)
      covers[v].triangles.push_back(triangle);
  for_each_nearest(points, triangles, positions,
                   [&](const Eigen::Vector3d& p, const Eigen::Vector3d&, const std::array<int, 3>& triangle)
  {
    for(const int v : triangle)
      covers[v].points.push_back(p);
  });
}

// Returns the sum of the squares of the distances of points from the triangles, as far as they exceed a tolerance.
inline double uncovered(const Matrix3Xd& positions, const Cover_of_vertex_3& cover, const double tolerance)
{
  double sum = 0;
  for(const Eigen::Vector3d& p : cover.points)
  {
    double least = (std::numeric_limits<double>::infinity)();
    for(const std::array<int, 3>& triangle : cover.triangles)
      least = (std::min)(least, squared_distance(exact_point(p), triangle_at(positions, triangle)));
    sum += std::pow((std::max)(0., std::sqrt(least) - tolerance), 2);
  }
  return sum;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_COVER_SURFACE_3_H
