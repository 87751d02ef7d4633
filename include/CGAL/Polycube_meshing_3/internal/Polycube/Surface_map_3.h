// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_SURFACE_MAP_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_SURFACE_MAP_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Map of a surface: if the status is OK, the images of its vertices, their distortion, if others are compared with it, and the
// edges that were split for the map one after the other, each at its midpoint. The new points come behind all others.
struct Surface_map_3
{
  Error_code status = ERROR_NO_POLYCUBE;
  std::vector<Vector_3> images = {};
  double distortion = (std::numeric_limits<double>::infinity)();
  std::vector<std::array<std::size_t, 2> > splits = {};
};

// Returns the direction of the normal of a facet's image on a polycube.
template <typename Facet>
std::size_t label_of_image(const Facet& facet, const std::vector<Vector_3>& images)
{
  const Vector_3 &p = images[facet[0]], &q = images[facet[1]], &r = images[facet[2]];
  std::size_t axis = 0;
  while(axis < 2 && (p[axis] != q[axis] || p[axis] != r[axis]))
    ++axis;
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto point = [&](const Vector_3& image) { return Boundary_point_2(image[u], image[v]); };
  return 2 * axis + (CGAL::orientation(point(p), point(q), point(r)) == NEGATIVE);
}

// Returns what a polycube costs: the distortion, times the third root of the factor by which splits multiply the vertices. So
// voxels, with a usual factor of 2.4, must have three quarters of the distortion of others: they multiply the cells inside.
inline double cost_of_polycube(const Surface_map_3& map)
{
  const double n = static_cast<double>(map.images.size()), given = n - static_cast<double>(map.splits.size());
  return map.distortion * std::cbrt(n / given);
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_SURFACE_MAP_3_H
