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

#include <CGAL/Polycube_meshing_3/internal/basic.h>

#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#ifdef CGAL_USE_GMP
#  include <CGAL/Gmpzf.h>
#else
#  include <CGAL/MP_Float.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Number type of quadratic programs. The solver does not need quotients, and exact rational numbers take longer by far.
#ifdef CGAL_USE_GMP
using Program_number = Gmpzf;
#else
using Program_number = MP_Float;
#endif

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

// Order of two coordinates: the second one must be larger than the first one by the distance.
struct Order_of_coordinates
{
  std::size_t first, second;
  double distance;
};

// Returns floor(x + 1/2).
template <typename NT>
double nearest_integer(const NT& x)
{
  const NT y = x + NT(1) / NT(2);
  const double floor = std::floor(CGAL::to_double(y)); // up to the rounding of y
  return (y < NT(floor)) ? floor - 1 : (NT(floor + 1) <= y) ? floor + 1 : floor;
}

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

// Distances by which coordinates must at least be larger than others, by the numbers of the smaller and the larger one.
using Least_distances = std::map<std::pair<std::size_t, std::size_t>, double>;

// Raises coordinates until all are as far apart as they must be. Returns whether this is possible.
inline bool move_into_order(const Least_distances& distances, std::vector<double>& x)
{
  for(std::size_t round = 0; round <= x.size(); ++round)
  {
    bool has_changed = false;
    for(const auto& [pair, distance] : distances)
      if(const double least = x[pair.first] + distance; x[pair.second] < least)
      {
        x[pair.second] = least;
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

// Returns the coordinates along an axis that minimize the sum of area(i) (x(i) - moment(i) / area(i))^2 in the given orders, by
// exact quadratic programming; none if the orders contradict each other.
//
// The unknowns are differences from coordinates in these orders, as the solver takes far longer if it must find such ones first.
//
// Rounds distances up to multiples of the spacing, if there is one, and the solution to the planes of the grid. Moves the grid
// before, if it may move. As floor(x + 1/2) is monotone and commutes with adding integers, rounding keeps all distances.
inline std::optional<Ordered_coordinates>
ordered_coordinates_3(const std::vector<double>& areas, const std::vector<double>& moments,
                      const std::vector<Order_of_coordinates>& orders, const Plane_grid_3& grid, const int axis)
{
  const bool has_planes = grid.spacing > 0;
  const double scale = has_planes ? grid.spacing : 1, origin = has_planes ? grid.origin[axis] : 0;
  Least_distances distances;
  for(const auto& [first, second, distance] : orders)
  {
    if(first == second)
      return std::nullopt;
    double& largest = distances.emplace(std::pair(first, second), 0).first->second;
    largest = (std::max)(largest, has_planes ? std::ceil(distance / scale) : distance);
  }
  std::vector<double> wanted;
  for(std::size_t i = 0; i < areas.size(); ++i)
    wanted.push_back((moments[i] / areas[i] - origin) / scale);
  std::vector<double> start = wanted;
  if(has_planes) // so that differences are exact
    std::transform(start.begin(), start.end(), start.begin(), [](const double x) { return std::round(x); });
  if(!move_into_order(distances, start))
    return std::nullopt;
  Quadratic_program<double> program(LARGER, false, 0, false, 0);
  for(std::size_t i = 0; i < areas.size(); ++i)
  {
    const int variable = static_cast<int>(i);
    program.set_d(variable, variable, 2 * areas[i]);
    program.set_c(variable, 2 * areas[i] * (start[i] - wanted[i]));
  }
  int row = 0;
  for(const auto& [pair, distance] : distances)
  {
    program.set_a(static_cast<int>(pair.first), row, -1);
    program.set_a(static_cast<int>(pair.second), row, 1);
    program.set_b(row++, (std::min)(distance - (start[pair.second] - start[pair.first]), 0.));
  }
  const auto solution = solve_quadratic_program(program, Program_number());
  if(solution.is_infeasible())
    return std::nullopt;
  std::vector<double> x;
  for(auto it = solution.variable_values_begin(); x.size() < areas.size(); ++it)
    x.push_back(start[x.size()] + CGAL::to_double(*it));
  if(!has_planes)
    return Ordered_coordinates{ x, origin };
  const double shift = grid.may_move ? closest_shift_of_integers(areas, x) : 0;
  Ordered_coordinates result = { {}, origin + scale * shift };
  for(auto it = solution.variable_values_begin(); result.values.size() < areas.size(); ++it)
    result.values.push_back(result.origin + scale * (start[result.values.size()] + nearest_integer(*it - Program_number(shift))));
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_ORDERED_COORDINATES_3_H
