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

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/Positions_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/AABB_trees_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

using Edge_of_triangle_3 = std::array<std::size_t, 2>;

// Calls `f` with each point, the nearest point of the triangles, and the triangle of the latter. Takes positions of vertices.
template <typename Function>
void for_each_nearest(const std::vector<Vector_3>& points, const std::vector<Triangle_3>& triangles,
                      const std::vector<Vector_3>& positions, const Function& f)
{
  AABB_trees_3::Triangles triangles_in_space;
  for(const Triangle_3& triangle : triangles)
    triangles_in_space.push_back(triangle_of(positions, triangle));
  AABB_trees_3::Of_triangles tree(triangles_in_space.cbegin(), triangles_in_space.cend());
  tree.accelerate_distance_queries();
  for(const Vector_3& p : points)
  {
    const auto& [nearest, primitive] = tree.closest_point_and_primitive(exact_point(p));
    f(p, to_vector(nearest), triangles[primitive - triangles_in_space.cbegin()]);
  }
}

// Middle of an edge of triangles that cover a surface, and the nearest point there: a quadrangle that spans a valley has its
// middle far away.
struct Middle_3
{
  Vector_3 point, nearest;

  Middle_3(const Body_surface_3& surface, const std::vector<Vector_3>& positions, const Edge_of_triangle_3& edge)
    : point((positions[edge[0]] + positions[edge[1]]) / 2), nearest(surface.nearest(point, Freedom_3::SURFACE))
  {}

  double distance() const { return (point - nearest).norm(); }
};

// Calls `f` with each edge of each triangle, its middle, and the triangle. An edge of two triangles comes twice, but its nearest
// point is looked for once.
template <typename Function>
void for_each_middle(const Covered_surface_3& covered, const std::vector<Vector_3>& positions, const Function& f)
{
  std::map<Edge_of_triangle_3, Middle_3> middles;
  for(const Triangle_3& triangle : covered.triangles)
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Edge_of_triangle_3 edge = { triangle[i], triangle[(i + 1) % 3] };
      f(edge, middles.try_emplace(sorted(edge), *covered.surface, positions, edge).first->second, triangle);
    }
}

// The largest one of distances, and where it is.
struct Largest_distance_3
{
  double distance = 0;
  Vector_3 point;

  // Replaces the distance by that between p, the place, and q if this is larger.
  void take(const Vector_3& p, const Vector_3& q)
  {
    if((p - q).norm() > distance)
    {
      distance = (p - q).norm();
      point = p;
    }
  }
};

// Returns the largest distance between a surface and the quadrangles that cover it.
inline Largest_distance_3 distance_of_cover_3(const Covered_surface_3& covered, const std::vector<Vector_3>& positions)
{
  Largest_distance_3 result;
  const std::vector<bool> is_vertex = used_points(covered.triangles, positions.size());
  for(std::size_t v = 0; v < positions.size(); ++v)
    if(is_vertex[v])
      result.take(positions[v], covered.surface->nearest(positions[v], Freedom_3::SURFACE));
  for_each_nearest(covered.surface->vertices(), covered.triangles, positions,
                   [&](const Vector_3& p, const Vector_3& q, const Triangle_3&) { result.take(p, q); });
  for_each_middle(covered, positions, [&](const Edge_of_triangle_3&, const Middle_3& middle, const Triangle_3&)
                  { result.take(middle.point, middle.nearest); });
  return result;
}

// Returns the largest distance between the surface of a body and the boundary of hexahedra.
inline Largest_distance_3 boundary_distance_3(const Body_surface_3& surface, const Hexahedra_3& mesh)
{
  Covered_surface_3 covered = { &surface };
  for(const std::array<std::size_t, 4>& q : mesh.facets)
    covered.add(q);
  return distance_of_cover_3(covered, mesh.points);
}

// Returns the largest distance between interfaces and their quadrangles: that of vertices, middles of edges and centers of
// quadrangles from the interface of their subdomains, and of vertices of interfaces from the quadrangles.
inline Largest_distance_3 interface_distance_3(const Hexahedra_3& mesh, Body_interfaces_3& interfaces)
{
  Largest_distance_3 result;
  std::map<Body_interfaces_3::Pair, Covered_surface_3> interfaces_of_pairs;
  for(const Interface_quadrangle_3& q : interface_quadrangles_3(mesh))
  {
    const Body_surface_3& surface = interfaces.surface_of_pair(subdomains_of(mesh, q));
    const auto point = [&](const std::size_t i) { return mesh.points[q.vertices[i % 4]]; };
    const auto take = [&](const Vector_3& p) { result.take(p, surface.nearest(p, Freedom_3::SURFACE)); };
    take(center_of(mesh.points, q.vertices));
    for(std::size_t i = 0; i < 4; ++i)
    {
      take(point(i));
      take((point(i) + point(i + 1)) / 2);
    }
    interfaces_of_pairs.try_emplace(subdomains_of(mesh, q), Covered_surface_3{ &surface }).first->second.add(q.vertices);
  }
  for(const auto& [pair, covered] : interfaces_of_pairs)
    if(interfaces.patches_of_pairs().count(pair) > 0)
      for_each_nearest(covered.surface->vertices(), covered.triangles, mesh.points,
                       [&](const Vector_3& p, const Vector_3& q, const Triangle_3&) { result.take(p, q); });
  return result;
}

// Part of covers at a vertex: triangles, the vertices of surfaces to which one of these is nearest, and edges of triangles, with
// their surface, whose middles are far from it.
struct Cover_of_vertex_3
{
  std::vector<Triangle_3> triangles;
  std::vector<Vector_3> points;
  std::vector<std::pair<const Body_surface_3*, Edge_of_triangle_3> > far_edges;
};

// Adds what covers a surface to the covers of its vertices; edges are far away beyond a tolerance.
inline void add_covers_3(const Covered_surface_3& covered, const std::vector<Vector_3>& positions, const double tolerance,
                         std::vector<Cover_of_vertex_3>& covers)
{
  for(const Triangle_3& triangle : covered.triangles)
    for(const std::size_t v : triangle)
      covers[v].triangles.push_back(triangle);
  for_each_nearest(covered.surface->vertices(), covered.triangles, positions,
                   [&](const Vector_3& p, const Vector_3&, const Triangle_3& triangle)
  {
    for(const std::size_t v : triangle)
      covers[v].points.push_back(p);
  });
  for_each_middle(covered, positions, [&](const Edge_of_triangle_3& edge, const Middle_3& middle, const Triangle_3&)
  {
    if(middle.distance() > tolerance)
      for(const std::size_t v : edge)
        covers[v].far_edges.push_back({ covered.surface, edge });
  });
}

// Returns the sum of the squares of the distances of points from the triangles, and of middles from the surface, as far as they
// exceed a tolerance.
inline double uncovered(const std::vector<Vector_3>& positions, const Cover_of_vertex_3& cover, const double tolerance)
{
  double sum = 0;
  for(const Vector_3& p : cover.points)
  {
    double least = (std::numeric_limits<double>::infinity)();
    for(auto triangle = cover.triangles.begin(); triangle != cover.triangles.end() && least > tolerance; ++triangle)
      least = (std::min)(least, std::sqrt(squared_distance(exact_point(p), triangle_of(positions, *triangle))));
    sum += std::pow((std::max)(0., least - tolerance), 2);
  }
  for(const auto& [surface, edge] : cover.far_edges)
    sum += std::pow((std::max)(0., Middle_3(*surface, positions, edge).distance() - tolerance), 2);
  return sum;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_COVERED_SURFACE_3_H
