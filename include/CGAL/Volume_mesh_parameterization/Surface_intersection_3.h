// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_SURFACE_INTERSECTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_SURFACE_INTERSECTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Any_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Vector_3.h>

#include <tuple>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationSurfaces

The curve in which two surfaces intersect, such as the rim of a tank. A point is put back by Newton's method with the tangent
planes of both until rounding ends it. Where a surface has a border, the curve ends. Coordinates are not numbers if the surfaces
are tangent to each other.

\cgalModels{SlidingSurface_3}
*/
class Surface_intersection_3
{
public:
  /// stores two surfaces.
  Surface_intersection_3(const Any_surface_3& first, const Any_surface_3& second) : m_first(first), m_second(second) {}

  /// returns the point to which Newton's method leads from `p`, with the tangent of the curve there. If no point of both surfaces
  /// is found, the point is the one nearest to `p` on the farther surface, and not `p`.
  Surface_point_3 nearest_point(const std::array<double, 3>& p) const
  {
    constexpr double rounding = 32 * std::numeric_limits<double>::epsilon();
    const internal::Vector_3 start(p[0], p[1], p[2]);
    internal::Vector_3 x = newton_point(start, normal_and_distance), offset = farther_offset(x);
    const auto is_on_both = [&] { return length(offset) <= rounding * x.cwiseAbs().maxCoeff(); };
    const auto use_if_nearer = [&](const internal::Vector_3& y)
    {
      if(const internal::Vector_3 offset_of_y = farther_offset(y); length(offset_of_y) < length(offset))
        std::tie(x, offset) = std::pair(y, offset_of_y);
    };
    if(!is_on_both()) // beyond a border, a tangent plane is no surface
      use_if_nearer(newton_point(x, offset_and_distance));
    if(!is_on_both()) // where triangles bend, planes lead away
      use_if_nearer(newton_point(projected_in_turn(start), offset_and_distance));
    const internal::Vector_3 tangent = normal_and_distance(m_first, x).first.cross(normal_and_distance(m_second, x).first);
    const internal::Vector_3 q = start + farther_offset(start);
    return { is_on_both() ? m_second.nearest_point({ x[0], x[1], x[2] }).point : std::array<double, 3>{ q[0], q[1], q[2] },
             { tangent[0], tangent[1], tangent[2] } };
  }

private:
  // Projects a point on each surface in turn, which comes near to the curve slowly, but does not leave it.
  internal::Vector_3 projected_in_turn(internal::Vector_3 x) const
  {
    constexpr int number_of_rounds = 50; // a guess
    for(int round = 0; round < number_of_rounds; ++round)
      for(const Any_surface_3* const surface : { &m_first, &m_second })
        x += offset_to(*surface, x);
    return x;
  }

  using Plane = std::pair<internal::Vector_3, double>; // the unit normal, and how far the plane is along it

  // Puts a point on a plane of each surface, again and again.
  template <typename PlaneAt>
  internal::Vector_3 newton_point(internal::Vector_3 x, const PlaneAt& plane_at) const
  {
    constexpr int maximum_number_of_steps = 50; // a guess
    double last_length = std::numeric_limits<double>::infinity();
    for(int step = 0; step < maximum_number_of_steps; ++step)
    {
      const auto [m, a] = plane_at(m_first, x);
      const auto [n, b] = plane_at(m_second, x);
      const double cosine = m.dot(n), determinant = 1 - cosine * cosine;
      const internal::Vector_3 move = (a - cosine * b) / determinant * m + (b - cosine * a) / determinant * n;
      if(step > 0 && !(move.norm() < last_length)) // rounding does not let it come nearer
        break;
      last_length = move.norm();
      x += move;
    }
    return x;
  }

  // The tangent plane.
  static Plane normal_and_distance(const Any_surface_3& surface, const internal::Vector_3& x)
  {
    const auto [p, n] = surface.nearest_point({ x[0], x[1], x[2] });
    const internal::Vector_3 normal = internal::unit_vector_3({ n[0], n[1], n[2] });
    return { normal, normal.dot(internal::Vector_3(p[0], p[1], p[2]) - x) };
  }

  // The plane through the nearest point that is orthogonal to the way there. Beyond a border, it is not the tangent plane.
  static Plane offset_and_distance(const Any_surface_3& surface, const internal::Vector_3& x)
  {
    const Plane tangent = normal_and_distance(surface, x);
    const internal::Vector_3 offset = offset_to(surface, x);
    return length(offset) > 2 * std::abs(tangent.second) ? Plane(internal::unit_vector_3(offset), length(offset)) : tangent;
  }

  static internal::Vector_3 offset_to(const Any_surface_3& surface, const internal::Vector_3& x)
  {
    const auto p = surface.nearest_point({ x[0], x[1], x[2] }).point;
    return internal::Vector_3(p[0], p[1], p[2]) - x;
  }

  // The way to the farther one of the surfaces.
  internal::Vector_3 farther_offset(const internal::Vector_3& x) const
  {
    const internal::Vector_3 a = offset_to(m_first, x), b = offset_to(m_second, x);
    return length(a) > length(b) ? a : b;
  }

  static double length(const internal::Vector_3& v) { return internal::length_3(v); }

  Any_surface_3 m_first, m_second;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_SURFACE_INTERSECTION_3_H
