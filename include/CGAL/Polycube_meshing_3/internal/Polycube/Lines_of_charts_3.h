// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_LINES_OF_CHARTS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_LINES_OF_CHARTS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Search_for_lines_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/ordered_coordinates_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Chart_relaxation_2.h>

#include <optional>
#include <set>

namespace CGAL::Polycube_meshing_3::internal {

// Sharp edges inside charts as lines in faces of the polycube, each along an axis: vertices of a line get one value of the other
// coordinate of the face. So planes of a grid through it lead along the sharp edges of the body.
//
// Lines that meet at a vertex, in one chart or on both sides of an edge of the polycube, have one value if they are held
// along the same axis there and are not side by side. Values are the mean, or with planes of a grid the nearest one, or one half
// or a quarter of the way to the next plane where that is clearly nearer or the planes have no room, such that lines and edges
// keep the order that they have without lines. The longest lines join and choose first, and those without a value are given up.
class Lines_of_charts_3
{
public:
  static constexpr double smallest_part_of_spacing = 0.25; // a guess; between lines, a power of 2 for exact multiples

  using Vertex = Boundary_mesh_3::Vertex_index;
  using Halfedge = Boundary_mesh_3::Halfedge_index;

  // Takes the images of a map without lines, and whether each edge of the mesh is sharp.
  Lines_of_charts_3(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts, const std::vector<bool>& is_sharp,
                    const Plane_grid_3& grid, const std::vector<Vector_3>& images)
    : m_mesh(mesh), m_charts(charts), m_grid(grid), m_images(images),
      m_is_bound(images.size(), { false, false, false }), m_positions(charts.number_of_charts() + charts.chains().size())
  {
    add_edges_of_polycube();
    join_lines(Search_for_lines_3(mesh, charts, is_sharp, images).lines());
    choose_values();
  }

  // Returns whether no line has a value.
  bool are_empty() const
  { return std::none_of(m_planes.begin(), m_planes.end(), [](const Plane& plane) { return plane.value.has_value(); }); }

  // Gives up the lines of the shortest plane with a line at a flipped face. If there is none, gives up those of the shortest plane
  // with a line in a chart of a flipped face or beside it. Returns whether any were given up.
  bool give_up(const std::vector<Boundary_mesh_3::Face_index>& flipped_faces)
  {
    std::vector<bool> is_chart_bad(m_charts.number_of_charts(), false), is_vertex_bad(m_images.size(), false);
    for(const auto f : flipped_faces)
      for(const Halfedge h : CGAL::halfedges_around_face(m_mesh.halfedge(f), m_mesh))
      {
        is_chart_bad[m_charts.chart(h)] = is_chart_bad[m_charts.chart(m_mesh.opposite(h))] = true;
        is_vertex_bad[m_mesh.target(h)] = true;
      }
    const auto is_in_bad_chart = [&](const Line_of_chart_3& line) { return is_chart_bad[line.chart]; };
    const auto is_at_bad_face = [&](const Line_of_chart_3& line)
    { return std::any_of(line.vertices.begin(), line.vertices.end(), [&](const Vertex v) { return is_vertex_bad[v]; }); };
    return give_up_shortest(is_at_bad_face) || give_up_shortest(is_in_bad_chart);
  }

  // Gives the vertices of lines their values, and holds these coordinates.
  void apply(std::vector<Vector_3>& images, Held_coordinates& is_held) const
  {
    for(const Plane& plane : m_planes)
      for(const Line_of_chart_3& line : plane.lines)
        for(const Vertex v : line.vertices)
          if(plane.value)
          {
            images[v][plane.axis] = *plane.value;
            is_held[v][plane.axis] = true;
          }
  }

private:
  // Plane of lines with one value.
  struct Plane
  {
    std::vector<Line_of_chart_3> lines;
    int axis;
    double mean, length; // of the images of the lines: coordinate along the axis, sum of lengths
    std::optional<double> value;
  };

  // Position of an edge of the polycube or a line in a chart: old and new coordinate along an axis, and the extent along the other
  // one. Ends of edges and lines on an edge of the polycube have positions, too, with equal extents: all of them are compared.
  struct Position
  {
    int axis;
    double old_value, new_value;
    double low = 0, high = 1;
  };

