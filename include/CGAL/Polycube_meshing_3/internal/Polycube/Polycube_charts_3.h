// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_CHARTS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_CHARTS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Chart_defects_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>

#include <CGAL/boost/graph/iterator.h>

#include <tuple>
#include <utility>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the number of the chart of each face, and the number of charts. Charts are connected parts of the surface with one
// label, the preimages of the faces of the polycube.
inline std::pair<std::vector<std::size_t>, std::size_t> connected_charts_3(const Boundary_mesh_3& mesh,
                                                                           const std::vector<std::size_t>& labels)
{
  Disjoint_sets sets(labels.size());
  for(const auto e : mesh.edges())
    if(const auto f = mesh.face(mesh.halfedge(e, 0)), g = mesh.face(mesh.halfedge(e, 1)); labels[f] == labels[g])
      sets.unite(f, g);
  std::vector<std::size_t> charts = sets.numbers();
  const std::size_t n = charts.empty() ? 0 : 1 + *std::max_element(charts.begin(), charts.end());
  return { std::move(charts), n };
}

// Chain of edges of the surface between two charts, from corner to corner: the preimage of an edge of the polycube.
struct Polycube_chain_3
{
  std::vector<Boundary_mesh_3::Halfedge_index> halfedges; // counterclockwise around the first chart
  std::array<std::size_t, 2> charts; // on the left and on the right
  int axis = -1; // -1 if the labels are not orthogonal
  int sign = 0;  // of the direction along the axis; 0 if there is none
};

// Charts of a labelled surface, their corners, where three or more charts meet, and the chains between the corners.
//
// The direction of a chain is that from its first to its last corner along its axis. Hence the border of each chart is a sequence
// of directions, and a chart is valid only if these close to polygons: by the theorem of the turning tangents, a border turns left
// by four right angles around a disc, by none around a ring, and so on. Defects are counted for other labels of whole charts, too,
// from the chains alone.
class Polycube_charts_3
{
public:
  using Halfedge = Boundary_mesh_3::Halfedge_index;
  using Vertex = Boundary_mesh_3::Vertex_index;
  using Labels = std::vector<std::size_t>;

  Polycube_charts_3(const Boundary_mesh_3& mesh, const Labels& labels)
    : m_mesh(mesh)
  {
    std::size_t n;
    std::tie(m_chart_of_face, n) = connected_charts_3(mesh, labels);
    m_labels.resize(n);
    for(const auto f : mesh.faces())
      m_labels[m_chart_of_face[f]] = labels[f];
    const std::vector<int> border_degrees = this->border_degrees();
    find_chains(border_degrees);
    find_sides();
    find_inner_characteristics(border_degrees);
    m_defects = Chart_defects_3(m_borders, m_labels).count();
    m_is_beside_invalid.resize(n);
    for(const Halfedge h : mesh.halfedges())
      if(m_defects[chart(h)] != 0)
        m_is_beside_invalid[chart(h)] = m_is_beside_invalid[chart(mesh.opposite(h))] = true;
  }

  const std::vector<std::size_t>& chart_of_face() const { return m_chart_of_face; }
  std::size_t chart(const Halfedge h) const { return m_chart_of_face[m_mesh.face(h)]; }
  bool separates(const Halfedge h) const { return chart(h) != chart(m_mesh.opposite(h)); }
  std::size_t number_of_charts() const { return m_labels.size(); }
  const Labels& labels() const { return m_labels; } // of the charts
  int axis(const std::size_t chart) const { return axis_of_direction(m_labels[chart]); }
  const std::vector<Polycube_chain_3>& chains() const { return m_chains; }
  const std::vector<Vertex>& corners() const { return m_corners; }
  int number_of_defects() const { return std::accumulate(m_defects.begin(), m_defects.end(), 0); }

  // Returns the number of defects if the charts had other labels.
  int number_of_defects(const Labels& labels) const
  {
    const std::vector<int> n = Chart_defects_3(m_borders, labels).count();
    return std::accumulate(n.begin(), n.end(), 0);
  }

  // Returns whether a chart or a neighbor of it has defects.
  bool is_beside_invalid(const std::size_t chart) const { return m_is_beside_invalid[chart]; }

  std::vector<Vertex> vertices(const Polycube_chain_3& chain) const
  {
    std::vector<Vertex> result(1, m_mesh.source(chain.halfedges.front()));
    for(const Halfedge h : chain.halfedges)
      result.push_back(m_mesh.target(h));
    return result;
  }

  // Returns the axes of the plane of a chart, in the order that makes its image positive.
  std::array<int, 2> plane_axes(const std::size_t chart) const
  {
    const int u = (axis(chart) + 1) % 3, v = (axis(chart) + 2) % 3;
    return (sign_of_direction(m_labels[chart]) > 0) ? std::array<int, 2>{u, v} : std::array<int, 2>{v, u};
  }

  // Returns the corners of each border of each chart, counterclockwise around the chart.
  std::vector<std::vector<std::vector<Vertex> > > borders() const
  {
    std::vector<std::vector<std::vector<Vertex> > > result(number_of_charts());
    std::vector<bool> is_visited(m_borders.sides.size(), false);
    for(std::size_t s = 0; s < is_visited.size(); ++s)
    {
      std::vector<Vertex> border;
      for(std::size_t t = s; !is_visited[t]; t = m_borders.sides[t].next)
      {
        is_visited[t] = true;
        border.push_back(m_corners[m_borders.sides[t].first]);
      }
      if(!border.empty())
        result[m_borders.sides[s].chart].push_back(border);
    }
    return result;
  }

private:
  // Returns the next halfedge on the border of the chart of h.
  Halfedge next_on_border(Halfedge h) const
  {
    h = m_mesh.next(h);
    while(!separates(h))
      h = m_mesh.next(m_mesh.opposite(h));
    return h;
  }

