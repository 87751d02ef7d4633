// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_POSITIVE_UNTIL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_POSITIVE_UNTIL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Volume_mesh_parameterization::internal {

// A number in [0, 1] up to which the polynomial with Bernstein coefficients b is positive: its
// first root, less at most the resolution times that root, however small it is. Bisects by de
// Casteljau's algorithm.
inline double positive_until(const std::array<double, 4>& b, const double resolution = 1. / 1024)
{
  if((std::min)((std::min)(b[0], b[1]), (std::min)(b[2], b[3])) > 0)
    return 1;
  const bool are_finite = std::isfinite(b[0]) && std::isfinite(b[1]) && std::isfinite(b[2]) && std::isfinite(b[3]);
  if(resolution >= 1 || !(b[0] > 0) || !are_finite)
    return 0;
  const double b01 = (b[0] + b[1]) / 2, b12 = (b[1] + b[2]) / 2, b23 = (b[2] + b[3]) / 2;
  const double b012 = (b01 + b12) / 2, b123 = (b12 + b23) / 2;
  const double middle = (b012 + b123) / 2;
  const double left = positive_until({ b[0], b01, b012, middle }, resolution);
  if(left < 1)
    return left / 2;
  return (1 + positive_until({ middle, b123, b23, b[3] }, 2 * resolution)) / 2;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_POSITIVE_UNTIL_H
