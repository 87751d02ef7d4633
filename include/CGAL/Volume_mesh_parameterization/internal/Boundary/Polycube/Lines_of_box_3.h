// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_LINES_OF_BOX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_LINES_OF_BOX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>

#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <numeric>
#include <optional>
#include <queue>

namespace CGAL::Volume_mesh_parameterization::internal {

// Shortest paths on a surface from some vertices, along halfedges that have lengths; infinite ones are not used.
struct Shortest_paths_3
{
  using Vertex = Boundary_mesh_3::Vertex_index;
  using Halfedge = Boundary_mesh_3::Halfedge_index;
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  std::vector<double> distance;
  std::vector<Halfedge> last; // of the path to each vertex

  template <typename Length>
  Shortest_paths_3(const Boundary_mesh_3& mesh, const std::vector<Vertex>& sources, const Length& length)
    : distance(mesh.number_of_vertices(), infinity), last(mesh.number_of_vertices())
  {
    using Entry = std::pair<double, Vertex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    const auto reach = [&](const Vertex v, const double d)
    {
      distance[v] = d;
      queue.push({ d, v });
    };
    for(const Vertex v : sources)
      reach(v, 0);
    while(!queue.empty())
    {
      const auto [d, v] = queue.top();
      queue.pop();
      if(d == distance[v])
        for(const Halfedge h : CGAL::halfedges_around_source(v, mesh))
          if(const double candidate = d + length(h); candidate < distance[mesh.target(h)])
          {
            last[mesh.target(h)] = h;
            reach(mesh.target(h), candidate);
          }
    }
  }

  // From the source, if the vertex has been reached.
  std::vector<Halfedge> path_to(const Boundary_mesh_3& mesh, Vertex v) const
  {
    std::vector<Halfedge> result;
    for(; distance[v] > 0; v = mesh.source(last[v]))
      result.push_back(last[v]);
    std::reverse(result.begin(), result.end());
    return result;
  }
};

using Surface_line_3 = std::vector<Boundary_mesh_3::Halfedge_index>;

// Where a line crosses a meridian, at its vertex with this number, and whether it goes on to the left of the meridian.
struct Crossing_3
{
  std::size_t meridian, place;
  bool leaves_left;
};

// A closed line on a surface, in parts from each crossing to the next one.
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
// box, a meridian is around the bar between each hole and the front. It crosses the two edges of its hole, and the two
// of the box, once each; the latter cross all meridians. Whatever their paths, disjoint lines with these crossings divide
// the surface as those edges do the box: into an upper and a lower part, and rings between them, all of genus zero.
// And as the meridians bound discs that cut the body into a ball, the body is mapped to the box, too.
//
// The lines are routed again and again, each along a path that is short and away from the others, and the more expensive at
// vertices of others the longer those are contended for, as nets on a chip (McMurchie, Ebeling, PathFinder, 1995).
class Lines_of_box_3
{
public:
  using Vertex = Boundary_mesh_3::Vertex_index;
  using Halfedge = Boundary_mesh_3::Halfedge_index;

  // Meridians are given by their vertices.
  Lines_of_box_3(const Boundary_mesh_3& mesh, const std::vector<std::vector<std::size_t> >& meridians)
    : m_mesh(mesh), m_is_on_meridian(mesh.number_of_vertices(), false), m_uses(mesh.number_of_vertices(), 0)
  {
    for(const std::vector<std::size_t>& vertices : meridians)
    {
      Surface_line_3 loop;
      for(std::size_t i = 0; i < vertices.size(); ++i)
        loop.push_back(mesh.halfedge(vertex(vertices[i]), vertex(vertices[(i + 1) % vertices.size()])));
      m_meridians.push_back(without_shortcuts(loop));
      for(const Halfedge h : m_meridians.back())
        m_is_on_meridian[mesh.source(h)] = true;
    }
  }

  // Returns whether there is place for all of them.
  bool run(const Budget& budget)
  {
    const auto is_short = [](const Surface_line_3& line) { return line.size() < 4; };
    if(std::any_of(m_meridians.begin(), m_meridians.end(), is_short) || !choose_crossings() || !separate(budget))
      return false;
    for(const Closed_line_3& line : m_lines)
      m_loops.push_back(without_shortcuts(line.whole()));
    return std::none_of(m_loops.begin(), m_loops.end(), is_short);
  }

