// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_EXACT_POINT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_EXACT_POINT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Vector_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Point with coordinates in double precision, for which predicates are exact.
using Exact_point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;

// Returns the coordinates of points of any kernel, of vectors or of arrays.
template <typename Point>
std::array<double, 3> coordinates(const Point& p)
{ return { CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]) }; }

template <typename Point>
Vector_3 to_vector(const Point& p)
{
  const auto& [x, y, z] = coordinates(p);
  return { x, y, z };
}

template <typename Point>
std::vector<Vector_3> vectors_of(const std::vector<Point>& points)
{
  std::vector<Vector_3> result;
  for(const Point& p : points)
    result.push_back(to_vector(p));
  return result;
}

inline std::vector<std::array<double, 3> > arrays_of(const std::vector<Vector_3>& points)
{
  std::vector<std::array<double, 3> > result;
  for(const Vector_3& p : points)
    result.push_back(coordinates(p));
  return result;
}

template <typename Point>
Exact_point_3 exact_point(const Point& p)
{
  const auto& [x, y, z] = coordinates(p);
  return Exact_point_3(x, y, z);
}

// Returns the point of a vertex of a triangulation, without the weight that it may have.
template <typename Tr>
auto point_of_vertex(const Tr& tr, const typename Tr::Vertex_handle v)
{ return typename Tr::Geom_traits::Point_3(tr.geom_traits().construct_point_3_object()(tr.point(v))); }

inline bool is_finite_point(const Exact_point_3& p)
{ return CGAL::is_finite(p.x()) && CGAL::is_finite(p.y()) && CGAL::is_finite(p.z()); }

// Returns whether a cell is positive. A cell with a point that is not finite is not; exact predicates are undefined for it.
inline bool is_positive_cell(const std::array<Exact_point_3, 4>& p)
{ return std::all_of(p.begin(), p.end(), is_finite_point) && CGAL::orientation(p[0], p[1], p[2], p[3]) == CGAL::POSITIVE; }

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_EXACT_POINT_3_H
