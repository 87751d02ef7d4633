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
  std::vector<Vector_3> corners;
  std::vector<std::vector<std::size_t> > sides_to_corner;  // in their order around the corner
  std::vector<std::array<std::size_t, 2> > closed_chains;   // charts on both sides of chains without a corner
  std::vector<int> inner_characteristic;                   // Euler characteristics of charts without their borders
};

// Counts the defects of charts if whole charts get other labels, from the sides of the chains alone: neighbors with equal
// labels are one chart then.
class Chart_defects_3
{
public:
  using Labels = std::vector<std::size_t>;

  Chart_defects_3(const Chart_borders_3& borders, const Labels& labels)
    : m_borders(borders), m_labels(labels), m_sides(borders.sides), m_whole(labels.size()),
      m_is_corner(borders.sides_to_corner.size(), false), m_is_followed(m_sides.size(), false),
      m_last(m_sides.size()), m_direction(m_sides.size()), m_defects(labels.size(), 0), m_characteristic(labels.size(), 0),
      m_turnings(labels.size())
  {
    std::iota(m_whole.begin(), m_whole.end(), 0);
    for(std::size_t s = 0; s < m_sides.size(); s += 2)
      unite(m_sides[s].chart, m_sides[s + 1].chart);
    for(const std::array<std::size_t, 2>& charts : m_borders.closed_chains)
      unite(charts[0], charts[1]);
    for(const Chart_borders_3::Side& side : m_sides)
    {
      m_chart.push_back(m_whole[side.chart]);
      m_label.push_back(m_labels[side.chart]);
    }
  }

  // Returns the defects of each chart: borders without a corner, corners where not all axes meet, edges of the polycube without a
  // direction or that turn back, and borders that are not those of a polygon. Charts that are one have them all at one chart.
  std::vector<int> count()
  {
    for(const std::array<std::size_t, 2>& charts : m_borders.closed_chains)
      if(m_labels[charts[0]] != m_labels[charts[1]])
        for(const std::size_t c : charts)
          add_closed_chain(m_whole[c]);
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
      if(m_whole[c] == c)
        m_defects[c] += distance_from_polygon(m_turnings[c], m_characteristic[c]);
    return m_defects;
  }

private:
  static constexpr int full_turn = 4; // right angles of a border

  // By how many right angles the borders of a chart turn left.
  struct Turnings
  {
    int number = 0, largest = 0, distance = 0; // distance: the sum of those from turns around holes

    void add(const int turning)
    {
      largest = number++ == 0 ? turning : (std::max)(largest, turning);
      distance += std::abs(turning + full_turn);
    }
  };

  static std::size_t opposite(const std::size_t side) { return side ^ 1; }

  void unite(const std::size_t c, const std::size_t d)
  {
    const std::size_t from = m_whole[c], to = m_whole[d];
    if(m_labels[c] == m_labels[d])
      std::replace(m_whole.begin(), m_whole.end(), from, to);
  }

  std::size_t chart(const std::size_t side) const { return m_chart[side]; }
  std::size_t label(const std::size_t side) const { return m_label[side]; }
  bool separates(const std::size_t side) const { return label(side) != label(opposite(side)); }

  // Returns the side that follows on the border of the chart.
  std::size_t next(std::size_t side) const
  {
    side = m_sides[side].next;
    while(!separates(side))
      side = m_sides[opposite(side)].next;
    return side;
  }

  // Adds the borders to the charts on both sides, and corners once to each chart there.
  void find_characteristics()
  {
    for(std::size_t c = 0; c < m_whole.size(); ++c)
      m_characteristic[m_whole[c]] += m_borders.inner_characteristic[c];
    for(std::size_t s = 0; s < m_sides.size(); ++s)
      if(s % 2 == 0 || separates(s))
        --m_characteristic[chart(s)];
    for(const std::vector<std::size_t>& sides : m_borders.sides_to_corner)
      for(auto it = sides.begin(); it != sides.end(); ++it)
        if(std::none_of(sides.begin(), it, [&](const std::size_t s) { return chart(s) == chart(*it); }))
          ++m_characteristic[chart(*it)];
  }

  // Finds whether a corner remains one, and counts a defect unless all three axes meet there.
  void visit_corner(const std::vector<std::size_t>& sides)
  {
    std::array<bool, 3> has_axis = {};
    int number_of_borders = 0;
    for(const std::size_t s : sides)
    {
      has_axis[axis_of_direction(label(s))] = true;
      number_of_borders += separates(s);
    }
    m_is_corner[m_sides[sides.front()].last] = number_of_borders > 2;
    if(number_of_borders > 2 && has_axis != std::array<bool, 3>{true, true, true})
      for(const std::size_t s : sides)
        m_defects[chart(s)] += separates(s);
  }

  // Follows the chain from the corner where its first side begins to the next corner.
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
    m_direction[side] = direction_of_edge(label(side), label(opposite(side)), m_borders.corners[m_sides[side].first],
                                          m_borders.corners[m_sides[s].last]);
  }

  // Follows a border from chain to chain, and sums up by how many right angles it turns left.
  void follow_border(const std::size_t side, std::vector<bool>& is_visited)
  {
    int turning = 0;
    for(std::size_t s = side; !is_visited[s]; s = next(m_last[s]))
    {
      is_visited[s] = true;
      const Eigen::Vector3i d = m_direction[s], e = m_direction[next(m_last[s])];
      m_defects[chart(side)] += d.isZero() || e == -d;
      turning += d.cross(e)[axis_of_direction(label(side))] * sign_of_direction(label(side));
    }
    m_turnings[chart(side)].add(turning);
  }

  void follow_closed_chain(const std::size_t side)
  {
    add_closed_chain(chart(side));
    for(std::size_t s = side; !m_is_followed[s]; s = next(s))
      m_is_followed[s] = true;
  }

  // Counts a border without a corner, which is a defect and has no turns.
  void add_closed_chain(const std::size_t chart)
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
  std::vector<std::size_t> m_whole; // for each chart, the one that stands for all of the chart that it is a part of now
  std::vector<std::size_t> m_chart, m_label; // by side: that chart, and its label
  std::vector<bool> m_is_corner, m_is_followed;
  std::vector<std::size_t> m_last;          // last side of the chain that begins with a side
  std::vector<Eigen::Vector3i> m_direction; // direction of the chain that begins with a side
  std::vector<int> m_defects, m_characteristic;
  std::vector<Turnings> m_turnings; // of the borders of each chart
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_CHART_DEFECTS_3_H
