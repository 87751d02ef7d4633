// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_COORDINATES_OF_BOX_WITH_HOLE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_COORDINATES_OF_BOX_WITH_HOLE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/ordered_coordinates_3.h>

#include <algorithm>

namespace CGAL::Polycube_meshing_3::internal {

// Measures of a surface for a box with a hole.
struct Measures_of_box_3
{
  double bar;                        // quarter of a meridian
  double width;                      // quarter of an edge of the hole
  double front, middle;              // length of the edge in front, and the part of it up to the middle of the hole
  double area_of_top, area_of_sides; // outside
};

// Returns the coordinates of the top, the bottom, of four sides of the hole, and of the box (right, back, left, front), along
// their axes. The bar is as thick as on the surface, and the hole as wide. The middle of the hole is at its position along the
// front, as far as there is room. The top keeps its area, and the middle of the box is at the origin. With planes of a grid,
// distances are rounded up.
inline std::vector<double> coordinates_of_box_with_hole_3(const Measures_of_box_3& measures, const Plane_grid_3& grid)
{
  const auto rounded = [&](const double x) { return grid.spacing > 0 ? grid.spacing * std::ceil(x / grid.spacing) : x; };
  const double bar = rounded(measures.bar), width = rounded(measures.width), least = 2 * bar + width;
  const double area = measures.area_of_top + width * width;
  const double x = (std::max)(least, rounded((std::min)(measures.front, 2 * std::sqrt(area))));
  const double y = least + rounded((std::max)(0., area / x - least));
  const double z = rounded((std::max)(bar, measures.area_of_sides / (2 * (x + y))));

  Vector_3 corner = Vector_3(x, y, z) / -2;
  if(grid.spacing > 0)
    for(int axis = 0; axis < 3; ++axis)
      corner[axis] = grid.origin[axis] + grid.spacing * std::round((corner[axis] - grid.origin[axis]) / grid.spacing);
  const double gap = (std::max)(0., (std::min)(x - least, rounded(x * measures.middle - width / 2 - bar)));
  const double left = corner.x() + bar + gap, front = corner.y() + bar;
  return { corner.z() + z, corner.z(),
           left + width, front + width, left, front,
           corner.x() + x, corner.y() + y, corner.x(), corner.y() };
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_COORDINATES_OF_BOX_WITH_HOLE_3_H
