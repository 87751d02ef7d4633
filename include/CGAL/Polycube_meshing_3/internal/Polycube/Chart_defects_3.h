// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_CHART_DEFECTS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_CHART_DEFECTS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/directions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the direction of the edge of a polycube between faces with two labels, in which the last point lies from the first
// one; zero if the labels have the same axis, or the points the same coordinate.
inline Eigen::Vector3i direction_of_edge(const std::size_t label, const std::size_t other_label,
                                         const Vector_3& first, const Vector_3& last)
{
  Eigen::Vector3i result = Eigen::Vector3i::Zero();
  const int a = axis_of_direction(label), b = axis_of_direction(other_label), axis = 3 - a - b;
  if(a != b)
    result[axis] = (last[axis] > first[axis]) - (last[axis] < first[axis]);
  return result;
}

// Chains between charts, from corner to corner, without the surface that they are on.
struct Chart_borders_3
{
  // Side of a chain, part of the border of a chart. Side 2 i + 1 leads back along side 2 i.
  struct Side
  {
    std::size_t chart, next;  // next: the side that follows on the border of the chart
    std::size_t first, last;  // corners
  };

  std::vector<Side> sides;
  std::vector<Vector_3> corners; // points
  std::vector<std::vector<std::size_t> > sides_to_corner;  // of each corner: sides that end there, in their order around it
  std::vector<std::array<std::size_t, 2> > closed_chains;   // charts on both sides of chains without a corner
  std::vector<int> inner_characteristic;                   // Euler characteristics of charts without their borders
};

// Counts the defects of charts if whole charts get other labels, from the sides of the chains alone. Neighbors with equal labels
// are united to one chart then, which one of them represents.
class Chart_defects_3
{
public:
  using Labels = std::vector<std::size_t>;

  Chart_defects_3(const Chart_borders_3& borders, const Labels& labels)
    : m_borders(borders), m_labels(labels), m_sides(borders.sides), m_representative(labels.size()),
      m_is_corner(borders.sides_to_corner.size(), false), m_is_followed(m_sides.size(), false),
      m_last(m_sides.size()), m_direction(m_sides.size()), m_defects(labels.size(), 0), m_characteristic(labels.size(), 0),
      m_turnings(labels.size())
  {
    std::iota(m_representative.begin(), m_representative.end(), 0);
    for(std::size_t s = 0; s < m_sides.size(); s += 2)
      unite_if_equal(m_sides[s].chart, m_sides[s + 1].chart);
    for(const std::array<std::size_t, 2>& charts : m_borders.closed_chains)
      unite_if_equal(charts[0], charts[1]);
    for(const Chart_borders_3::Side& side : m_sides)
    {
      m_chart.push_back(m_representative[side.chart]);
      m_label.push_back(m_labels[side.chart]);
    }
  }

  // Returns the number of defects of each chart: borders without a corner, corners where not all axes meet, edges of the polycube
  // without a direction or that turn back, and borders that are not those of a polygon. Defects of united charts are those of the
  // chart that represents them.
  std::vector<int> count()
  {
    for(const std::array<std::size_t, 2>& charts : m_borders.closed_chains)
      if(m_labels[charts[0]] != m_labels[charts[1]])
        for(const std::size_t c : charts)
          add_border_without_corner(m_representative[c]);
    find_characteristics();
    for(const std::vector<std::size_t>& sides : m_borders.sides_to_corner)
      visit_corner(sides);
    for(std::size_t s = 0; s < m_sides.size(); ++s)
      if(separates(s) && m_is_corner[m_sides[s].first])
        follow_chain(s);
    std::vector<bool> is_visited(m_sides.size(), false);
    for(std::size_t s = 0; s < m_sides.size(); ++s)
      if(separates(s) && m_is_corner[m_sides[s].first] && !is_visited[s])
        follow_border(s, is_visited);
    for(std::size_t s = 0; s < m_sides.size(); ++s)
      if(separates(s) && !m_is_followed[s])
        follow_closed_chain(s);
    for(std::size_t c = 0; c < m_defects.size(); ++c)
      if(m_representative[c] == c)
        m_defects[c] += distance_from_polygon(m_turnings[c], m_characteristic[c]);
    return m_defects;
  }

private:
  static constexpr int full_turn = 4; // right angles of a border

  // By how many right angles the borders of a chart turn left.
  struct Turnings
  {
    int number = 0, largest = 0, distance = 0; // of borders, of the turnings, and the sum of distances from turns around holes

    void add(const int turning)
    {
      largest = number++ == 0 ? turning : (std::max)(largest, turning);
      distance += std::abs(turning + full_turn);
    }
  };

  static std::size_t opposite(const std::size_t side) { return side ^ 1; }

  // Unites two charts if their labels are equal.
  void unite_if_equal(const std::size_t c, const std::size_t d)
  {
    const std::size_t from = m_representative[c], to = m_representative[d];
    if(m_labels[c] == m_labels[d])
      std::replace(m_representative.begin(), m_representative.end(), from, to);
  }