  // Gives up the shortest plane with a value and a bad line. Returns whether there was one.
  template <typename Predicate>
  bool give_up_shortest(const Predicate& is_bad)
  {
    const auto shortest = std::find_if(m_planes.rbegin(), m_planes.rend(), [&](const Plane& plane)
                                       { return plane.value && std::any_of(plane.lines.begin(), plane.lines.end(), is_bad); });
    if(shortest == m_planes.rend())
      return false;
    shortest->value.reset();
    return true;
  }

  // Adds the positions of edges of the polycube in their charts, and of the ends on the edges. Their coordinates stay.
  void add_edges_of_polycube()
  {
    m_chain_of_vertex.assign(m_images.size(), -1);
    for(std::size_t i = 0; i < m_charts.chains().size(); ++i)
    {
      const Polycube_chain_3& chain = m_charts.chains()[i];
      const std::vector<Vertex> path = m_charts.vertices(chain);
      const Vector_3 first = m_images[path.front()], last = m_images[path.back()];
      for(const std::size_t c : chain.charts)
      {
        const int axis = other_axis(m_charts, c, chain.axis);
        const auto [low, high] = std::minmax(first[chain.axis], last[chain.axis]);
        m_positions[c].push_back({ axis, first[axis], first[axis], low, high });
        for(const Vertex v : path)
          m_is_bound[v][axis] = true;
      }
      for(const Vector_3& p : { first, last })
        m_positions[index_of_chain(i)].push_back({ chain.axis, p[chain.axis], p[chain.axis] });
      for(std::size_t k = 1; k + 1 < path.size(); ++k)
        m_chain_of_vertex[path[k]] = static_cast<int>(i);
    }
  }

  // Makes planes of lines that share a vertex and the axis across, the longest ones first. A line that would join lines side by
  // side is left out.
  void join_lines(const std::vector<Line_of_chart_3>& lines)
  {
    for(const Line_of_chart_3& line : lines)
      m_planes.push_back(plane_of({ line }));
    const auto is_longer = [](const Plane& a, const Plane& b) { return a.length > b.length; };
    std::stable_sort(m_planes.begin(), m_planes.end(), is_longer);
    std::vector<Plane> joined;
    for(const Plane& next : m_planes)
    {
      std::vector<Line_of_chart_3> together = next.lines;
      std::vector<Plane> others;
      for(const Plane& plane : joined)
        if(share_axis_and_vertex(plane, next))
          together.insert(together.end(), plane.lines.begin(), plane.lines.end());
        else
          others.push_back(plane);
      if(are_side_by_side(together))
        continue;
      joined = std::move(others);
      joined.push_back(plane_of(together));
    }
    m_planes = std::move(joined);
    std::stable_sort(m_planes.begin(), m_planes.end(), is_longer);
  }

  static bool share_axis_and_vertex(const Plane& a, const Plane& b)
  {
    std::set<Vertex> vertices;
    for(const Line_of_chart_3& line : a.lines)
      vertices.insert(line.vertices.begin(), line.vertices.end());
    return a.axis == b.axis && std::any_of(b.lines.begin(), b.lines.end(), [&](const Line_of_chart_3& line)
    { return std::any_of(line.vertices.begin(), line.vertices.end(), [&](const Vertex v) { return vertices.count(v) > 0; }); });
  }

  // Returns whether two of some lines are in one chart and extend over the same part of it.
  bool are_side_by_side(const std::vector<Line_of_chart_3>& lines) const
  {
    const auto extent = [this](const Line_of_chart_3& line)
    {
      const int along = other_axis(m_charts, line.chart, line.axis);
      return std::minmax({ m_images[line.vertices.front()][along], m_images[line.vertices.back()][along] });
    };
    for(auto a = lines.begin(); a != lines.end(); ++a)
      for(auto b = lines.begin(); b != a; ++b)
        if(const auto [low, high] = extent(*a); a->chart == b->chart && low < extent(*b).second && extent(*b).first < high)
          return true;
    return false;
  }

  // Returns the plane of lines with one axis, without a value.
  Plane plane_of(const std::vector<Line_of_chart_3>& lines) const
  {
    Plane plane = { lines, lines.front().axis, 0, 0, std::nullopt };
    for(const Line_of_chart_3& line : lines)
      for(std::size_t i = 1; i < line.vertices.size(); ++i)
      {
        const Vector_3 p = m_images[line.vertices[i - 1]], q = m_images[line.vertices[i]];
        plane.mean += (q - p).norm() * (p + q)[plane.axis] / 2;
        plane.length += (q - p).norm();
      }
    plane.mean /= plane.length;
    return plane;
  }

