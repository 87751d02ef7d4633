// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_PULL_TO_VERTICES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_PULL_TO_VERTICES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Covered_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Corners_of_hexahedra_3.h>

namespace CGAL::Polycube_meshing_3::internal {

// Pulls a point of a triangle to a far point on the body's surface, along the way between both only, so that the triangle
// may slide across the way (as in the registration of surfaces by Chen and Medioni, Object modelling by registration of
// multiple range images, 1992).
inline void pull_point_3(const Vector_3& q, const Triangle_3& triangle, const Vector_3& p,
                         const std::vector<Vector_3>& positions, const double tolerance, const double weight,
                         Corner_goals_3& goals)
{
  constexpr double longest_pull = 1;             // a guess; relative to the mean edge
  const double factor = std::sqrt(200 * weight); // a guess; scales the residual
  const double distance = (p - q).norm();
  if(distance < tolerance * goals.mean_edge)
    return;
  const int a = static_cast<int>(triangle[0]), b = static_cast<int>(triangle[1]), c = static_cast<int>(triangle[2]);
  const Vector_3 u = positions[b] - positions[a], v = positions[c] - positions[a], w = q - positions[a];
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), determinant = uu * vv - uv * uv;
  if(!(determinant > 0))
    return;
  const double inverse = 1 / determinant;
  const double s = vv * inverse * u.dot(w) - uv * inverse * v.dot(w);
  const double t = uu * inverse * v.dot(w) - uv * inverse * u.dot(w);
  const Vector_3 way = factor * (p - q) / distance;
  goals.constraints.push_back({ { { a, (1 - (s + t)) * way }, { b, s * way }, { c, t * way } },
                                way.dot(q) + factor * (std::min)(distance, longest_pull * goals.mean_edge) });
}

// Pulls triangles to the vertices of the surface, more with a larger weight.
inline void pull_to_vertices_3(const Covered_surface_3& covered, const std::vector<Vector_3>& positions, const double weight,
                               Corner_goals_3& goals)
{
  for_each_nearest(covered.surface->vertices(), covered.triangles, positions,
                   [&](const Vector_3& p, const Vector_3& q, const Triangle_3& triangle)
                   { pull_point_3(q, triangle, p, positions, covered.tolerance, weight, goals); });
}

// Pulls the middles of quadrangles and of their edges to the surface.
inline void pull_middles_3(const Covered_surface_3& covered, const std::vector<Vector_3>& positions, const double weight,
                           Corner_goals_3& goals)
{
  for_each_middle(covered, positions,
                  [&](const Edge_of_triangle_3&, const Middle_3& middle, const Triangle_3& triangle)
                  { pull_point_3(middle.point, triangle, middle.nearest, positions, covered.tolerance, weight, goals); });
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_PULL_TO_VERTICES_3_H
