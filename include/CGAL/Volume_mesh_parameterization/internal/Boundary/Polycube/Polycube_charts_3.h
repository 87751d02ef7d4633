// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_POLYCUBE_CHARTS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_POLYCUBE_CHARTS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Dense>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <set>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The six directions along the axes: 0 and 1 are +x and -x, 2 and 3 are +y and -y, 4 and 5 are +z and -z.
inline int axis_of_direction(const std::size_t direction)
{
  return static_cast<int>(direction / 2);
}

inline int sign_of_direction(const std::size_t direction)
{
  return (direction % 2 == 0) ? 1 : -1;
}

inline Eigen::Vector3d vector_of_direction(const std::size_t direction)
{
  return sign_of_direction(direction) * Eigen::Vector3d::Unit(axis_of_direction(direction));
}

// A connected part of the surface with one label: the preimage of a face of the polycube.
struct Polycube_chart_3
{
  std::size_t label = 0;
  int number_of_defects = 0; // see below
  bool is_valid() const { return number_of_defects == 0; }
  int axis() const { return axis_of_direction(label); }
};

// A line between two charts, from corner to corner: the preimage of an edge of the polycube.
struct Polycube_chain_3
{
  std::vector<Boundary_mesh_3::Halfedge_index> halfedges; // counterclockwise around the first chart
  std::array<std::size_t, 2> charts;
  int axis = -1; // -1 if the labels are not orthogonal
  int sign = 0;  // of its direction along the axis
};

// The charts of a labelled surface, the corners, where three or more of them meet, and the chains between the corners.
//
// A chain leads in the direction of its axis in which its last corner lies from its first one. Hence the border of
// each chart is a sequence of directions, and a chart is valid only if these close to polygons: by the theorem of the
// turning tangents they turn left by four right angles around a disc, by none around a ring, and so on.
class Polycube_charts_3
{
public:
  using Halfedge = Boundary_mesh_3::Halfedge_index;
  using Vertex = Boundary_mesh_3::Vertex_index;

  Polycube_charts_3(const Boundary_mesh_3& mesh, const std::vector<std::size_t>& labels)
    : m_mesh(mesh), m_chart_of_face(mesh.number_of_faces())
  {
    find_charts(labels);
    find_chains();
    find_invalid_charts();
  }

  const std::vector<std::size_t>& chart_of_face() const { return m_chart_of_face; }
  std::size_t chart(const Halfedge h) const { return m_chart_of_face[m_mesh.face(h)]; }
  const std::vector<Polycube_chart_3>& charts() const { return m_charts; }
  const std::vector<Polycube_chain_3>& chains() const { return m_chains; }
  const std::vector<Vertex>& corners() const { return m_corners; }

  int number_of_defects() const
  {
    return std::accumulate(m_charts.begin(), m_charts.end(), 0, [](const int sum, const Polycube_chart_3& chart)
    {
      return sum + chart.number_of_defects;
    });
  }

  bool are_valid() const { return number_of_defects() == 0; }

  std::vector<Vertex> vertices(const Polycube_chain_3& chain) const
  {
    std::vector<Vertex> result(1, m_mesh.source(chain.halfedges.front()));
    for(const Halfedge h : chain.halfedges)
      result.push_back(m_mesh.target(h));
    return result;
  }

private:
  // One side of a chain, as the border of a chart.
  struct Side
  {
    std::size_t chain;
    bool is_reversed;
  };

  void find_charts(const std::vector<std::size_t>& labels)
  {
    const auto is_border = boost::make_function_property_map<Boundary_mesh_3::Edge_index>(
      [&](const Boundary_mesh_3::Edge_index e)
      {
        const Halfedge h = m_mesh.halfedge(e);
        return labels[m_mesh.face(h)] != labels[m_mesh.face(m_mesh.opposite(h))];
      });
    m_charts.resize(Polygon_mesh_processing::connected_components(
      m_mesh, boost::make_iterator_property_map(m_chart_of_face.begin(), get(boost::face_index, m_mesh)),
      parameters::edge_is_constrained_map(is_border)));
    for(const auto f : m_mesh.faces())
      m_charts[m_chart_of_face[f]].label = labels[f];
  }

  bool separates(const Halfedge h) const
  {
    return chart(h) != chart(m_mesh.opposite(h));
  }

  // The next halfedge on the border of the same chart.
  Halfedge next_on_border(Halfedge h) const
  {
    h = m_mesh.next(h);
    while(!separates(h))
      h = m_mesh.next(m_mesh.opposite(h));
    return h;
  }

