// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_EXACT_POINT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_EXACT_POINT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>

namespace CGAL::Volume_mesh_parameterization::internal {

// The point with coordinates in double precision, for which predicates are exact.
using Exact_point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;

template <typename Point>
Exact_point_3 exact_point(const Point& p)
{
  return Exact_point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

inline bool is_finite_point(const Exact_point_3& p)
{
  return CGAL::is_finite(p.x()) && CGAL::is_finite(p.y()) && CGAL::is_finite(p.z());
}

// A cell with a point that is not finite is not positive; exact predicates are undefined for it.
inline bool is_positive_cell(const std::array<Exact_point_3, 4>& p)
{
  return std::all_of(p.begin(), p.end(), is_finite_point)
    && CGAL::orientation(p[0], p[1], p[2], p[3]) == CGAL::POSITIVE;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_EXACT_POINT_3_H
