// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_INVERSE_SPLINE_BARRIER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_INVERSE_SPLINE_BARRIER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/select.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The function phi(x) = 1 / g(x) - 1 with the spline g(x) = 1 - (1 - x)^3 of Schueller et al., Locally
// Injective Mappings (CGF 2013), and its derivatives. For x -> 0+ it tends to infinity, from x = 1 on it
// is 0; it is twice continuously differentiable.
template <typename T>
struct Inverse_spline_barrier
{
  T value, first, second;

  explicit Inverse_spline_barrier(const T& argument)
  {
    const T x = minimum(argument, T(1));
    const T y = T(1) - x;
    const T inverse = T(1) / (x * (T(1) + y + y * y)); // 1 / g, without cancellation
    const T slope = T(3) * y * y;                      // g'
    value = y * y * y * inverse;
    first = -slope * inverse * inverse;
    second = T(2) * slope * slope * inverse * inverse * inverse + T(6) * y * inverse * inverse;
  }

  // The same, but the parabola that touches phi at `smallest` below that point: finite everywhere. For
  // `smallest` = 0 it is phi itself, which is not finite from 0 downwards.
  static Inverse_spline_barrier relaxed(const T& x, const T& smallest)
  {
    Inverse_spline_barrier result(maximum(x, smallest));
    const T distance = minimum(x - smallest, T(0));
    result.value += distance * (result.first + T(0.5) * distance * result.second);
    result.first += distance * result.second;
    return result;
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_INVERSE_SPLINE_BARRIER_H
