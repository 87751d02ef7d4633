// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_LINES_OF_CHARTS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_LINES_OF_CHARTS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Chart_relaxation_2.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Polycube_coordinates_3.h>

#include <map>
#include <optional>
#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Sharp edges inside charts as lines in faces of the polycube, each along an axis: vertices of a line get one value of the other
// coordinate of the face. So planes of a grid through it lead along the sharp edges of the body.
//
// A line is a part of a curve of sharp edges whose images, of a map without lines, lead mostly along one axis and not far across.
// Lines that meet at a vertex, in one chart or on both sides of an edge of the polycube, have one value if they are held
// along the same axis there. Values are the mean, or with planes of a grid the nearest one, or half or a quarter of the way to
// the next one, such that lines and edges keep the order that they have without lines; the longest lines choose first, and those
// for which there is no value are given up.
class Lines_of_charts_3
{
public:
  static constexpr double smallest_part_of_spacing = 0.25; // a guess; between lines, a power of 2 for exact multiples

  using Vertex = Boundary_mesh_3::Vertex_index;
  using Halfedge = Boundary_mesh_3::Halfedge_index;

  // Takes the images of a map without lines, and whether each edge of the mesh is sharp.
  Lines_of_charts_3(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts, const std::vector<bool>& is_sharp,
                    const Grid_planes_3& planes, const std::vector<Eigen::Vector3d>& images)
    : m_mesh(mesh), m_charts(charts), m_is_sharp(is_sharp), m_planes(planes), m_images(images),
      m_is_bound(images.size(), { false, false, false }), m_sites(charts.number_of_charts() + charts.chains().size())
  {
    add_edges_of_polycube();
    find_lines();
    join_lines();
    choose_values();
  }

  bool are_empty() const
  { return std::none_of(m_groups.begin(), m_groups.end(), [](const Group& group) { return group.value.has_value(); }); }

  // Gives up the lines in charts. Returns whether there were any.
  bool give_up(const std::vector<bool>& is_chart_bad)
  {
    bool has_changed = false;
    for(Group& group : m_groups)
      if(group.value && std::any_of(group.lines.begin(), group.lines.end(), [&](const Line& line) { return is_chart_bad[line.chart]; }))
      {
        group.value.reset();
        has_changed = true;
      }
    return has_changed;
  }

  // Gives the vertices of lines their values, and holds these coordinates.
  void apply(std::vector<Eigen::Vector3d>& images, Held_coordinates& is_held) const
  {
    for(const Group& group : m_groups)
      for(const Line& line : group.lines)
        for(const Vertex v : line.vertices)
          if(group.value)
          {
            images[v][group.axis] = *group.value;
            is_held[v][group.axis] = true;
          }
  }

private:
  // Part of a curve of sharp edges in a chart.
  struct Line
  {
    std::vector<Vertex> vertices;
    std::size_t chart;
    int axis; // the one across, of the coordinate that is to be constant
  };

  // Lines that have one value.
  struct Group
  {
    std::vector<Line> lines;
    int axis;
    double mean, length;
    std::optional<double> value;
  };

  // Edge of the polycube, line, or end of a line, in a chart or on an edge of the polycube: where others may be only on the
  // side of its value on which they were.
  struct Site
  {
    int axis;
    double low, high; // along the other axis
    double before, value;
  };

  bool separates(const Halfedge h) const { return m_charts.chart(h) != m_charts.chart(m_mesh.opposite(h)); }
  bool is_inside(const Halfedge h) const { return m_is_sharp[m_mesh.edge(h)] && !separates(h); }
  Eigen::Vector3d way(const Halfedge h) const { return m_images[m_mesh.target(h)] - m_images[m_mesh.source(h)]; }

  // Returns the axis that the image of an edge leads along.
  int axis_along(const Halfedge h) const
  {
    int axis;
    way(h).cwiseAbs().maxCoeff(&axis);
    return axis;
  }

  int other_axis(const std::size_t chart, const int axis) const { return 3 - m_charts.axis(chart) - axis; }

  // Returns the sharp edges of the chart behind an edge that turn by less than half a right angle.
  std::vector<Halfedge> continuations(const Halfedge h) const
  {
    const auto edge = [this](const Halfedge k) -> Eigen::Vector3d
    { return eigen_point(m_mesh, m_mesh.target(k)) - eigen_point(m_mesh, m_mesh.source(k)); };
    std::vector<Halfedge> result;
    for(const Halfedge k : CGAL::halfedges_around_source(m_mesh.target(h), m_mesh))
      if(is_inside(k) && k != m_mesh.opposite(h) && m_charts.chart(k) == m_charts.chart(h)
         && edge(k).dot(edge(h)) > std::sqrt(0.5) * edge(k).norm() * edge(h).norm())
        result.push_back(k);
    return result;
  }