  void find_chains()
  {
    std::vector<bool> is_corner(m_mesh.number_of_vertices());
    for(const Vertex v : m_mesh.vertices())
    {
      const auto around = CGAL::halfedges_around_target(v, m_mesh);
      is_corner[v] = std::count_if(around.begin(), around.end(), [this](const Halfedge h) { return separates(h); }) > 2;
      if(is_corner[v])
        m_corners.push_back(v);
    }

    std::vector<bool> is_in_chain(m_mesh.number_of_halfedges(), false);
    for(const Vertex v : m_corners)
      for(const Halfedge h : CGAL::halfedges_around_source(v, m_mesh))
        if(separates(h) && chart(h) < chart(m_mesh.opposite(h)))
          add_chain(h, is_corner, is_in_chain);

    for(const Halfedge h : m_mesh.halfedges()) // closed lines without a corner
      if(separates(h) && !is_in_chain[h])
        ++m_charts[chart(h)].number_of_defects;
  }

  void add_chain(Halfedge h, const std::vector<bool>& is_corner, std::vector<bool>& is_in_chain)
  {
    Polycube_chain_3 chain;
    chain.charts = { chart(h), chart(m_mesh.opposite(h)) };
    chain.halfedges.push_back(h);
    while(!is_corner[m_mesh.target(h)])
      chain.halfedges.push_back(h = next_on_border(h));
    for(const Halfedge k : chain.halfedges)
      is_in_chain[k] = is_in_chain[m_mesh.opposite(k)] = true;

    const int a = m_charts[chain.charts[0]].axis(), b = m_charts[chain.charts[1]].axis();
    if(a != b)
    {
      chain.axis = 3 - a - b;
      const auto first = m_mesh.point(m_mesh.source(chain.halfedges.front())), last = m_mesh.point(m_mesh.target(h));
      chain.sign = (last[chain.axis] > first[chain.axis]) - (last[chain.axis] < first[chain.axis]);
    }
    m_chains.push_back(chain);
  }

  void find_invalid_charts()
  {
    std::vector<int> turning(m_charts.size(), 0);
    add_turns(turning);
    const std::vector<int> euler_characteristic = euler_characteristics();
    for(std::size_t c = 0; c < m_charts.size(); ++c)
      m_charts[c].number_of_defects += std::abs(turning[c] - 4 * euler_characteristic[c]);

    for(const Vertex v : m_corners)
    {
      std::array<bool, 3> has_axis = {};
      for(const Halfedge h : CGAL::halfedges_around_target(v, m_mesh))
        has_axis[m_charts[chart(h)].axis()] = true;
      if(has_axis != std::array<bool, 3>{true, true, true})
        for(const Halfedge h : CGAL::halfedges_around_target(v, m_mesh))
          m_charts[chart(h)].number_of_defects += separates(h);
    }
  }

  // Adds the right angles by which the border of each chart turns left at the corners.
  void add_turns(std::vector<int>& turning)
  {
    std::vector<Side> side_of_halfedge(m_mesh.number_of_halfedges());
    for(std::size_t i = 0; i < m_chains.size(); ++i)
    {
      side_of_halfedge[m_chains[i].halfedges.front()] = { i, false };
      side_of_halfedge[m_mesh.opposite(m_chains[i].halfedges.back())] = { i, true };
    }
    for(const Polycube_chain_3& chain : m_chains)
      for(const bool is_reversed : {false, true})
      {
        const std::size_t c = chain.charts[is_reversed];
        const Halfedge last = is_reversed ? m_mesh.opposite(chain.halfedges.front()) : chain.halfedges.back();
        const Side next = side_of_halfedge[next_on_border(last)];
        const Eigen::Vector3i d = direction(chain, is_reversed), e = direction(m_chains[next.chain], next.is_reversed);
        if(d.isZero() || e == -d)
          ++m_charts[c].number_of_defects;
        turning[c] += d.cross(e)[m_charts[c].axis()] * sign_of_direction(m_charts[c].label);
      }
  }

  static Eigen::Vector3i direction(const Polycube_chain_3& chain, const bool is_reversed)
  {
    Eigen::Vector3i result = Eigen::Vector3i::Zero();
    if(chain.axis >= 0)
      result[chain.axis] = is_reversed ? -chain.sign : chain.sign;
    return result;
  }

  // A vertex counts once for each chart that it touches, and an edge between two charts for both.
  std::vector<int> euler_characteristics() const
  {
    std::vector<int> result(m_charts.size(), 0);
    for(const auto f : m_mesh.faces())
      ++result[m_chart_of_face[f]];
    for(const auto e : m_mesh.edges())
    {
      --result[chart(m_mesh.halfedge(e))];
      if(separates(m_mesh.halfedge(e)))
        --result[chart(m_mesh.opposite(m_mesh.halfedge(e)))];
    }
    for(const Vertex v : m_mesh.vertices())
    {
      std::set<std::size_t> charts;
      for(const Halfedge h : CGAL::halfedges_around_target(v, m_mesh))
        charts.insert(chart(h));
      for(const std::size_t c : charts)
        ++result[c];
    }
    return result;
  }

  const Boundary_mesh_3& m_mesh;
  std::vector<std::size_t> m_chart_of_face;
  std::vector<Polycube_chart_3> m_charts;
  std::vector<Polycube_chain_3> m_chains;
  std::vector<Vertex> m_corners;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_POLYCUBE_CHARTS_3_H
