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
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Map of a surface: if the status is OK, the images of its vertices, their distortion, infinite if not measured, and the edges
// that were split for the map one after the other, each at its midpoint. The new points come behind all others.
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

// Returns the cost of the map to a polycube: the distortion, times the third root of the factor by which splits multiply the
// vertices. Voxels usually have a factor of 2.4. They must have three quarters of the distortion of others, as splits multiply the
// cells inside.
inline double cost_of_map(const Surface_map_3& map)
{
  const double n = static_cast<double>(map.images.size()), given = n - static_cast<double>(map.splits.size());
  return map.distortion * std::cbrt(n / given);
}

// Returns the part of the length of all sharp edges whose images lead along no axis.
inline double part_given_up_3(const Numbered_surface_3& surface, const Surface_map_3& map)
{
  std::vector<Vector_3> points = surface.points;
  std::set<std::array<std::size_t, 2> > edges;
  for(const std::array<std::size_t, 2>& edge : surface.sharp_edges)
    edges.insert(sorted(edge));
  for(const std::array<std::size_t, 2>& split : map.splits)
  {
    const auto [v, w] = split;
    if(edges.erase(sorted(split)) > 0)
      edges.insert({ { v, points.size() }, { w, points.size() } });
    points.push_back((points[v] + points[w]) / 2);
  }
  double all = 0, given_up = 0;
  for(const auto& [v, w] : edges)
  {
    const double length = length_3(points[w] - points[v]);
    all += length;
    given_up += leads_along_axis(map.images[v], map.images[w]) ? 0 : length;
  }
  return all > 0 ? given_up / all : 0;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_SURFACE_MAP_3_H
