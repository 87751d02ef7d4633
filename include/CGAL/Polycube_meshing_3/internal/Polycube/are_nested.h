// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_ARE_NESTED_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_ARE_NESTED_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

using Boundary_polygon_2 = std::vector<Boundary_point_2>;

// Returns whether a polygon leads counterclockwise around a face, and not around a hole, even where its edges intersect: the
// function of CGAL asks for simple polygons.
inline bool is_outer(const Boundary_polygon_2& p)
{
  int turns = 0;
  for(std::size_t i = 0; i < p.size(); ++i)
    turns += CGAL::orientation(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]);
  return turns > 0;
}

// Returns whether disjoint polygons are one and its holes: holes lead clockwise, are inside of it, and outside of each other.
inline bool are_nested(std::vector<Boundary_polygon_2> polygons)
{
  const auto is_inside = [](const Boundary_polygon_2& inner, const Boundary_polygon_2& outer)
  { return CGAL::bounded_side_2(outer.begin(), outer.end(), inner.front()) == ON_BOUNDED_SIDE; };
  const auto first_hole = std::partition(polygons.begin(), polygons.end(), is_outer);
  const auto is_hole = [&](const Boundary_polygon_2& p)
  {
    return is_inside(p, polygons.front()) && std::none_of(first_hole, polygons.end(), [&](const Boundary_polygon_2& other)
                                                          { return &other != &p && is_inside(p, other); });
  };
  return first_hole - polygons.begin() == 1 && std::all_of(first_hole, polygons.end(), is_hole);
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_ARE_NESTED_H
