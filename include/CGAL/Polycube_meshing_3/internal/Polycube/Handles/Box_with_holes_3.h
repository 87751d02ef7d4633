// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_BOX_WITH_HOLES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_BOX_WITH_HOLES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Handles/Lines_of_box_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Handles/coordinates_of_box_with_holes_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <optional>

namespace CGAL::Polycube_meshing_3::internal {

// Gives each face of the surface of a body with handles the label and the coordinate that its image has on a box with as
// many holes, which lead from the bottom to the top and are in a row from left to right. The lines of the box separate the
// top, the bottom, and rings; each ring is divided into four sides.
class Box_with_holes_3
{
public:
  using Vertex = Boundary_mesh_3::Vertex_index;
  using Halfedge = Boundary_mesh_3::Halfedge_index;
  using Face = Boundary_mesh_3::Face_index;

  Box_with_holes_3(const Boundary_mesh_3& mesh, const Lines_of_box_3& lines)
    : m_mesh(mesh), m_lines(lines), m_is_on_line(mesh.number_of_vertices(), false),
      m_is_line(mesh.number_of_edges(), false), m_chart(mesh.number_of_faces(), none)
  {
    for(const Crossing_3& crossing : lines.crossings_of_box())
      m_rings.push_back({ line_with_upper_part_on_left(crossing), lines.hole(crossing.meridian, false), true, {} });
    m_rings.push_back({ lines.box(true), lines.box(false), false, {} });
  }

  // Divides the surface, with the corners of each hole moved along its line by a number of vertices. Returns whether there is
  // room for all sides of the rings.
  bool run(const std::vector<int>& turns)
  {
    for(const Ring& ring : m_rings)
    {
      draw(ring.line);
      draw(ring.other_line);
    }
    for(std::size_t k = 0; k + 1 < m_rings.size(); ++k)
    {
      const int n = static_cast<int>(m_rings[k].line.size());
      m_rings[k].corners = quarters(m_mesh, m_rings[k].line, 0, 1 / 8.);
      for(std::size_t& corner : m_rings[k].corners)
        corner = static_cast<std::size_t>(((static_cast<int>(corner) + turns[k]) % n + n) % n);
    }
    const auto corners = corners_of_box();
    if(!corners)
      return false;
    m_rings.back().corners = *corners;
    return std::all_of(m_rings.begin(), m_rings.end(), [this](const Ring& ring) { return draw_corners(ring); })
           && find_charts();
  }

  const std::vector<std::size_t>& chart_of_face() const { return m_chart; }

  bool is_at_hole(const Vertex v, const std::size_t hole) const
  {
    const auto around = CGAL::halfedges_around_target(v, m_mesh);
    return std::any_of(around.begin(), around.end(), [&](const Halfedge h)
    {
      const std::size_t chart = m_chart[m_mesh.face(h)];
      return chart >= 2 && (chart - 2) / 4 == hole;
    });
  }

  std::vector<std::size_t> labels() const
  {
    // seen from above, a ring is passed with the top on its left: counterclockwise around the box, clockwise around holes
    constexpr std::size_t sides_of_box[] = { 0, 2, 1, 3 }, sides_of_hole[] = { 0, 3, 1, 2 };
    std::vector<std::size_t> result;
    for(const std::size_t chart : m_chart)
      result.push_back(chart < 2 ? 4 + chart : (is_of_box(chart) ? sides_of_box : sides_of_hole)[(chart - 2) % 4]);
    return result;
  }

