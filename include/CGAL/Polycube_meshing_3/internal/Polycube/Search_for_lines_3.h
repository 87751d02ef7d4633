// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_SEARCH_FOR_LINES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_SEARCH_FOR_LINES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_charts_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Part of a curve of sharp edges in a chart. Its image is to have one coordinate along the axis across.
struct Line_of_chart_3
{
  std::vector<Boundary_mesh_3::Vertex_index> vertices;
  std::size_t chart;
  int axis; // across
};

// Returns the axis in the plane of a chart that is not the given one.
inline int other_axis(const Polycube_charts_3& charts, const std::size_t chart, const int axis)
{ return 3 - charts.axis(chart) - axis; }

// Search for lines: parts of curves of sharp edges whose images under a map without lines lead mostly along one axis.
class Search_for_lines_3
{
public:
  using Halfedge = Boundary_mesh_3::Halfedge_index;

  // Takes the images of a map without lines, and whether each edge of the mesh is sharp.
  Search_for_lines_3(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts, const std::vector<bool>& is_sharp,
                     const std::vector<Vector_3>& images)
    : m_mesh(mesh), m_charts(charts), m_is_sharp(is_sharp), m_images(images)
  {
    find_lines();
  }

  const std::vector<Line_of_chart_3>& lines() const { return m_lines; }

private:
  bool is_sharp_in_chart(const Halfedge h) const { return m_is_sharp[m_mesh.edge(h)] && !m_charts.separates(h); }
  Vector_3 image_of_edge(const Halfedge h) const { return m_images[m_mesh.target(h)] - m_images[m_mesh.source(h)]; }

  // Returns the axis that the image of an edge leads along.
  int axis_along(const Halfedge h) const { return image_of_edge(h).cwiseAbs().largest_index(); }

  // Returns the sharp edges of the chart that begin where an edge ends, without a sharp turn.
  std::vector<Halfedge> continuations(const Halfedge h) const
  {
    const auto edge = [this](const Halfedge k) { return edge_vector(m_mesh, k); };
    std::vector<Halfedge> result;
    for(const Halfedge k : CGAL::halfedges_around_source(m_mesh.target(h), m_mesh))
      if(is_sharp_in_chart(k) && k != m_mesh.opposite(h) && m_charts.chart(k) == m_charts.chart(h)
         && !turns_sharply(edge(h), edge(k)))
        result.push_back(k);
    return result;
  }

  // Follows the curves of sharp edges. Divides a curve that is no line where its image turns to another axis.
  void find_lines()
  {
    std::vector<bool> is_used(m_mesh.number_of_edges(), false);
    for(const auto e : m_mesh.edges())
      if(const Halfedge h = m_mesh.halfedge(e); is_sharp_in_chart(h) && !is_used[e])
      {
        const std::vector<Halfedge> back = follow(m_mesh.opposite(h), is_used);
        std::vector<Halfedge> curve;
        for(auto k = back.rbegin(); k != back.rend(); ++k)
          curve.push_back(m_mesh.opposite(*k));
        const std::vector<Halfedge> ahead = follow(h, is_used);
        curve.insert(curve.end(), ahead.begin() + 1, ahead.end()); // h is in both parts
        if(!add_line(curve.begin(), curve.end()))
          for(auto begin = curve.begin(), end = begin; begin != curve.end(); begin = end)
          {
            end = std::find_if(begin, curve.end(), [&](const Halfedge k) { return axis_along(k) != axis_along(*begin); });
            if(end - begin >= shortest_arc)
              add_line(begin, end);
          }
      }
  }

  // Returns an edge and those that continue its curve up to a fork or to an edge in use, and marks them as used.
  std::vector<Halfedge> follow(const Halfedge h, std::vector<bool>& is_used) const
  {
    std::vector<Halfedge> result(1, h);
    is_used[m_mesh.edge(h)] = true;
    for(auto next = continuations(h); next.size() == 1 && continuations(m_mesh.opposite(next[0])).size() == 1
                                      && !is_used[m_mesh.edge(next[0])]; next = continuations(next[0]))
    {
      is_used[m_mesh.edge(next[0])] = true;
      result.push_back(next[0]);
    }
    return result;
  }

  // Adds a part of a curve if its image leads along an axis. Returns whether it does.
  template <typename Iterator>
  bool add_line(const Iterator begin, const Iterator end)
  {
    const std::size_t chart = m_charts.chart(*begin);
    Line_of_chart_3 line = { { m_mesh.source(*begin) }, chart, -1 };
    double length = 0;
    for(auto h = begin; h != end; ++h)
    {
      line.vertices.push_back(m_mesh.target(*h));
      length += image_of_edge(*h).norm();
    }
    Vector_3 difference = m_images[line.vertices.back()] - m_images[line.vertices.front()];
    difference[m_charts.axis(chart)] = 0;
    const int along = difference.cwiseAbs().largest_index();
    line.axis = other_axis(m_charts, chart, along);
    if(!(std::abs(difference[line.axis]) <= largest_slope * std::abs(difference[along]))
       || std::abs(difference[along]) < smallest_extent * length)
      return false;
    m_lines.push_back(std::move(line));
    return true;
  }

  static constexpr double largest_slope = 0.6;       // a guess; of a line that is turned to an axis
  static constexpr double smallest_extent = 0.7;     // a guess; of a line along its axis, relative to its length
  static constexpr std::ptrdiff_t shortest_arc = 3;  // a guess; edges, fewer are steps of a diagonal

  const Boundary_mesh_3& m_mesh;
  const Polycube_charts_3& m_charts;
  const std::vector<bool>& m_is_sharp;
  const std::vector<Vector_3>& m_images;
  std::vector<Line_of_chart_3> m_lines;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_SEARCH_FOR_LINES_3_H
