// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_LINES_OF_BOX_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_LINES_OF_BOX_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Handles/Surface_line_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <cmath>
#include <numeric>

namespace CGAL::Polycube_meshing_3::internal {

// Four disjoint closed lines on the surface of a body with one handle that run along it as the edges of a box with a hole: the
// box is a bar with four sides that closes on itself. Each line crosses a meridian once, to its left; the meridian bounds a disc
// inside. Whatever their paths, disjoint lines with these crossings divide the surface as the edges do the box: into four rings,
// the top, the outside, the bottom and the inside. As the disc cuts the body into a ball, the body is mapped to the box, too.
//
// The lines are routed again and again, each along a path that is short and away from the other lines. A vertex of another
// line is the more expensive the longer lines contend for it, as nets on a chip (McMurchie, Ebeling, PathFinder, 1995).
class Lines_of_box_3
{
public:
  using Vertex = Boundary_mesh_3::Vertex_index;
  using Halfedge = Boundary_mesh_3::Halfedge_index;

  // Takes the meridian as a loop of vertices.
  Lines_of_box_3(const Boundary_mesh_3& mesh, const std::vector<std::size_t>& meridian)
    : m_mesh(mesh), m_is_on_meridian(mesh.number_of_vertices(), false), m_uses(mesh.number_of_vertices(), 0),
      m_prices(mesh.number_of_vertices(), 0)
  {
    Surface_line_3 loop = line_along(mesh, meridian);
    loop.push_back(mesh.halfedge(vertex_index(meridian.back()), vertex_index(meridian.front())));
    m_meridian = without_shortcuts(mesh, loop);
    for(const Halfedge h : m_meridian)
      m_is_on_meridian[mesh.source(h)] = true;
  }

  // Returns whether there is room for all lines.
  bool run(const Budget& budget)
  {
    const auto is_short = [](const Surface_line_3& line) { return line.size() < 4; };
    if(is_short(m_meridian) || !choose_crossings() || !separate(budget))
      return false;
    for(Surface_line_3& line : m_lines)
      line = without_shortcuts(m_mesh, line);
    return std::none_of(m_lines.begin(), m_lines.end(), is_short);
  }

  const Surface_line_3& meridian() const { return m_meridian; }

  // Returns a line, in their order along the meridian: above and below outside, below and above inside. Lines begin at the
  // meridian, and run counterclockwise as seen from above.
  const Surface_line_3& line(const std::size_t k) const { return m_lines[k]; }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  // Returns a closed path that crosses the meridian at one of its vertices, to the left, given the lengths of halfedges; none if
  // there is none.
  template <typename Length>
  Surface_line_3 path(const std::size_t crossing, const Length& length_of) const
  {
    const auto first = leaving(m_mesh, m_meridian, crossing, true), last = leaving(m_mesh, m_meridian, crossing, false);
    const Vertex source = m_mesh.source(m_meridian[crossing]);
    const Shortest_paths paths = shortest_paths_3(m_mesh, { source }, [&](const Halfedge h)
    {
      const bool is_open = !m_is_on_meridian[m_mesh.target(h)]
        && (m_mesh.source(h) != source || std::find(first.begin(), first.end(), h) != first.end());
      return is_open ? length_of(h) : infinity;
    });
    const auto whole = [&](const Halfedge h) { return paths.distance[m_mesh.target(h)] + length_of(h); };
    Surface_line_3 result;
    const auto end = std::min_element(last.begin(), last.end(), [&](const Halfedge h, const Halfedge k)
    { return whole(h) < whole(k); });
    if(end != last.end() && whole(*end) < infinity && m_mesh.target(*end) != source)
    {
      result = line_along(m_mesh, paths.path_to(m_mesh.target(*end)));
      result.push_back(m_mesh.opposite(*end));
    }
    return result;
  }

  // Lets a line inside cross the meridian where the shortest of some closed paths does, and the other lines at its other quarters.
  // Returns whether there is a path.
  bool choose_crossings()
  {
    constexpr std::size_t maximum_number_of_paths = 8; // a guess: each costs shortest paths on the whole surface
    const std::size_t n = m_meridian.size();
    double least = infinity;
    std::size_t best = 0;
    for(std::size_t i = 0; i < n; i += (n + maximum_number_of_paths - 1) / maximum_number_of_paths)
    {
      const Surface_line_3 line = path(i, [this](const Halfedge h) { return length(m_mesh, h); });
      if(const double l = length(m_mesh, line); !line.empty() && l < least)
      {
        least = l;
        best = i;
      }
    }
    m_crossings = quarters(m_mesh, m_meridian, best, 0);
    std::rotate(m_crossings.begin(), m_crossings.begin() + 2, m_crossings.end());
    return least < infinity;
  }

