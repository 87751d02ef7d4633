// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_COORDINATES_OF_BOX_WITH_HOLES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_COORDINATES_OF_BOX_WITH_HOLES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/ordered_coordinates_3.h>

#include <algorithm>

namespace CGAL::Polycube_meshing_3::internal {

// Measures of a surface for a box with holes in a row from left to right.
struct Measures_of_box_3
{
  double bar = 0;                      // mean quarter of a meridian
  double front = 0;                    // length of the edge in front
  double area_of_top = 0, area_of_sides = 0;
  std::vector<double> widths, middles; // quarters of edges of holes, and positions in front, from 0 to 1
};

// Returns the length of the front with which the holes, with bars between them, have their middles at their positions.
inline double length_of_divided_front(const Measures_of_box_3& measures, const double bar)
{
  constexpr double least_part = 0.01; // a guess; bounds the length where two holes have the same position
  double result = 0, position = 0, half = 0; // position and half the width of the last hole
  for(std::size_t i = 0; i <= measures.widths.size(); ++i)
  {
    const bool is_hole = i < measures.widths.size();
    const double next_position = is_hole ? measures.middles[i] : 1, next_half = is_hole ? measures.widths[i] / 2 : 0;
    result = (std::max)(result, (half + bar + next_half) / (std::max)(least_part, next_position - position));
    position = next_position;
    half = next_half;
  }
  return result;
}

// Returns the coordinates of the top, the bottom, of four sides of each hole (left, back, right, front), and of the box
// (right, back, left, front), along their axes. Bars are as thick as on the surface, and holes as wide. The middles of holes
// are at their positions along the front, if the box may be long enough, or as far as there is room. The top keeps its area,
// and the middle of the box is at the origin. With planes of a grid, distances are rounded up.
inline std::vector<double> coordinates_of_box_with_holes_3(const Measures_of_box_3& measures, const bool may_be_long,
                                                           const Plane_grid_3& grid)
{
  const auto rounded = [&](const double x) { return grid.spacing > 0 ? grid.spacing * std::ceil(x / grid.spacing) : x; };
  const double bar = rounded(measures.bar);
  double x = bar, largest = 0, area = measures.area_of_top;
  std::vector<double> widths;
  for(const double width : measures.widths)
  {
    widths.push_back(rounded(width));
    x += widths.back() + bar;
    largest = (std::max)(largest, widths.back());
    area += widths.back() * widths.back();
  }
  double spare = -x; // length left for gaps that are wider than a bar
  x = (std::max)(x, rounded(may_be_long ? length_of_divided_front(measures, bar)
                                        : (std::min)(measures.front, 2 * std::sqrt(area))));
  spare += x;
  const double y = 2 * bar + largest + rounded((std::max)(0., area / x - 2 * bar - largest));
  const double z = rounded((std::max)(bar, measures.area_of_sides / (2 * (x + y))));

  Vector_3 corner = Vector_3(x, y, z) / -2;
  if(grid.spacing > 0)
    for(int axis = 0; axis < 3; ++axis)
      corner[axis] = grid.origin[axis] + grid.spacing * std::round((corner[axis] - grid.origin[axis]) / grid.spacing);
  std::vector<double> result = { corner.z() + z, corner.z() };
  double left = bar;
  for(std::size_t i = 0; i < widths.size(); ++i)
  {
    const double gap = (std::max)(0., (std::min)(spare, rounded(x * measures.middles[i] - widths[i] / 2 - left)));
    spare -= gap;
    left += gap;
    for(const double c : { corner.x() + left, corner.y() + bar + widths[i], corner.x() + left + widths[i], corner.y() + bar })
      result.push_back(c);
    left += widths[i] + bar;
  }
  for(const double c : { corner.x() + x, corner.y() + y, corner.x(), corner.y() })
    result.push_back(c);
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_COORDINATES_OF_BOX_WITH_HOLES_3_H
