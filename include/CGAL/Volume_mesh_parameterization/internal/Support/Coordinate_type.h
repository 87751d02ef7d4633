// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_COORDINATE_TYPE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_COORDINATE_TYPE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <boost/property_map/property_map.hpp>
#include <boost/type_traits/detected_or.hpp>

#include <array>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// The type in which the user stores coordinates, as a value: by default one that stores every `double`.
struct Coordinate_type
{
  double (*rounded)(double) = [](const double x) { return x; };
  double epsilon = 0; // relative distance of neighboring numbers; 0 if no `double` is rounded

  bool is_narrow() const { return epsilon > 0; }

  std::array<double, 3> rounded_point(const std::array<double, 3>& p) const
  { return { rounded(p[0]), rounded(p[1]), rounded(p[2]) }; }
};

template <typename T>
Coordinate_type coordinate_type()
{
  using Limits = std::numeric_limits<T>;
  if constexpr(Limits::is_specialized && !Limits::is_exact && Limits::digits < std::numeric_limits<double>::digits)
    return { [](const double x) { return static_cast<double>(static_cast<T>(x)); }, static_cast<double>(Limits::epsilon()) };
  else
    return Coordinate_type();
}

// The type of the coordinates of a point, a vector or an array.
template <typename Point>
using Coordinate_of = std::decay_t<decltype(std::declval<const Point&>()[0])>;

// The narrower one of the types of coordinates of a point and of what a property map makes of it.
template <typename Map, typename Point>
Coordinate_type coordinate_type_of_map()
{
  using Value = typename boost::property_traits<Map>::value_type;
  const Coordinate_type of_point = coordinate_type<Coordinate_of<Point> >();
  return of_point.is_narrow() ? of_point : coordinate_type<boost::detected_or_t<double, Coordinate_of, Value> >();
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_COORDINATE_TYPE_H
