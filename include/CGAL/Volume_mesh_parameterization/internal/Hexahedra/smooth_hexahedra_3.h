// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_SMOOTH_HEXAHEDRA_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_SMOOTH_HEXAHEDRA_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/Pulled_back_hexahedra_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

using Corners_of_vertex = std::vector<std::array<std::size_t, 4> >; // those to which it belongs

// The sum of squares of what the scaled Jacobians lack.
inline double shortage(const Hexahedron_soup_3& mesh, const Corners_of_vertex& corners, const double target)
{
  double sum = 0;
  for(const std::array<std::size_t, 4>& corner : corners)
    sum += std::pow((std::max)(0., target - scaled_jacobian(mesh, corner)), 2);
  return sum;
}

inline double mean_length_of_edges(const Hexahedron_soup_3& mesh, const Corners_of_vertex& corners)
{
  double sum = 0;
  for(const std::array<std::size_t, 4>& corner : corners)
    for(std::size_t i = 1; i < 4; ++i)
      sum += (to_vector(mesh.points[corner[i]]) - to_vector(mesh.points[corner[0]])).norm();
  return sum / (3. * static_cast<double>(corners.size()));
}

// Moves a vertex to the best one of its 26 neighbors in a grid of that width, relative to the edges. Returns whether
// one of them is better than its place.
inline bool smooth_vertex_3(Pulled_back_hexahedra_3& hexahedra, const std::size_t v, const Corners_of_vertex& corners,
                            const double target, const double width)
{
  const double step = width * (hexahedra.is_on_boundary(v) ? hexahedra.spacing()
                                                           : mean_length_of_edges(hexahedra.mesh(), corners));
  const auto here = hexahedra.place(v);
  auto best = here;
  double least = shortage(hexahedra.mesh(), corners, target);
  for(int i = 0; i < 27; ++i)
  {
    hexahedra.put(v, here);
    if(hexahedra.move(v, { (i % 3 - 1) * step, (i / 3 % 3 - 1) * step, (i / 9 - 1) * step }))
      if(const double next = shortage(hexahedra.mesh(), corners, target); next < least)
      {
        least = next;
        best = hexahedra.place(v);
      }
  }
  hexahedra.put(v, best);
  return best.point != here.point;
}

// Moves vertices one after the other, such that the scaled Jacobians of the corners around them come nearer to the
// target: local optimization (Freitag and Ollivier-Gooch 1997) by pattern search (Hooke and Jeeves 1961). Where the
// boundary bends within one quadrangle, tangent planes mean little; here, vertices on it move in the domain, where it
// is plane.
inline void smooth_hexahedra_3(Pulled_back_hexahedra_3& hexahedra, const double target)
{
  constexpr int number_of_sweeps = 10;
  constexpr double first_width = 0.25, smallest_width = 0.004;
  const std::size_t number_of_vertices = hexahedra.mesh().points.size();
  std::vector<Corners_of_vertex> corners(number_of_vertices);
  for_each_corner(hexahedra.mesh(), [&](const std::array<std::size_t, 4>& corner)
  {
    for(const std::size_t v : corner)
      corners[v].push_back(corner);
  });
  std::vector<double> widths(number_of_vertices, first_width);
  for(int sweep = 0; sweep < number_of_sweeps; ++sweep)
    for(std::size_t v = 0; v < number_of_vertices && !hexahedra.budget().is_exhausted(); ++v)
      if(widths[v] > smallest_width && shortage(hexahedra.mesh(), corners[v], target) > 0
         && !smooth_vertex_3(hexahedra, v, corners[v], target, widths[v]))
        widths[v] /= 2;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_SMOOTH_HEXAHEDRA_3_H