  void use(const Surface_line_3& line, const int times)
  {
    for(const Halfedge h : line)
      m_uses[m_mesh.source(h)] += times;
  }

  // Exchanges the pieces of two lines between the vertices where the lines meet. Lines that cross twice, kept on their wrong
  // sides by a narrow part of the surface, only touch then, and can be parted.
  void exchange_between_meetings(Surface_line_3& a, Surface_line_3& b) const
  {
    std::vector<std::pair<std::size_t, std::size_t> > meetings;
    for(std::size_t i = 1; i < a.size(); ++i)
      for(std::size_t j = 1; j < b.size(); ++j)
        if(m_mesh.source(a[i]) == m_mesh.source(b[j]) && (meetings.empty() || meetings.back().second < j))
          meetings.emplace_back(i, j);
    if(meetings.size() < 2)
      return;
    const auto [i, j] = meetings.front();
    const auto [i_end, j_end] = meetings.back();
    const Surface_line_3 between(a.begin() + i, a.begin() + i_end);
    a.erase(a.begin() + i, a.begin() + i_end);
    a.insert(a.begin() + i, b.begin() + j, b.begin() + j_end);
    b.erase(b.begin() + j, b.begin() + j_end);
    b.insert(b.begin() + j, between.begin(), between.end());
  }

  // Routes the lines until they are disjoint. Returns whether they are.
  bool separate(const Budget& budget)
  {
    constexpr int minimum_number_of_rounds = 4, rounds_between_exchanges = 4, maximum_number_of_rounds = 40; // guesses
    for(int round = 1;
        round <= maximum_number_of_rounds && budget.may_begin_round(Phase::BOUNDARY, "lines around handles"); ++round)
    {
      for(std::size_t k = 0; k < m_lines.size(); ++k)
        if(!route(k, 10 * round))
          return false;
      const bool do_meet = raise_prices();
      if(!do_meet && round >= minimum_number_of_rounds)
        return true;
      if(do_meet && round % rounds_between_exchanges == 0)
        for(std::size_t k = 0; k < m_lines.size(); ++k)
          for(std::size_t l = 0; l < k; ++l)
            exchange_between_meetings(m_lines[k], m_lines[l]);
    }
    return false;
  }

  // Routes a line along a path that is short and away from the others, whose vertices have a price. Returns whether there is one.
  bool route(const std::size_t k, const double price)
  {
    use(m_lines[k], -1);
    std::vector<Vertex> other_vertices;
    for(const Vertex v : m_mesh.vertices())
      if(m_uses[v] > 0)
        other_vertices.push_back(v);
    const Shortest_paths from_other_lines
      = shortest_paths_3(m_mesh, other_vertices, [this](const Halfedge h) { return length(m_mesh, h); });
    const double quarter = length(m_mesh, m_meridian) / 4;
    const auto factor = [&](const Vertex v)
    { return 1 + m_prices[v] + (m_uses[v] > 0 ? price : std::pow(quarter / from_other_lines.distance[v], 2)); };
    m_lines[k] = path(m_crossings[k], [&](const Halfedge h) { return length(m_mesh, h) * factor(m_mesh.target(h)); });
    use(m_lines[k], 1);
    return !m_lines[k].empty();
  }

  // Raises the prices of vertices where lines meet. Returns whether there are any.
  bool raise_prices()
  {
    bool do_meet = false;
    for(std::size_t v = 0; v < m_uses.size(); ++v)
      if(m_uses[v] > 1)
      {
        m_prices[v] += 10;
        do_meet = true;
      }
    return do_meet;
  }

  const Boundary_mesh_3& m_mesh;
  Surface_line_3 m_meridian;
  std::array<std::size_t, 4> m_crossings; // vertices of the meridian, of each line
  std::array<Surface_line_3, 4> m_lines;
  std::vector<bool> m_is_on_meridian;
  std::vector<int> m_uses;                // numbers of lines at vertices
  std::vector<double> m_prices;           // of vertices for which lines have contended
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_LINES_OF_BOX_3_H
