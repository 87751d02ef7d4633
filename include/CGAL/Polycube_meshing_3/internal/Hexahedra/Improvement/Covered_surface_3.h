// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_COVERED_SURFACE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_COVERED_SURFACE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/AABB_trees_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

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
  AABB_trees_3::Triangles triangles_in_space;
  for(const std::array<int, 3>& triangle : triangles)
    triangles_in_space.push_back(triangle_at(positions, triangle));
  AABB_trees_3::Of_triangles tree(triangles_in_space.cbegin(), triangles_in_space.cend());
  tree.accelerate_distance_queries();
  for(const Eigen::Vector3d& p : points)
  {
    const auto& [nearest, primitive] = tree.closest_point_and_primitive(exact_point(p));
    f(p, to_vector(nearest), triangles[primitive - triangles_in_space.cbegin()]);
  }
}

// Surface, and two triangles of each quadrangle that covers it. Those farther away than the tolerance, relative to the mean edge,
// are pulled.
struct Covered_surface_3
{
  const Body_surface_3* surface;
  Triangles_of_boundary triangles;
  double tolerance;
};

// Returns a surface with triangles whose vertices have new numbers.
inline Covered_surface_3 covered_surface_3(const Body_surface_3& surface,
                                           const std::vector<std::array<std::size_t, 4> >& quadrangles,
                                           const std::vector<int>& numbers, const double tolerance)
{
  Covered_surface_3 result = { &surface, {}, tolerance };
  for(const std::array<std::size_t, 4>& q : quadrangles)
    for(const std::size_t k : { 1, 2 })
      result.triangles.push_back({ numbers[q[0]], numbers[q[k]], numbers[q[k + 1]] });
  return result;
}

// Middle of an edge of triangles that cover a surface, and the nearest point there: a quadrangle that spans a valley has its
// middle far away.
struct Middle_3
{
  Eigen::Vector3d point, nearest;

  Middle_3(const Body_surface_3& surface, const Matrix3Xd& positions, const std::array<int, 2>& edge)
    : point((positions.col(edge[0]) + positions.col(edge[1])) / 2), nearest(surface.nearest(point, Freedom_3::SURFACE))
  {}

  double distance() const { return (point - nearest).norm(); }
};

// Calls `f` with each edge of the triangles, its middle, and the triangle.
template <typename Function>
void for_each_middle(const Covered_surface_3& covered, const Matrix3Xd& positions, const Function& f)
{
  for(const std::array<int, 3>& triangle : covered.triangles)
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::array<int, 2> edge = { triangle[i], triangle[(i + 1) % 3] };
      f(edge, Middle_3(*covered.surface, positions, edge), triangle);
    }
}

// The largest one of distances, and where it is.
struct Largest_distance_3
{
  double distance = 0;
  Eigen::Vector3d point;

  void take(const Eigen::Vector3d& p, const Eigen::Vector3d& q)
  {
    if((p - q).norm() > distance)
    {
      distance = (p - q).norm();
      point = p;
    }
  }
};

// Returns the largest distance between a surface and the quadrangles that cover it.
inline Largest_distance_3 distance_of_cover_3(const Covered_surface_3& covered, const Matrix3Xd& positions)
{
  Largest_distance_3 result;
  std::vector<int> vertices;
  for(const std::array<int, 3>& triangle : covered.triangles)
    vertices.insert(vertices.end(), triangle.begin(), triangle.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for(const int v : vertices)
    result.take(positions.col(v), covered.surface->nearest(positions.col(v), Freedom_3::SURFACE));
  for_each_nearest(covered.surface->vertices(), covered.triangles, positions,
                   [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const std::array<int, 3>&) { result.take(p, q); });
  for_each_middle(covered, positions, [&](const std::array<int, 2>&, const Middle_3& middle, const std::array<int, 3>&)
                  { result.take(middle.point, middle.nearest); });
  return result;
}

inline Matrix3Xd columns_of(const std::vector<Eigen::Vector3d>& points)
{
  Matrix3Xd result(3, points.size());
  for(std::size_t v = 0; v < points.size(); ++v)
    result.col(v) = points[v];
  return result;
}

// Returns the largest distance between the surface of a body and the boundary of hexahedra.
inline Largest_distance_3 boundary_distance_3(const Body_surface_3& surface, const Hexahedra_3& mesh)
{
  std::vector<int> numbers(mesh.points.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return distance_of_cover_3(covered_surface_3(surface, mesh.facets, numbers, 0), columns_of(mesh.points));
}

// Triangles around a vertex, the points that are nearest to one of the triangles, and edges of them whose middles are far away.
struct Cover_of_vertex_3
{
  Triangles_of_boundary triangles;
  std::vector<Eigen::Vector3d> points;
  std::vector<std::pair<const Body_surface_3*, std::array<int, 2> > > far_edges;
};

// Adds what covers a surface to the vertices; edges are far away beyond a tolerance.
inline void add_covers_3(const Covered_surface_3& covered, const Matrix3Xd& positions, const double tolerance,
                         std::vector<Cover_of_vertex_3>& covers)
{
  for(const std::array<int, 3>& triangle : covered.triangles)
    for(const int v : triangle)
      covers[v].triangles.push_back(triangle);
  for_each_nearest(covered.surface->vertices(), covered.triangles, positions,
                   [&](const Eigen::Vector3d& p, const Eigen::Vector3d&, const std::array<int, 3>& triangle)
  {
    for(const int v : triangle)
      covers[v].points.push_back(p);
  });
  for_each_middle(covered, positions, [&](const std::array<int, 2>& edge, const Middle_3& middle, const std::array<int, 3>&)
  {
    if(middle.distance() > tolerance)
      for(const int v : edge)
        covers[v].far_edges.push_back({ covered.surface, edge });
  });
}

// Returns the sum of the squares of the distances of points from the triangles, and of middles from the surface, as far as they
// exceed a tolerance.
inline double uncovered(const Matrix3Xd& positions, const Cover_of_vertex_3& cover, const double tolerance)
{
  double sum = 0;
  for(const Eigen::Vector3d& p : cover.points)
  {
    double least = (std::numeric_limits<double>::infinity)();
    for(auto triangle = cover.triangles.begin(); triangle != cover.triangles.end() && least > tolerance; ++triangle)
      least = (std::min)(least, std::sqrt(squared_distance(exact_point(p), triangle_at(positions, *triangle))));
    sum += std::pow((std::max)(0., least - tolerance), 2);
  }
  for(const auto& [surface, edge] : cover.far_edges)
    sum += std::pow((std::max)(0., Middle_3(*surface, positions, edge).distance() - tolerance), 2);
  return sum;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_COVERED_SURFACE_3_H
