// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IMPLICIT_SURFACE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IMPLICIT_SURFACE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Any_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Vector_3.h>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationSurfaces

The surface on which a function is zero. A point is put back along the gradient by Newton's method until rounding ends it.

\tparam Function a type with two functions of a point, `double value(const std::array<double, 3>& p) const` and
        `std::array<double, 3> gradient(const std::array<double, 3>& p) const`. Near the surface, the function is differentiable,
        and the gradient is finite and not zero: a cube root, for instance, has an infinite slope. Threads call both at the same
        time. If Newton's method diverges, the map reports the vertex, and there is no success.

\cgalModels{SlidingSurface_3}
*/
template <typename Function>
class Implicit_surface_3
{
public:
  /// stores a copy of the function.
  explicit Implicit_surface_3(const Function& function) : m_function(function) {}

  /// returns the point to which Newton's method leads from `p`, with the gradient there.
  Surface_point_3 nearest_point(const std::array<double, 3>& p) const
  {
    constexpr int maximum_number_of_steps = 50; // a guess
    internal::Vector_3 x(p[0], p[1], p[2]), gradient = gradient_at(x), next = x;
    double length = std::numeric_limits<double>::infinity();
    for(int step = 0; step < maximum_number_of_steps; ++step)
    {
      const internal::Vector_3 move = newton_step(m_function.value({ x[0], x[1], x[2] }), gradient);
      next = x + move;
      if(next == x || (step > 0 && !(move.norm() < length))) // rounding does not let it come nearer
        break;
      length = move.norm();
      x = next;
      gradient = gradient_at(x);
    }
    return { { x[0], x[1], x[2] }, { gradient[0], gradient[1], gradient[2] } };
  }

private:
  // Divides by a power of two first, which changes no digits, so that no square of a slope overflows.
  static internal::Vector_3 newton_step(const double value, const internal::Vector_3& gradient)
  {
    const double largest = gradient.cwiseAbs().maxCoeff();
    const int exponent = largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
    const internal::Vector_3 slope = gradient.unaryExpr([&](const double x) { return std::scalbn(x, -exponent); });
    return -(std::scalbn(value, -exponent) / slope.squaredNorm()) * slope;
  }

  internal::Vector_3 gradient_at(const internal::Vector_3& x) const
  {
    const std::array<double, 3> g = m_function.gradient({ x[0], x[1], x[2] });
    return { g[0], g[1], g[2] };
  }

  Function m_function;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IMPLICIT_SURFACE_3_H