  void add_edges_of_polycube()
  {
    m_chain_of_vertex.assign(m_images.size(), -1);
    for(std::size_t i = 0; i < m_charts.chains().size(); ++i)
    {
      const Polycube_chain_3& chain = m_charts.chains()[i];
      const std::vector<Vertex> path = m_charts.vertices(chain);
      const Eigen::Vector3d first = m_images[path.front()], last = m_images[path.back()];
      for(const std::size_t c : chain.charts)
      {
        const int axis = other_axis(c, chain.axis);
        const auto [low, high] = std::minmax(first[chain.axis], last[chain.axis]);
        m_sites[c].push_back({ axis, low, high, first[axis], first[axis] });
        for(const Vertex v : path)
          m_is_bound[v][axis] = true;
      }
      for(const Eigen::Vector3d& p : { first, last })
        m_sites[m_charts.number_of_charts() + i].push_back({ chain.axis, 0, 1, p[chain.axis], p[chain.axis] });
      for(std::size_t k = 1; k + 1 < path.size(); ++k)
        m_chain_of_vertex[path[k]] = static_cast<int>(i);
    }
  }

  // Follows the curves of sharp edges, and divides those whose images are not straight where these turn to another axis.
  void find_lines()
  {
    std::vector<bool> is_used(m_mesh.number_of_edges(), false);
    for(const auto e : m_mesh.edges())
      if(const Halfedge h = m_mesh.halfedge(e); is_inside(h) && !is_used[e])
      {
        std::vector<Halfedge> back = follow(m_mesh.opposite(h), is_used), curve;
        for(auto k = back.rbegin(); k != back.rend(); ++k)
          curve.push_back(m_mesh.opposite(*k));
        const std::vector<Halfedge> ahead = follow(h, is_used);
        curve.insert(curve.end(), ahead.begin() + 1, ahead.end());
        if(!add_line(curve.begin(), curve.end()))
          for(auto begin = curve.begin(), end = begin; begin != curve.end(); begin = end)
          {
            end = std::find_if(begin, curve.end(), [&](const Halfedge k) { return axis_along(k) != axis_along(*begin); });
            if(end - begin >= shortest_arc)
              add_line(begin, end);
          }
      }
  }

  // Returns an edge and those that continue its curve.
  std::vector<Halfedge> follow(const Halfedge h, std::vector<bool>& is_used) const
  {
    std::vector<Halfedge> result(1, h);
    is_used[m_mesh.edge(h)] = true;
    for(auto next = continuations(h); next.size() == 1 && !is_used[m_mesh.edge(next[0])]; next = continuations(next[0]))
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
    Line line = { { m_mesh.source(*begin) }, chart, -1 };
    double length = 0;
    for(auto h = begin; h != end; ++h)
    {
      line.vertices.push_back(m_mesh.target(*h));
      length += way(*h).norm();
    }
    Eigen::Vector3d difference = m_images[line.vertices.back()] - m_images[line.vertices.front()];
    difference[m_charts.axis(chart)] = 0;
    int along;
    difference.cwiseAbs().maxCoeff(&along);
    line.axis = other_axis(chart, along);
    if(!(std::abs(difference[line.axis]) <= largest_slope * std::abs(difference[along]))
       || std::abs(difference[along]) < smallest_extent * length)
      return false;
    m_lines.push_back(std::move(line));
    return true;
  }

  static constexpr double largest_slope = 0.6;       // a guess; of a line that is turned to an axis
  static constexpr double smallest_extent = 0.7;     // a guess; of a line along its axis, relative to its length
  static constexpr std::ptrdiff_t shortest_arc = 3;  // a guess; edges, fewer are steps of a diagonal

