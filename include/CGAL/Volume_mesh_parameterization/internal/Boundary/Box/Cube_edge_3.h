// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_CUBE_EDGE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_CUBE_EDGE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <array>
#include <cstddef>

namespace CGAL::Volume_mesh_parameterization::internal {

// Bit a of the number of a corner of the cube tells on which of the two sides it is along axis a.
inline int side_of_corner(const int corner, const int axis)
{
  return (corner >> axis & 1) ? 1 : -1;
}

struct Cube_edge_3
{
  int corner; // on the negative side along the axis
  int axis;

  int other_corner() const { return corner + (1 << axis); }
};

inline std::array<Cube_edge_3, 12> cube_edges()
{
  std::array<Cube_edge_3, 12> edges;
  std::size_t n = 0;
  for(int axis = 0; axis < 3; ++axis)
    for(int corner = 0; corner < 8; ++corner)
      if(side_of_corner(corner, axis) < 0)
        edges[n++] = { corner, axis };
  return edges;
}

// The axis of the edge that follows around a corner, counterclockwise as seen from outside.
inline int next_axis_around_corner(const int corner, const int axis)
{
  const bool is_direct = side_of_corner(corner, 0) * side_of_corner(corner, 1) * side_of_corner(corner, 2) > 0;
  return (axis + (is_direct ? 1 : 2)) % 3;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_CUBE_EDGE_3_H
