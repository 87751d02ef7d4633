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

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationSurfaces

The curve in which two surfaces intersect, such as the rim of a tank. A point is put back by Newton's method with the tangent
planes of both until rounding ends it. Coordinates are not numbers if the surfaces are tangent to each other.

\cgalModels{SlidingSurface_3}
*/
class Surface_intersection_3
{
public:
  /// stores two surfaces.
  Surface_intersection_3(const Any_surface_3& first, const Any_surface_3& second) : m_first(first), m_second(second) {}

  /// returns the point to which Newton's method leads from `p`, with the tangent of the curve there.
  Surface_point_3 nearest_point(const std::array<double, 3>& p) const
  {
    constexpr int maximum_number_of_steps = 50; // a guess
    internal::Vector_3 x(p[0], p[1], p[2]);
    double length = std::numeric_limits<double>::infinity();
    for(int step = 0; step < maximum_number_of_steps; ++step)
    {
      const auto [m, a] = normal_and_distance(m_first, x);
      const auto [n, b] = normal_and_distance(m_second, x);
      const double cosine = m.dot(n), determinant = 1 - cosine * cosine;
      const internal::Vector_3 move = (a - cosine * b) / determinant * m + (b - cosine * a) / determinant * n;
      if(step > 0 && !(move.norm() < length)) // rounding does not let it come nearer
        break;
      length = move.norm();
      x += move;
    }
    const internal::Vector_3 tangent = normal_and_distance(m_first, x).first.cross(normal_and_distance(m_second, x).first);
    return { m_second.nearest_point({ x[0], x[1], x[2] }).point, { tangent[0], tangent[1], tangent[2] } };
  }

private:
  // the unit normal, and how far the surface is along it
  static std::pair<internal::Vector_3, double> normal_and_distance(const Any_surface_3& surface, const internal::Vector_3& x)
  {
    const auto [p, n] = surface.nearest_point({ x[0], x[1], x[2] });
    const internal::Vector_3 normal = internal::unit_vector_3({ n[0], n[1], n[2] });
    return { normal, normal.dot(internal::Vector_3(p[0], p[1], p[2]) - x) };
  }

  Any_surface_3 m_first, m_second;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_SURFACE_INTERSECTION_3_H