  // Chooses values of planes, but not of those shorter than the spacing, as edges of hexahedra are as long.
  void choose_values()
  {
    for(Plane& plane : m_planes)
    {
      if(plane.length < m_grid.spacing)
        break; // the longest ones come first
      for(const double value : values(plane))
      {
        const auto positions = positions_of(plane, value);
        if(!std::all_of(positions.begin(), positions.end(), [this](const auto& p) { return keeps_order(p.first, p.second); }))
          continue;
        plane.value = value;
        for(const auto& [index, position] : positions)
          m_positions[index].push_back(position);
        break;
      }
    }
  }

  // Returns the values that a plane may have, the best one first. If lines meet edges of the polycube whose coordinate along the
  // axis is that of a face, this coordinate is the only value; there is none if such coordinates differ.
  std::vector<double> values(const Plane& plane) const
  {
    std::set<double> bound;
    for(const Line_of_chart_3& line : plane.lines)
      for(const Vertex v : line.vertices)
        if(m_is_bound[v][plane.axis])
          bound.insert(m_images[v][plane.axis]);
    if(!bound.empty())
      return bound.size() == 1 ? std::vector<double>(1, *bound.begin()) : std::vector<double>();
    if(!(m_grid.spacing > 0))
      return { plane.mean };
    constexpr double least_gain = 0.1; // a guess; part of the spacing by which a plane that divides boxes must be nearer
    std::set<std::pair<double, double> > by_distance;
    double handicap = 0;
    for(const double part : { 1., 0.5, smallest_part_of_spacing })
    {
      const double distance = part * m_grid.spacing, multiple = (plane.mean - m_grid.origin[plane.axis]) / distance;
      const double nearest = std::round(multiple);
      for(const double candidate : { nearest, nearest < multiple ? nearest + 1 : nearest - 1 })
      {
        const double value = m_grid.origin[plane.axis] + candidate * distance;
        by_distance.emplace(std::abs(value - plane.mean) + handicap, value);
      }
      handicap += least_gain * m_grid.spacing;
    }
    std::vector<double> result;
    for(const auto& [distance, value] : by_distance)
      result.push_back(value);
    return result;
  }

  // Returns the positions, each with its index, of lines of a plane in their charts and of their ends on edges along the axis.
  std::vector<std::pair<std::size_t, Position> > positions_of(const Plane& plane, const double value) const
  {
    std::vector<std::pair<std::size_t, Position> > result;
    for(const Line_of_chart_3& line : plane.lines)
    {
      const int along = other_axis(m_charts, line.chart, line.axis);
      const Vector_3 first = m_images[line.vertices.front()], last = m_images[line.vertices.back()];
      const auto [low, high] = std::minmax(first[along], last[along]);
      result.push_back({ line.chart, { plane.axis, plane_of({ line }).mean, value, low, high } });
      for(const Vertex v : line.vertices)
        if(const int chain = m_chain_of_vertex[v]; chain >= 0 && m_charts.chains()[chain].axis == plane.axis)
          result.push_back({ index_of_chain(chain), { plane.axis, m_images[v][plane.axis], value } });
    }
    return result;
  }

  // Returns the index of the positions on a chain, behind those in the charts.
  std::size_t index_of_chain(const std::size_t chain) const { return m_charts.number_of_charts() + chain; }

  // Returns whether a position keeps its order with those of other planes and of edges of the same index.
  bool keeps_order(const std::size_t index, const Position& position) const
  {
    return std::all_of(m_positions[index].begin(), m_positions[index].end(), [&](const Position& other)
    {
      return other.axis != position.axis || !(other.low < position.high && position.low < other.high)
        || (position.new_value - other.new_value) * (position.old_value - other.old_value) > 0;
    });
  }

  const Boundary_mesh_3& m_mesh;
  const Polycube_charts_3& m_charts;
  const Plane_grid_3 m_grid;
  const std::vector<Vector_3> m_images;
  Held_coordinates m_is_bound;        // at edges of the polycube: coordinates that are those of faces
  std::vector<int> m_chain_of_vertex; // -1 for vertices of none, and corners
  std::vector<std::vector<Position> > m_positions; // in each chart, and behind them on each chain
  std::vector<Plane> m_planes;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_LINES_OF_CHARTS_3_H