  std::size_t number_of_holes() const { return m_meridians.size(); }
  const Surface_line_3& meridian(const std::size_t k) const { return m_meridians[k]; }
  const std::vector<Crossing_3>& crossings_of_box() const { return m_lines[0].crossings; } // from left to right

  // The two edges of the box, and those of the holes, all beginning at a meridian: those of a hole at its own one, those
  // of the box at that of the leftmost hole.
  const Surface_line_3& box(const bool is_first) const { return m_loops[is_first ? 0 : 1]; }
  const Surface_line_3& hole(const std::size_t k, const bool is_first) const { return m_loops[2 * k + (is_first ? 2 : 3)]; }

  // Where the crossings are on the first line of the box, as parts of its length.
  std::vector<double> crossings_along_box() const
  {
    std::vector<double> result(1, 0.);
    for(const Surface_line_3& part : m_lines[0].parts)
      result.push_back(result.back() + length(part));
    for(double& place : result)
      place /= result.back();
    result.pop_back();
    return result;
  }

  double length(const Halfedge h) const
  {
    return std::sqrt(CGAL::squared_distance(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h))));
  }

  double length(const Surface_line_3& line) const
  {
    return std::accumulate(line.begin(), line.end(), 0., [this](const double sum, const Halfedge h) { return sum + length(h); });
  }

  // The halfedges that leave a closed line to one side, where its i-th halfedge begins.
  std::vector<Halfedge> leaving(const Surface_line_3& line, const std::size_t i, const bool is_left) const
  {
    const Halfedge next = line[i], back = m_mesh.opposite(line[(i + line.size() - 1) % line.size()]);
    std::vector<Halfedge> result;
    const auto turn = [this](const Halfedge h) { return m_mesh.opposite(m_mesh.prev(h)); }; // to the left
    for(Halfedge h = turn(is_left ? next : back); h != (is_left ? back : next); h = turn(h))
      result.push_back(h);
    return result;
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  static Vertex vertex(const std::size_t v) { return Vertex(static_cast<Boundary_mesh_3::size_type>(v)); }

  // Two sides of a face in a row are replaced by the third one.
  Surface_line_3 without_shortcuts(Surface_line_3 line) const
  {
    for(std::size_t i = 0; i < line.size() && line.size() > 4; )
    {
      const std::size_t next = (i + 1) % line.size();
      const Halfedge a = line[i], b = line[next], back_a = m_mesh.opposite(a), back_b = m_mesh.opposite(b);
      if(m_mesh.next(a) != b && m_mesh.next(back_b) != back_a)
      {
        ++i;
        continue;
      }
      line[i] = m_mesh.next(a) == b ? m_mesh.opposite(m_mesh.next(b)) : m_mesh.prev(back_b);
      line.erase(line.begin() + next);
      i = 0;
    }
    return line;
  }

  // Vertices that divide a meridian into quarters, beginning with one.
  std::array<std::size_t, 4> quarters(const Surface_line_3& meridian, const std::size_t first) const
  {
    const std::size_t n = meridian.size();
    std::array<std::size_t, 4> result = { first };
    double sum = 0;
    for(std::size_t i = 0, k = 1; k < 4; ++k)
    {
      const auto next = [&] { return length(meridian[(first + i) % n]); };
      do
      {
        sum += next();
        ++i;
      }
      while(i + 4 < n + k && sum + next() / 2 < length(meridian) * static_cast<double>(k) / 4);
      result[k] = (first + i) % n;
    }
    return result;
  }

  // Finds the path of a line for lengths of halfedges. Returns whether there is one.
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
    const auto first = leaving(m_meridians[from.meridian], from.place, from.leaves_left);
    const auto last = leaving(m_meridians[to.meridian], to.place, !to.leaves_left);
    const Vertex source = m_mesh.source(m_meridians[from.meridian][from.place]);
    const Shortest_paths_3 paths(m_mesh, { source }, [&](const Halfedge h)
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
      result = paths.path_to(m_mesh, m_mesh.target(*end));
      result.push_back(m_mesh.opposite(*end));
    }
    return result;
  }

  // The lines of the holes cross where they are shortest, those of the box on the other side of the bars, each time at the next
  // meridian from there. The upper part is on the left of the lines of the box.
  bool choose_crossings()
  {
    const std::size_t g = number_of_holes();
    const auto length_of = [this](const Halfedge h) { return length(h); };
    std::vector<std::array<std::size_t, 4> > places(g);
    for(std::size_t k = 0; k < g; ++k)
    {
      double least = infinity;
      for(std::size_t i = 0; i < m_meridians[k].size(); i += (m_meridians[k].size() + 7) / 8)
      {
        const Crossing_3 crossing = { k, i, true };
        const Surface_line_3 line = path(crossing, crossing, length_of);
        if(!line.empty() && length(line) < least)
        {
          least = length(line);
          places[k] = quarters(m_meridians[k], i);
        }
      }
      if(least == infinity)
        return false;
    }

    m_lines.resize(2 + 2 * g);
    std::vector<bool> is_crossed(g, false);
    for(Crossing_3 crossing = { 0, places[0][2], true }; m_lines[0].crossings.size() < g; )
    {
      m_lines[0].crossings.push_back(crossing);
      is_crossed[crossing.meridian] = true;
      double least = infinity;
      Crossing_3 next = crossing;
      for(std::size_t k = 0; k < g; ++k)
        for(const bool leaves_left : { true, false })
          if(!is_crossed[k])
            if(const Surface_line_3 line = path(crossing, { k, places[k][2], leaves_left }, length_of);
               !line.empty() && length(line) < least)
            {
              least = length(line);
              next = { k, places[k][2], leaves_left };
            }
      crossing = next;
    }
    for(const Crossing_3& crossing : m_lines[0].crossings)
    {
      const std::size_t k = crossing.meridian;
      const auto [hole, one_side, box, other_side] = places[k];
      m_lines[1].crossings.push_back({ k, crossing.leaves_left ? other_side : one_side, crossing.leaves_left });
      m_lines[2 + 2 * k].crossings.push_back({ k, hole, true });
      m_lines[3 + 2 * k].crossings.push_back({ k, crossing.leaves_left ? one_side : other_side, true });
    }
    return true;
  }

  void use(const Closed_line_3& line, const int times)
  {
    for(const Surface_line_3& part : line.parts)
      for(const Halfedge h : part)
        m_uses[m_mesh.source(h)] += times;
  }

  bool separate(const Budget& budget)
  {
    constexpr int least_number_of_rounds = 4, most = 40;
    double quarter = 0; // of a meridian, in the mean
    for(const Surface_line_3& meridian : m_meridians)
      quarter += length(meridian) / 4 / static_cast<double>(number_of_holes());
    std::vector<double> history(m_uses.size(), 0);
    for(int round = 1; round <= most && !budget.is_exhausted(); ++round)
    {
      for(Closed_line_3& line : m_lines)
      {
        use(line, -1);
        std::vector<Vertex> others;
        for(const Vertex v : m_mesh.vertices())
          if(m_uses[v] > 0)
            others.push_back(v);
        const Shortest_paths_3 from_others(m_mesh, others, [this](const Halfedge h) { return length(h); });
        const auto factor = [&](const Vertex v)
        { return 1 + history[v] + (m_uses[v] > 0 ? 10 * round : std::pow(quarter / from_others.distance[v], 2)); };
        if(!route(line, [&](const Halfedge h) { return length(h) * factor(m_mesh.target(h)); }))
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
      if(is_separate && round >= least_number_of_rounds)
        return true;
    }
    return false;
  }

  const Boundary_mesh_3& m_mesh;
  std::vector<Surface_line_3> m_meridians, m_loops;
  std::vector<Closed_line_3> m_lines; // two of the box, then two of each hole
  std::vector<bool> m_is_on_meridian;
  std::vector<int> m_uses;            // of vertices by lines
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_LINES_OF_BOX_3_H