  bool separates(const std::size_t side) const { return m_label[side] != m_label[opposite(side)]; }

  // Returns the side that follows on the border of the chart.
  std::size_t next(std::size_t side) const
  {
    side = m_sides[side].next;
    while(!separates(side))
      side = m_sides[opposite(side)].next;
    return side;
  }

  // Finds the Euler characteristics of charts with their borders: borders count on both sides, and corners once for each chart.
  void find_characteristics()
  {
    for(std::size_t c = 0; c < m_representative.size(); ++c)
      m_characteristic[m_representative[c]] += m_borders.inner_characteristic[c];
    for(std::size_t s = 0; s < m_sides.size(); ++s)
      if(s % 2 == 0 || separates(s))
        --m_characteristic[m_chart[s]];
    for(const std::vector<std::size_t>& sides : m_borders.sides_to_corner)
      for(auto it = sides.begin(); it != sides.end(); ++it)
        if(std::none_of(sides.begin(), it, [&](const std::size_t s) { return m_chart[s] == m_chart[*it]; }))
          ++m_characteristic[m_chart[*it]];
  }

  // Finds whether a corner remains one, and counts a defect unless all three axes meet there.
  void visit_corner(const std::vector<std::size_t>& sides)
  {
    std::array<bool, 3> has_axis = {};
    int number_of_borders = 0;
    for(const std::size_t s : sides)
    {
      has_axis[axis_of_direction(m_label[s])] = true;
      number_of_borders += separates(s);
    }
    m_is_corner[m_sides[sides.front()].last] = number_of_borders > 2;
    if(number_of_borders > 2 && has_axis != std::array<bool, 3>{true, true, true})
      for(const std::size_t s : sides)
        m_defects[m_chart[s]] += separates(s);
  }

  // Finds the last side and the direction of the chain that begins with a side at a corner.
  void follow_chain(const std::size_t side)
  {
    std::size_t s = side;
    m_is_followed[s] = true;
    while(!m_is_corner[m_sides[s].last])
    {
      s = next(s);
      m_is_followed[s] = true;
    }
    m_last[side] = s;
    m_direction[side] = direction_of_edge(m_label[side], m_label[opposite(side)], m_borders.corners[m_sides[side].first],
                                          m_borders.corners[m_sides[s].last]);
  }

  // Follows a border from chain to chain. Counts edges without a direction or that turn back, and sums up the left turns.
  void follow_border(const std::size_t side, std::vector<bool>& is_visited)
  {
    int turning = 0;
    for(std::size_t s = side; !is_visited[s]; s = next(m_last[s]))
    {
      is_visited[s] = true;
      const Eigen::Vector3i d = m_direction[s], e = m_direction[next(m_last[s])];
      m_defects[m_chart[side]] += d.isZero() || e == -d;
      turning += d.cross(e)[axis_of_direction(m_label[side])] * sign_of_direction(m_label[side]);
    }
    m_turnings[m_chart[side]].add(turning);
  }

  // Counts the border along a chain that has lost its corners.
  void follow_closed_chain(const std::size_t side)
  {
    add_border_without_corner(m_chart[side]);
    for(std::size_t s = side; !m_is_followed[s]; s = next(s))
      m_is_followed[s] = true;
  }

  // Counts a border without a corner, which is a defect and has no turns.
  void add_border_without_corner(const std::size_t chart)
  {
    ++m_defects[chart];
    m_turnings[chart].add(0);
  }

  // Returns how far the borders of a chart are from those of a polygon with holes, in right angles. The outer border of a polygon
  // turns left once, each hole turns right once, and there is no handle.
  static int distance_from_polygon(const Turnings& turnings, const int characteristic)
  {
    const int outer = turnings.largest, twice_number_of_handles = std::abs(2 - turnings.number - characteristic);
    return full_turn * twice_number_of_handles + turnings.distance // which takes the outer border for a hole
      + (turnings.number > 0 ? std::abs(outer - full_turn) - std::abs(outer + full_turn) : 0);
  }

  const Chart_borders_3& m_borders;
  const Labels& m_labels;
  const std::vector<Chart_borders_3::Side>& m_sides;
  std::vector<std::size_t> m_representative; // of the united charts that a chart is one of
  std::vector<std::size_t> m_chart, m_label; // by side: the representative of its chart, and the label
  std::vector<bool> m_is_corner, m_is_followed; // by corner, whether it remains one; by side
  std::vector<std::size_t> m_last;          // last side of the chain that begins with a side
  std::vector<Eigen::Vector3i> m_direction; // direction of the chain that begins with a side
  std::vector<int> m_defects, m_characteristic;
  std::vector<Turnings> m_turnings; // of the borders of each chart
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_CHART_DEFECTS_3_H