  // Returns the coordinates of the images of the charts, along their axes.
  std::vector<double> coordinates(const bool may_be_long, const Plane_grid_3& grid) const
  {
    Measures_of_box_3 measures;
    for(std::size_t i = 0; i < m_lines.number_of_holes(); ++i)
    {
      measures.bar += length(m_mesh, m_lines.meridian(i)) / 4 / static_cast<double>(m_lines.number_of_holes());
      measures.widths.push_back(length(m_mesh, m_rings[i].line) / 4);
    }
    measures.front = length_of_front();
    measures.middles = middles_of_holes();
    for(const Face f : m_mesh.faces())
    {
      const double area = area_of_face(m_mesh, f);
      if(m_chart[f] < 2)
        measures.area_of_top += area / 2;
      else if(is_of_box(m_chart[f]))
        measures.area_of_sides += area;
    }
    return coordinates_of_box_with_holes_3(measures, may_be_long, grid);
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Ring between two lines. The other line is to the left of the line of a hole, and to the right of the line of the box.
  // Corners are numbers of vertices of the line at which the sides begin; the last side is in front.
  struct Ring
  {
    Surface_line_3 line, other_line;
    bool is_other_on_left;
    std::array<std::size_t, 4> corners;
  };

  bool is_of_box(const std::size_t chart) const { return chart >= 2 + 4 * m_lines.number_of_holes(); }

  void draw(const Surface_line_3& line)
  {
    for(const Halfedge h : line)
    {
      m_is_on_line[m_mesh.source(h)] = m_is_on_line[m_mesh.target(h)] = true;
      m_is_line[m_mesh.edge(h)] = true;
    }
  }

  // Returns the line of a hole with the upper part to its left, reversed if need be. The line leaves its meridian to the left,
  // so the meridian continues to its right: into the upper part if the line of the box leaves to the left, too.
  Surface_line_3 line_with_upper_part_on_left(const Crossing_3& crossing_of_box) const
  {
    Surface_line_3 line = m_lines.hole(crossing_of_box.meridian, true);
    if(crossing_of_box.leaves_left)
    {
      std::reverse(line.begin(), line.end());
      for(Halfedge& h : line)
        h = m_mesh.opposite(h);
    }
    return line;
  }

  // Returns the corners of the box: right in front, right behind, left behind, left in front. The corners are near those of
  // the holes on both ends, behind the last meridian; none if there are not four vertices.
  std::optional<std::array<std::size_t, 4> > corners_of_box() const
  {
    const Surface_line_3& line = m_rings.back().line;
    const Ring &left = m_rings.front(), &right = m_rings[m_rings.size() - 2];
    const std::array<Halfedge, 4> goals = { right.line[right.corners[3]], right.line[right.corners[2]],
                                            left.line[left.corners[1]], left.line[left.corners[0]] };
    double rest = length(m_mesh, line) * m_lines.crossings_along_box().back();
    std::size_t begin = 0;
    for(; rest > 0 && begin < line.size(); ++begin)
      rest -= length(m_mesh, line[begin]);

    // Minimizes the sum of distances of four vertices in order to their goals: `sum[k][i]` is the least one for the first
    // k + 1 vertices if the last of them is vertex i.
    std::array<std::vector<double>, 4> sum;
    std::array<std::vector<std::size_t>, 4> previous;
    for(std::size_t k = 0; k < 4; ++k)
    {
      const Shortest_paths paths
        = shortest_paths_3(m_mesh, { m_mesh.source(goals[k]) }, [this](const Halfedge h) { return length(m_mesh, h); });
      std::size_t best = none;
      for(std::size_t i = 0; i < line.size(); ++i)
      {
        if(k > 0 && i > 0 && (best == none || sum[k - 1][i - 1] < sum[k - 1][best]))
          best = i - 1;
        const bool is_out_of_reach = k == 0 ? i < begin : best == none;
        const double before = is_out_of_reach ? Shortest_paths::infinity : k == 0 ? 0 : sum[k - 1][best];
        sum[k].push_back(before + paths.distance[m_mesh.source(line[i])]);
        previous[k].push_back(best);
      }
    }
    std::array<std::size_t, 4> result;
    result[3] = std::min_element(sum[3].begin(), sum[3].end()) - sum[3].begin();
    if(sum[3][result[3]] == Shortest_paths::infinity)
      return std::nullopt;
    for(std::size_t k = 3; k > 0; --k)
      result[k - 1] = previous[k][result[k]];
    return result;
  }

  double length_of_part(const Ring& ring, const std::size_t begin, const std::size_t end) const
  { return length(m_mesh, Surface_line_3(ring.line.begin() + begin, ring.line.begin() + end)); }

  double length_of_front() const
  {
    const Ring& box = m_rings.back();
    return length_of_part(box, box.corners[3], box.line.size()) + length_of_part(box, 0, box.corners[0]);
  }

  // Returns at which parts of the front the meridians cross the line of the box.
  std::vector<double> middles_of_holes() const
  {
    const Ring& box = m_rings.back();
    const double before = length_of_part(box, box.corners[3], box.line.size()), front = length_of_front();
    std::vector<double> result;
    for(const double position : m_lines.crossings_along_box())
      result.push_back((before + position * length(m_mesh, box.line)) / front);
    return result;
  }

  // Draws disjoint paths from the corners of a ring to its other line. Returns whether there are paths.
  bool draw_corners(const Ring& ring)
  {
    std::vector<bool> is_goal(m_mesh.number_of_vertices(), false);
    for(const Halfedge h : ring.other_line)
      is_goal[m_mesh.source(h)] = true;
    for(const std::size_t corner : ring.corners)
    {
      const auto first = leaving(m_mesh, ring.line, corner, ring.is_other_on_left);
      const Vertex source = m_mesh.source(ring.line[corner]);
      const Shortest_paths paths = shortest_paths_3(m_mesh, { source }, [&](const Halfedge h)
      {
        const Vertex v = m_mesh.source(h), w = m_mesh.target(h);
        const bool is_open = v == source ? std::find(first.begin(), first.end(), h) != first.end() : !m_is_on_line[v];
        return is_open && (is_goal[w] || !m_is_on_line[w]) ? length(m_mesh, h) : Shortest_paths::infinity;
      });
      Vertex goal = source;
      for(const Halfedge h : ring.other_line)
        if(const Vertex v = m_mesh.source(h); is_goal[v] && (goal == source || paths.distance[v] < paths.distance[goal]))
          goal = v;
      if(goal == source || paths.distance[goal] == Shortest_paths::infinity)
        return false;
      is_goal[goal] = false;
      draw(line_along(m_mesh, paths.path_to(goal)));
    }
    return true;
  }

  // Finds the charts that the lines separate. Returns whether they are the top, the bottom and the sides of rings alone.
  bool find_charts()
  {
    std::vector<std::size_t> part(m_mesh.number_of_faces());
    const auto is_line = boost::make_function_property_map<Boundary_mesh_3::Edge_index>(
      [this](const Boundary_mesh_3::Edge_index e) { return m_is_line[e]; });
    const std::size_t n = Polygon_mesh_processing::connected_components(
      m_mesh, boost::make_iterator_property_map(part.begin(), get(boost::face_index, m_mesh)),
      parameters::edge_is_constrained_map(is_line));
    std::vector<std::size_t> chart_of_part(n, none);
    std::size_t number = 0;
    const auto number_part_of = [&](const Halfedge h) { chart_of_part[part[m_mesh.face(h)]] = number++; };
    number_part_of(m_rings.back().line[0]);
    number_part_of(m_mesh.opposite(m_rings[0].line[0]));
    for(const Ring& ring : m_rings)
      for(const std::size_t corner : ring.corners)
        number_part_of(ring.is_other_on_left ? ring.line[corner] : m_mesh.opposite(ring.line[corner]));
    std::transform(part.begin(), part.end(), m_chart.begin(), [&](const std::size_t p) { return chart_of_part[p]; });
    return n == number && std::count(chart_of_part.begin(), chart_of_part.end(), none) == 0;
  }

  const Boundary_mesh_3& m_mesh;
  const Lines_of_box_3& m_lines;
  std::vector<Ring> m_rings; // rings of the holes from left to right, and of the box
  std::vector<bool> m_is_on_line, m_is_line;
  std::vector<std::size_t> m_chart; // charts of faces: the top, the bottom, and four sides of each ring
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_BOX_WITH_HOLES_3_H