  // Makes groups of lines that share a vertex and the axis across, the longest ones first.
  void join_lines()
  {
    Disjoint_sets sets(m_lines.size());
    std::map<std::pair<std::size_t, int>, std::size_t> line_at;
    for(std::size_t i = 0; i < m_lines.size(); ++i)
      for(const Vertex v : m_lines[i].vertices)
        sets.unite(i, line_at.emplace(std::make_pair(std::size_t(v), m_lines[i].axis), i).first->second);
    std::map<std::size_t, std::vector<Line> > groups;
    for(std::size_t i = 0; i < m_lines.size(); ++i)
      groups[sets.find(i)].push_back(m_lines[i]);
    for(const auto& [set, lines] : groups)
      m_groups.push_back(group_of(lines));
    std::stable_sort(m_groups.begin(), m_groups.end(), [](const Group& a, const Group& b) { return a.length > b.length; });
  }

  Group group_of(const std::vector<Line>& lines) const
  {
    Group group = { lines, lines.front().axis, 0, 0, std::nullopt };
    for(const Line& line : lines)
      for(std::size_t i = 1; i < line.vertices.size(); ++i)
      {
        const Eigen::Vector3d p = m_images[line.vertices[i - 1]], q = m_images[line.vertices[i]];
        group.mean += (q - p).norm() * (p + q)[group.axis] / 2;
        group.length += (q - p).norm();
      }
    group.mean /= group.length;
    return group;
  }

  void choose_values()
  {
    for(Group& group : m_groups)
      for(const double value : values(group))
      {
        const auto sites = sites_of(group, value);
        if(group.value || !std::all_of(sites.begin(), sites.end(), [this](const auto& site) { return fits(site.first, site.second); }))
          continue;
        group.value = value;
        for(const auto& [owner, site] : sites)
          m_sites[owner].push_back(site);
      }
  }

  // Returns the values that a group may have, the best one first: only that of edges of the polycube across which it ends, if
  // they have one value.
  std::vector<double> values(const Group& group) const
  {
    std::set<double> bound;
    for(const Line& line : group.lines)
      for(const Vertex v : line.vertices)
        if(m_is_bound[v][group.axis])
          bound.insert(m_images[v][group.axis]);
    if(!bound.empty())
      return bound.size() == 1 ? std::vector<double>(1, *bound.begin()) : std::vector<double>();
    if(!(m_planes.spacing > 0))
      return { group.mean };
    std::vector<double> result;
    for(const double part : { 1., 0.5, smallest_part_of_spacing })
    {
      const double distance = part * m_planes.spacing, k = (group.mean - m_planes.origin[group.axis]) / distance;
      const double nearest = std::round(k);
      for(const double n : { nearest, nearest < k ? nearest + 1 : nearest - 1 })
        result.push_back(m_planes.origin[group.axis] + n * distance);
    }
    return result;
  }

  // Returns the lines of a group in their charts, and their ends on edges of the polycube along the axis across.
  std::vector<std::pair<std::size_t, Site> > sites_of(const Group& group, const double value) const
  {
    std::vector<std::pair<std::size_t, Site> > result;
    for(const Line& line : group.lines)
    {
      const int along = other_axis(line.chart, line.axis);
      const Eigen::Vector3d first = m_images[line.vertices.front()], last = m_images[line.vertices.back()];
      const auto [low, high] = std::minmax(first[along], last[along]);
      result.push_back({ line.chart, { group.axis, low, high, group_of({ line }).mean, value } });
      for(const Vertex v : line.vertices)
        if(const int chain = m_chain_of_vertex[v]; chain >= 0 && m_charts.chains()[chain].axis == group.axis)
          result.push_back({ m_charts.number_of_charts() + chain, { group.axis, 0, 1, m_images[v][group.axis], value } });
    }
    return result;
  }

  // Tells whether a site is on the same sides of all others with its owner as before. Ends of lines at one vertex are one.
  bool fits(const std::size_t owner, const Site& site) const
  {
    return std::all_of(m_sites[owner].begin(), m_sites[owner].end(), [&](const Site& other)
    {
      return other.axis != site.axis || !(other.low < site.high && site.low < other.high)
        || (site.value - other.value) * (site.before - other.before) > 0;
    });
  }

  const Boundary_mesh_3& m_mesh;
  const Polycube_charts_3& m_charts;
  const std::vector<bool>& m_is_sharp;
  const Grid_planes_3 m_planes;
  const std::vector<Eigen::Vector3d> m_images;
  Held_coordinates m_is_bound;        // at edges of the polycube: coordinates that are those of faces
  std::vector<int> m_chain_of_vertex; // -1 for vertices of none, and corners
  std::vector<std::vector<Site> > m_sites; // in each chart, and on each edge of the polycube
  std::vector<Line> m_lines;
  std::vector<Group> m_groups;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_LINES_OF_CHARTS_3_H
