// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_PULL_TO_SURFACE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_PULL_TO_SURFACE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/Body_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/cover_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/improve_corners_3.h>

#include <numeric>

namespace CGAL::Volume_mesh_parameterization::internal {

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

// Calls `f` with the nearest point of the surface, the middle of an edge of a triangle, and the triangle: a quadrangle that spans
// a valley has its middle far away.
template <typename Function>
void for_each_middle(const Covered_surface_3& covered, const Matrix3Xd& positions, const Function& f)
{
  for(const std::array<int, 3>& triangle : covered.triangles)
    for(const auto& [a, b] : { std::make_pair(0, 1), std::make_pair(1, 2), std::make_pair(2, 0) })
    {
      const Eigen::Vector3d q = (positions.col(triangle[a]) + positions.col(triangle[b])) / 2;
      f(covered.surface->nearest(q, Freedom_3::SURFACE), q, triangle);
    }
}

// Returns the largest distance between a surface and the quadrangles that cover it.
inline double distance_of_cover_3(const Covered_surface_3& covered, const Matrix3Xd& positions)
{
  double result = 0;
  const auto measure = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const std::array<int, 3>&)
  { result = (std::max)(result, (p - q).norm()); };
  for_each_nearest(covered.surface->vertices(), covered.triangles, positions, measure);
  for_each_middle(covered, positions, measure);
  return result;
}

// Returns the largest distance between the surface of a body and the boundary of hexahedra.
inline double boundary_distance_3(const Body_surface_3& surface, const Hexahedron_soup_3& mesh)
{
  std::vector<int> numbers(mesh.points.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  Matrix3Xd positions(3, mesh.points.size());
  for(const int v : numbers)
    positions.col(v) = to_vector(mesh.points[v]);
  return distance_of_cover_3(covered_surface_3(surface, mesh.facets, numbers, 0), positions);
}

// Pulls a point of a triangle to a far point on the body's surface, along the way between both only, so that the triangle
// may slide across the way (as in the registration of surfaces by Chen and Medioni, Object modelling by registration of
// multiple range images, 1992).
inline void pull_point_3(const Eigen::Vector3d& q, const std::array<int, 3>& triangle, const Eigen::Vector3d& p,
                         const Matrix3Xd& positions, const double tolerance, const double weight,
                         Corner_goals_3& goals)
{
  constexpr double longest_pull = 1;             // a guess; relative to the mean edge
  const double factor = std::sqrt(200 * weight); // a guess; scales the residual
  const double distance = (p - q).norm();
  if(distance < tolerance * goals.mean_edge)
    return;
  const auto& [a, b, c] = triangle;
  Small_matrix<3, 2> sides;
  sides << positions.col(b) - positions.col(a), positions.col(c) - positions.col(a);
  const Small_matrix<2, 2> products = sides.transpose() * sides;
  if(!(products.determinant() > 0))
    return;
  const Small_matrix<2, 2> inverse = products.inverse();
  const Small_matrix<2, 1> st = inverse * (sides.transpose() * (q - positions.col(a)));
  const Eigen::Vector3d way = factor * (p - q) / distance;
  goals.constraints.push_back({ { { a, (1 - st.sum()) * way }, { b, st[0] * way }, { c, st[1] * way } },
                                way.dot(q) + factor * (std::min)(distance, longest_pull * goals.mean_edge) });
}

// Pulls triangles to the vertices of the surface, more with a larger weight.
inline void pull_to_vertices_3(const Covered_surface_3& covered, const Matrix3Xd& positions, const double weight,
                               Corner_goals_3& goals)
{
  for_each_nearest(covered.surface->vertices(), covered.triangles, positions,
                   [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const std::array<int, 3>& triangle)
                   { pull_point_3(q, triangle, p, positions, covered.tolerance, weight, goals); });
}

// Pulls the middles of quadrangles and of their edges to the surface.
inline void pull_middles_3(const Covered_surface_3& covered, const Matrix3Xd& positions, const double weight,
                           Corner_goals_3& goals)
{
  for_each_middle(covered, positions,
                  [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const std::array<int, 3>& triangle)
                  { pull_point_3(q, triangle, p, positions, covered.tolerance, weight, goals); });
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_PULL_TO_SURFACE_3_H
