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

// Crossing of a line and a meridian at the vertex of the meridian with an index.
struct Crossing_3
{
  std::size_t meridian, index;
  bool leaves_left; // whether the line continues to the left of the meridian
};

// Closed line on a surface, in parts from each crossing to the next one.
struct Closed_line_3
{
  std::vector<Crossing_3> crossings;
  std::vector<Surface_line_3> parts;

  Surface_line_3 whole() const
  {
    Surface_line_3 result;
    for(const Surface_line_3& part : parts)
      result.insert(result.end(), part.begin(), part.end());
    return result;
  }
};

// Disjoint lines on the surface of a body with handles that run as the edges of a box with holes from bottom to top. On the
// box, a meridian is around the bar between each hole and the front. A meridian crosses the two edges of its hole and the two
// edges of the box once each; the edges of the box cross all meridians. Whatever their paths, disjoint lines with these
// crossings divide the surface as the edges do the box: into an upper and a lower part, and rings between them, all of genus
// zero. As the meridians bound discs that cut the body into a ball, the body is mapped to the box, too.
//
// The lines are routed again and again, each along a path that is short and away from the other lines. A vertex of another
// line is the more expensive the longer lines contend for it, as nets on a chip (McMurchie, Ebeling, PathFinder, 1995).
class Lines_of_box_3
{
public:
  using Vertex = Boundary_mesh_3::Vertex_index;
  using Halfedge = Boundary_mesh_3::Halfedge_index;

  // Takes the meridians as loops of vertices.
  Lines_of_box_3(const Boundary_mesh_3& mesh, const std::vector<std::vector<std::size_t> >& meridians)
    : m_mesh(mesh), m_is_on_meridian(mesh.number_of_vertices(), false), m_uses(mesh.number_of_vertices(), 0)
  {
    for(const std::vector<std::size_t>& vertices : meridians)
    {
      Surface_line_3 loop;
      for(std::size_t i = 0; i < vertices.size(); ++i)
        loop.push_back(mesh.halfedge(vertex_index(vertices[i]), vertex_index(vertices[(i + 1) % vertices.size()])));
      m_meridians.push_back(without_shortcuts(mesh, loop));
      for(const Halfedge h : m_meridians.back())
        m_is_on_meridian[mesh.source(h)] = true;
    }
  }

  // Returns whether there is room for all lines.
  bool run(const Budget& budget)
  {
    const auto is_short = [](const Surface_line_3& line) { return line.size() < 4; };
    if(std::any_of(m_meridians.begin(), m_meridians.end(), is_short) || !choose_crossings() || !separate(budget))
      return false;
    for(const Closed_line_3& line : m_lines)
      m_loops.push_back(without_shortcuts(m_mesh, line.whole()));
    return std::none_of(m_loops.begin(), m_loops.end(), is_short);
  }

  std::size_t number_of_holes() const { return m_meridians.size(); }
  const Surface_line_3& meridian(const std::size_t k) const { return m_meridians[k]; }
  const std::vector<Crossing_3>& crossings_of_box() const { return m_lines[0].crossings; } // in their order from left to right

  // Return the upper or the lower line of the box and of each hole. A line of a hole begins at the meridian of the hole, a line
  // of the box at that of the leftmost hole.
  const Surface_line_3& box(const bool is_upper) const { return m_loops[is_upper ? 0 : 1]; }
  const Surface_line_3& hole(const std::size_t k, const bool is_upper) const { return m_loops[2 * k + (is_upper ? 2 : 3)]; }

