// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_BOX_WITH_HOLE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_BOX_WITH_HOLE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Handles/Lines_of_box_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/ordered_coordinates_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <optional>

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

// Gives each face of the surface of a body with one handle the label and the coordinate that its image has on a box with a hole,
// which leads from the bottom to the top. The lines of the box separate the top, the bottom, the outside and the inside; the
// last two are rings, each of which is divided into four sides: right, back, left and front, as seen from the middle.
class Box_with_hole_3
{
public:
  using Vertex = Boundary_mesh_3::Vertex_index;
  using Halfedge = Boundary_mesh_3::Halfedge_index;
  using Face = Boundary_mesh_3::Face_index;

  Box_with_hole_3(const Boundary_mesh_3& mesh, const Lines_of_box_3& lines)
    : m_mesh(mesh), m_lines(lines), m_inside{ lines.line(2), lines.line(3), {} }, m_outside{ lines.line(0), lines.line(1), {} },
      m_is_on_line(mesh.number_of_vertices(), false), m_is_line(mesh.number_of_edges(), false),
      m_chart(mesh.number_of_faces(), none)
  {}

  // Divides the surface. Returns whether there is room for all sides of the rings.
  bool run()
  {
    for(std::size_t k = 0; k < 4; ++k)
      draw(m_lines.line(k));
    m_inside.corners = quarters(m_mesh, m_inside.line, 0, 1 / 8.);
    const auto corners = corners_outside();
    if(!corners)
      return false;
    m_outside.corners = *corners;
    return draw_corners(m_inside) && draw_corners(m_outside) && find_charts();
  }

  const std::vector<std::size_t>& chart_of_face() const { return m_chart; }

  std::vector<std::size_t> labels() const
  {
    constexpr std::array<std::size_t, 10> labels_of_charts = { 4, 5, 1, 3, 0, 2, 0, 2, 1, 3 }; // sides inside face the middle
    std::vector<std::size_t> result;
    for(const std::size_t chart : m_chart)
      result.push_back(labels_of_charts[chart]);
    return result;
  }

  // Returns the coordinates of the images of the charts, along their axes.
  std::vector<double> coordinates(const Plane_grid_3& grid) const
  {
    const double before = length_outside(m_outside.corners[3], m_outside.line.size()),
                 front = before + length_outside(0, m_outside.corners[0]);
    Measures_of_box_3 measures
      = { length(m_mesh, m_lines.meridian()) / 4, length(m_mesh, m_inside.line) / 4, front, before / front, 0, 0 };
    for(const Face f : m_mesh.faces())
    {
      const double area = area_of_face(m_mesh, f);
      if(m_chart[f] < 2)
        measures.area_of_top += area / 2;
      else if(m_chart[f] >= 6)
        measures.area_of_sides += area;
    }
    return coordinates_of_box_with_hole_3(measures, grid);
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Ring between two lines, the other one to the right. Corners are numbers of vertices of the line at which the sides begin; the
  // last side, in front, has the begin of the line.
  struct Ring
  {
    Surface_line_3 line, other_line;
    std::array<std::size_t, 4> corners;
  };

  void draw(const Surface_line_3& line)
  {
    for(const Halfedge h : line)
    {
      m_is_on_line[m_mesh.source(h)] = m_is_on_line[m_mesh.target(h)] = true;
      m_is_line[m_mesh.edge(h)] = true;
    }
  }

  double length_outside(const std::size_t begin, const std::size_t end) const
  { return length(m_mesh, Surface_line_3(m_outside.line.begin() + begin, m_outside.line.begin() + end)); }

  // Returns the corners outside: four vertices in the order of the line with the least sum of distances from the corners inside;
  // none if there are not four vertices.
  std::optional<std::array<std::size_t, 4> > corners_outside() const
  {
    const Surface_line_3& line = m_outside.line;
    // `sum[k][i]` is the least sum for the first k + 1 vertices if the last of them is vertex i
    std::array<std::vector<double>, 4> sum;
    std::array<std::vector<std::size_t>, 4> previous;
    for(std::size_t k = 0; k < 4; ++k)
    {
      const Shortest_paths paths = shortest_paths_3(m_mesh, { m_mesh.source(m_inside.line[m_inside.corners[k]]) },
                                                    [this](const Halfedge h) { return length(m_mesh, h); });
      std::size_t best = none;
      for(std::size_t i = 0; i < line.size(); ++i)
      {
        if(k > 0 && i > 0 && (best == none || sum[k - 1][i - 1] < sum[k - 1][best]))
          best = i - 1;
        const double before = k == 0 ? 0 : best == none ? Shortest_paths::infinity : sum[k - 1][best];
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

  // Draws disjoint paths from the corners of a ring to its other line. Returns whether there are paths.
  bool draw_corners(const Ring& ring)
  {
    std::vector<bool> is_goal(m_mesh.number_of_vertices(), false);
    for(const Halfedge h : ring.other_line)
      is_goal[m_mesh.source(h)] = true;
    for(const std::size_t corner : ring.corners)
    {
      const auto first = leaving(m_mesh, ring.line, corner, false);
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
    number_part_of(m_outside.line[0]); // the top
    number_part_of(m_inside.line[0]);  // the bottom
    for(const Ring& ring : { m_inside, m_outside })
      for(const std::size_t corner : ring.corners)
        number_part_of(m_mesh.opposite(ring.line[corner]));
    std::transform(part.begin(), part.end(), m_chart.begin(), [&](const std::size_t p) { return chart_of_part[p]; });
    return n == number && std::count(chart_of_part.begin(), chart_of_part.end(), none) == 0;
  }

  const Boundary_mesh_3& m_mesh;
  const Lines_of_box_3& m_lines;
  Ring m_inside, m_outside; // from below to above, and from above to below
  std::vector<bool> m_is_on_line, m_is_line;
  std::vector<std::size_t> m_chart; // charts of faces: the top, the bottom, and four sides of each ring
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_BOX_WITH_HOLE_3_H