  // Returns how many edges between charts meet at each vertex.
  std::vector<int> border_degrees() const
  {
    std::vector<int> result(m_mesh.number_of_vertices(), 0);
    for(const Halfedge h : m_mesh.halfedges())
      result[m_mesh.target(h)] += separates(h);
    return result;
  }

  // Finds the corners, the chains between them, and the closed chains, which have no corner.
  void find_chains(const std::vector<int>& border_degrees)
  {
    std::vector<bool> is_corner(m_mesh.number_of_vertices()), is_in_chain(m_mesh.number_of_halfedges(), false);
    for(const Vertex v : m_mesh.vertices())
    {
      is_corner[v] = border_degrees[v] > 2;
      if(is_corner[v])
        m_corners.push_back(v);
    }
    for(const Vertex v : m_corners)
      for(const Halfedge h : CGAL::halfedges_around_source(v, m_mesh))
        if(separates(h) && chart(h) < chart(m_mesh.opposite(h)))
          add_chain(h, is_corner, is_in_chain);
    for(const Halfedge h : m_mesh.halfedges())
      if(separates(h) && !is_in_chain[h])
      {
        m_borders.closed_chains.push_back({ chart(h), chart(m_mesh.opposite(h)) });
        for(Halfedge k = h; !is_in_chain[k]; k = next_on_border(k))
          is_in_chain[k] = is_in_chain[m_mesh.opposite(k)] = true;
      }
  }

  // Adds the chain that begins with a halfedge, which leaves a corner.
  void add_chain(Halfedge h, const std::vector<bool>& is_corner, std::vector<bool>& is_in_chain)
  {
    Polycube_chain_3 chain;
    chain.charts = { chart(h), chart(m_mesh.opposite(h)) };
    chain.halfedges.push_back(h);
    while(!is_corner[m_mesh.target(h)])
      chain.halfedges.push_back(h = next_on_border(h));
    for(const Halfedge k : chain.halfedges)
      is_in_chain[k] = is_in_chain[m_mesh.opposite(k)] = true;
    if(axis(chain.charts[0]) != axis(chain.charts[1]))
      chain.axis = 3 - axis(chain.charts[0]) - axis(chain.charts[1]);
    chain.sign = direction_of_edge(m_labels[chain.charts[0]], m_labels[chain.charts[1]],
                                   to_vector(m_mesh.point(m_mesh.source(chain.halfedges.front()))),
                                   to_vector(m_mesh.point(m_mesh.target(h)))).sum();
    m_chains.push_back(chain);
  }

  // Finds the sides of the chains, and those that end at each corner.
  void find_sides()
  {
    std::vector<std::size_t> side_of_halfedge(m_mesh.number_of_halfedges());
    for(std::size_t i = 0; i < m_chains.size(); ++i)
    {
      side_of_halfedge[m_chains[i].halfedges.front()] = 2 * i;
      side_of_halfedge[m_mesh.opposite(m_chains[i].halfedges.back())] = 2 * i + 1;
    }
    std::vector<std::size_t> corner(m_mesh.number_of_vertices()); // number of the corner at a vertex
    for(const Vertex v : m_corners)
    {
      corner[v] = m_borders.corners.size();
      m_borders.corners.push_back(to_vector(m_mesh.point(v)));
    }
    m_borders.sides_to_corner.resize(m_corners.size());
    for(const Polycube_chain_3& chain : m_chains)
    {
      const Halfedge first = chain.halfedges.front(), last = chain.halfedges.back();
      const std::size_t a = corner[m_mesh.source(first)], b = corner[m_mesh.target(last)];
      m_borders.sides.push_back({ chain.charts[0], side_of_halfedge[next_on_border(last)], a, b });
      m_borders.sides.push_back({ chain.charts[1], side_of_halfedge[next_on_border(m_mesh.opposite(first))], b, a });
    }
    for(std::size_t s = 0; s < m_borders.sides.size(); ++s)
      if(auto& sides = m_borders.sides_to_corner[m_borders.sides[s].last]; sides.empty())
        for(std::size_t t = s; sides.empty() || t != s; t = m_borders.sides[t].next ^ 1) // back along the side that leaves it
          sides.push_back(t);
  }

  // Finds the Euler characteristics of the charts without their borders.
  void find_inner_characteristics(const std::vector<int>& border_degrees)
  {
    m_borders.inner_characteristic.assign(number_of_charts(), 0);
    for(const auto f : m_mesh.faces())
      ++m_borders.inner_characteristic[m_chart_of_face[f]];
    for(const auto e : m_mesh.edges())
      if(!separates(m_mesh.halfedge(e)))
        --m_borders.inner_characteristic[chart(m_mesh.halfedge(e))];
    for(const Vertex v : m_mesh.vertices())
      if(border_degrees[v] == 0)
        ++m_borders.inner_characteristic[chart(m_mesh.halfedge(v))];
  }

  const Boundary_mesh_3& m_mesh;
  std::vector<std::size_t> m_chart_of_face;
  Labels m_labels;
  std::vector<Polycube_chain_3> m_chains;
  std::vector<Vertex> m_corners;
  Chart_borders_3 m_borders;
  std::vector<int> m_defects; // numbers, by chart
  std::vector<bool> m_is_beside_invalid;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_CHARTS_3_H