  // Returns the positions of the crossings on the upper line of the box, as parts of its length.
  std::vector<double> crossings_along_box() const
  {
    std::vector<double> result(1, 0.);
    for(const Surface_line_3& part : m_lines[0].parts)
      result.push_back(result.back() + length(m_mesh, part));
    for(double& position : result)
      position /= result.back();
    result.pop_back();
    return result;
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  // Finds the path of a line, given the lengths of halfedges. Returns whether there is one.
  template <typename Length>
  bool route(Closed_line_3& line, const Length& length_of) const
  {
    const std::size_t n = line.crossings.size();
    line.parts.assign(n, {});
    for(std::size_t i = 0; i < n; ++i)
    {
      line.parts[i] = path(line.crossings[i], line.crossings[(i + 1) % n], length_of);
      if(line.parts[i].empty())
        return false;
    }
    return true;
  }

  template <typename Length>
  Surface_line_3 path(const Crossing_3& from, const Crossing_3& to, const Length& length_of) const
  {
    const auto first = leaving(m_mesh, m_meridians[from.meridian], from.index, from.leaves_left);
    const auto last = leaving(m_mesh, m_meridians[to.meridian], to.index, !to.leaves_left);
    const Vertex source = m_mesh.source(m_meridians[from.meridian][from.index]);
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

  // Chooses the crossings: a line of a hole crosses its meridian where the line is shortest, and the lines of the box cross on
  // the other side of the bar, each time at the nearest meridian next. The upper part is to the left of the lines of the box.
  bool choose_crossings()
  {
    const std::size_t g = number_of_holes();
    m_lines.resize(2 + 2 * g);
    std::vector<std::array<std::size_t, 4> > indices(g); // crossings of a line of the hole, one in each part, one of the box
    for(std::size_t k = 0; k < g; ++k)
    {
      const auto [length, crossing] = nearest(crossings_of_meridian(k), [](const Crossing_3& c) { return c; });
      if(length == infinity)
        return false;
      indices[k] = quarters(m_mesh, m_meridians[k], crossing.index, 0);
    }
    for(Crossing_3 crossing = { 0, indices[0][2], true }; ; )
    {
      const std::size_t k = crossing.meridian;
      const auto [hole, one_side, box, other_side] = indices[k];
      m_lines[0].crossings.push_back(crossing);
      m_lines[1].crossings.push_back({ k, crossing.leaves_left ? other_side : one_side, crossing.leaves_left });
      m_lines[2 + 2 * k].crossings.push_back({ k, hole, true });
      m_lines[3 + 2 * k].crossings.push_back({ k, crossing.leaves_left ? one_side : other_side, true });
      std::vector<Crossing_3> next;
      for(std::size_t i = 0; i < g; ++i)
        for(const bool leaves_left : { true, false })
          if(m_lines[2 + 2 * i].crossings.empty())
            next.push_back({ i, indices[i][2], leaves_left });
      if(next.empty())
        return true;
      crossing = nearest(next, [&](const Crossing_3&) { return crossing; }).second;
    }
  }

  std::vector<Crossing_3> crossings_of_meridian(const std::size_t k) const
  {
    constexpr std::size_t maximum_number_of_crossings = 8; // a guess: each costs shortest paths on the whole surface
    std::vector<Crossing_3> result;
    const std::size_t n = m_meridians[k].size();
    for(std::size_t i = 0; i < n; i += (n + maximum_number_of_crossings - 1) / maximum_number_of_crossings)
      result.push_back({ k, i, true });
    return result;
  }

  // Returns the crossing whose path, from the crossing that `from` returns, is shortest, and the length of the path.
  template <typename From>
  std::pair<double, Crossing_3> nearest(const std::vector<Crossing_3>& crossings, const From& from) const
  {
    std::pair<double, Crossing_3> result(infinity, crossings.front());
    for(const Crossing_3& to : crossings)
    {
      const Surface_line_3 line = path(from(to), to, [this](const Halfedge h) { return length(m_mesh, h); });
      if(!line.empty() && length(m_mesh, line) < result.first)
        result = { length(m_mesh, line), to };
    }
    return result;
  }

  void use(const Closed_line_3& line, const int times)
  {
    for(const Surface_line_3& part : line.parts)
      for(const Halfedge h : part)
        m_uses[m_mesh.source(h)] += times;
  }

  void exchange_between_meetings()
  {
    for(std::size_t k = 0; k < m_lines.size(); ++k)
      for(std::size_t l = 0; l < k; ++l)
        for(Surface_line_3& a : m_lines[k].parts)
          for(Surface_line_3& b : m_lines[l].parts)
            exchange_between_meetings(a, b);
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

  bool separate(const Budget& budget)
  {
    constexpr int minimum_number_of_rounds = 4, rounds_between_exchanges = 4, maximum_number_of_rounds = 40; // guesses
    double quarter = 0; // mean quarter of a meridian
    for(const Surface_line_3& meridian : m_meridians)
      quarter += length(m_mesh, meridian) / 4 / static_cast<double>(number_of_holes());
    std::vector<double> history(m_uses.size(), 0);
    for(int round = 1;
        round <= maximum_number_of_rounds && budget.may_begin_round(Phase::BOUNDARY, "lines around handles"); ++round)
    {
      for(Closed_line_3& line : m_lines)
      {
        use(line, -1);
        std::vector<Vertex> other_vertices;
        for(const Vertex v : m_mesh.vertices())
          if(m_uses[v] > 0)
            other_vertices.push_back(v);
        const Shortest_paths from_other_lines
          = shortest_paths_3(m_mesh, other_vertices, [this](const Halfedge h) { return length(m_mesh, h); });
        const auto factor = [&](const Vertex v)
        { return 1 + history[v] + (m_uses[v] > 0 ? 10 * round : std::pow(quarter / from_other_lines.distance[v], 2)); };
        if(!route(line, [&](const Halfedge h) { return length(m_mesh, h) * factor(m_mesh.target(h)); }))
          return false;
        use(line, 1);
      }
      bool is_separate = true;
      for(std::size_t v = 0; v < m_uses.size(); ++v)
        if(m_uses[v] > 1)
        {
          history[v] += 10;
          is_separate = false;
        }
      if(is_separate && round >= minimum_number_of_rounds)
        return true;
      if(!is_separate && round % rounds_between_exchanges == 0)
        exchange_between_meetings();
    }
    return false;
  }

  const Boundary_mesh_3& m_mesh;
  std::vector<Surface_line_3> m_meridians, m_loops;
  std::vector<Closed_line_3> m_lines; // two lines of the box, then two of each hole
  std::vector<bool> m_is_on_meridian;
  std::vector<int> m_uses;            // numbers of lines at vertices
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_LINES_OF_BOX_3_H
