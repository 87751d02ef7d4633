// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_ORDERED_COORDINATES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_ORDERED_COORDINATES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Closest_ordered_values.h>
#include <CGAL/Polycube_meshing_3/internal/basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Planes origin + k spacing along each axis, for all integers k; any plane if the spacing is 0. If the grid may move, its origin
// is changed such that the planes are as close to given faces as possible.
struct Plane_grid_3
{
  Vector_3 origin = Vector_3::Zero();
  double spacing = 0;
  bool may_move = false;
};

// Transitive order of elements. Elements of a cycle precede themselves.
class Order_of_elements
{
public:
  explicit Order_of_elements(const std::size_t n) : m_precedes(n, std::vector<bool>(n, false)) {}

  // Puts an element before another one, with all that follows from this.
  void add(const std::size_t first, const std::size_t second)
  {
    if(precedes(first, second))
      return;
    for(std::size_t i = 0; i < m_precedes.size(); ++i)
      if(i == first || precedes(i, first))
        for(std::size_t k = 0; k < m_precedes.size(); ++k)
          if(k == second || precedes(second, k))
            m_precedes[i][k] = true;
  }

  bool precedes(const std::size_t first, const std::size_t second) const { return m_precedes[first][second]; }

  // Returns whether the first element can still be put before the second one.
  bool may_precede(const std::size_t first, const std::size_t second) const
  { return first != second && !precedes(second, first); }

private:
  std::vector<std::vector<bool> > m_precedes;
};

// Returns the shift, between -1/2 and 1/2, of the integers with the least weighted mean of (x(i) - nearest shifted integer)^2. Of
// shifts that are about as good, the one whose nearest integers extend farthest is taken, whichever way the axis points.
inline double closest_shift_of_integers(const std::vector<double>& weights, const std::vector<double>& x)
{
  constexpr double worth_of_extent = 0.001; // a guess; far above rounding, but a negligible mean
  double result = 0, least = (std::numeric_limits<double>::infinity)();
  for(const double first : x) // counts as an integer: x(i) belongs to the next one below, and the mean distance is the best shift
  {
    double weight = 0, sum = 0, sum_of_squares = 0, lowest = 0, highest = 0;
    for(std::size_t i = 0; i < x.size(); ++i)
    {
      const double integer = std::floor(x[i] - first), distance = x[i] - first - integer;
      weight += weights[i];
      sum += weights[i] * distance;
      sum_of_squares += weights[i] * distance * distance;
      lowest = (std::min)(lowest, integer);
      highest = (std::max)(highest, integer);
    }
    const double cost = sum_of_squares / weight - std::pow(sum / weight, 2) - worth_of_extent * (highest - lowest);
    if(cost < least - worth_of_extent / 2)
    {
      least = cost;
      result = first + sum / weight;
    }
  }
  return result - std::round(result);
}

// Raises coordinates until all are in the orders. Returns whether this is possible.
inline bool move_into_order(const std::vector<Order_of_coordinates>& orders, std::vector<double>& x)
{
  for(std::size_t round = 0; round <= x.size(); ++round)
  {
    bool has_changed = false;
    for(const auto& [first, second, distance] : orders)
      if(const double least = x[first] + distance; x[second] < least)
      {
        x[second] = least;
        has_changed = true;
      }
    if(!has_changed)
      return true;
  }
  return false;
}

// Coordinates along an axis, and the origin of the planes that they are on, if there are planes.
struct Ordered_coordinates
{
  std::vector<double> values;
  double origin;
};

// Returns the coordinates along an axis that minimize the sum of area(i) (x(i) - moment(i) / area(i))^2 in the given orders; none
// if the orders contradict each other.
//
// Rounds distances up to multiples of the spacing, if there is one, and the solution to the planes of the grid. Moves the grid
// before, if it may move. Coordinates that are joined by distances are rounded together.
inline std::optional<Ordered_coordinates>
ordered_coordinates_3(const std::vector<double>& areas, const std::vector<double>& moments,
                      std::vector<Order_of_coordinates> orders, const Plane_grid_3& grid, const int axis)
{
  constexpr double rounding = 1e-9; // does not decide to which of two planes a coordinate in their middle is moved
  const bool has_planes = grid.spacing > 0;
  const double scale = has_planes ? grid.spacing : 1, origin = has_planes ? grid.origin[axis] : 0;
  for(Order_of_coordinates& order : orders)
    order.distance = has_planes ? std::ceil(order.distance / scale) : order.distance;
  std::vector<double> wanted;
  for(std::size_t i = 0; i < areas.size(); ++i)
    wanted.push_back((moments[i] / areas[i] - origin) / scale);
  std::vector<double> x = wanted;
  if(!move_into_order(orders, x))
    return std::nullopt;
  const auto [bases, offsets] = Closest_ordered_values(areas, wanted, orders).run();
  for(std::size_t i = 0; i < x.size(); ++i)
    x[i] = bases[i] + offsets[i];
  const double shift = has_planes && grid.may_move ? closest_shift_of_integers(areas, x) : 0;
  if(has_planes)
    for(std::size_t i = 0; i < x.size(); ++i)
      x[i] = std::floor(bases[i] - shift + 0.5 + rounding) + offsets[i];
  move_into_order(orders, x); // where orders hold up to rounding only
  Ordered_coordinates result = { x, origin + scale * shift };
  if(has_planes)
    for(double& value : result.values)
      value = result.origin + scale * value;
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_ORDERED_COORDINATES_3_H
