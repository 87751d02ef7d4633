// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_BOUNDARY_GRAPH_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_BOUNDARY_GRAPH_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Hexahedra_3.h>

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

namespace CGAL::Polycube_meshing_3::internal {

// Edges of the boundary of hexahedra, in both directions: those from a vertex have consecutive numbers, counterclockwise as seen
// from outside.
class Boundary_graph_3
{
public:
  explicit Boundary_graph_3(const Hexahedra_3& mesh) : m_first(mesh.points.size() + 1, 0)
  {
    std::map<Edge, std::size_t> left, next; // the quadrangle, and the vertex after the second one around the first one
    for(std::size_t f = 0; f < mesh.facets.size(); ++f)
      for(std::size_t i = 0; i < 4; ++i)
      {
        const std::array<std::size_t, 4>& q = mesh.facets[f];
        m_is_manifold = left.emplace(Edge(q[i], q[(i + 1) % 4]), f).second && m_is_manifold;
        next[{ q[i], q[(i + 1) % 4] }] = q[(i + 3) % 4];
      }
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      m_first[v] = m_edges.size();
      const auto begin = next.lower_bound({ v, 0 }), end = next.lower_bound({ v + 1, 0 });
      for(auto it = begin; it != next.end() && m_edges.size() < m_first[v] + std::distance(begin, end); )
      {
        m_edges.push_back(it->first);
        m_left.push_back(left.at(it->first));
        it = next.find({ v, it->second });
      }
      const std::size_t n = m_edges.size() - m_first[v];
      m_is_manifold = m_is_manifold && n == static_cast<std::size_t>(std::distance(begin, end))
                      && (n == 0 || next.at(m_edges.back()) == begin->first.second);
    }
    m_first.back() = m_edges.size();
    if(!m_is_manifold)
      return;
    for(const auto& [v, w] : m_edges)
      m_opposite.push_back(edge(w, v));
    m_graph = Graph(boost::edges_are_sorted, m_edges.begin(), m_edges.end(), mesh.points.size());
  }

  bool is_manifold() const { return m_is_manifold; } // otherwise, edges have no opposite ones, and there are no paths
  std::size_t number_of_edges() const { return m_edges.size(); }
  std::size_t first(const std::size_t v) const { return m_first[v]; } // edge; the last one is before first(v + 1)
  std::size_t degree(const std::size_t v) const { return m_first[v + 1] - m_first[v]; }
  std::size_t source(const std::size_t e) const { return m_edges[e].first; }
  std::size_t target(const std::size_t e) const { return m_edges[e].second; }
  std::size_t opposite(const std::size_t e) const { return m_opposite[e]; }
  std::size_t left(const std::size_t e) const { return m_left[e]; } // quadrangle

  // Returns the number of the edge from v to w; number_of_edges() if there is none.
  std::size_t edge(const std::size_t v, const std::size_t w) const
  {
    for(std::size_t e = m_first[v]; e < m_first[v + 1]; ++e)
      if(m_edges[e].second == w)
        return e;
    return m_edges.size();
  }

  // Returns the edges of the shortest path between two vertices; none if there is no path. Takes a function for the weight of an
  // edge. An edge whose weight is the largest double is in no path.
  template <typename Weight>
  std::vector<std::size_t> shortest_path(const std::size_t source, const std::size_t target, const Weight& weight) const
  {
    const auto weight_of = [&](const Graph::edge_descriptor& e) { return weight(e.idx); };
    std::vector<std::size_t> predecessors(m_first.size() - 1);
    try
    {
      boost::dijkstra_shortest_paths(
        m_graph, source,
        boost::weight_map(boost::make_function_property_map<Graph::edge_descriptor, double>(weight_of))
          .predecessor_map(boost::make_iterator_property_map(predecessors.begin(), get(boost::vertex_index, m_graph)))
          .visitor(Stop_at{ {}, target }));
    }
    catch(const Reached&)
    {}
    std::vector<std::size_t> path;
    for(std::size_t v = target; predecessors[v] != v; v = predecessors[v])
      path.push_back(edge(predecessors[v], v));
    std::reverse(path.begin(), path.end());
    return path;
  }

private:
  using Edge = std::pair<std::size_t, std::size_t>;
  using Graph = boost::compressed_sparse_row_graph<boost::directedS>;

  struct Reached {};

  // Ends the search by an exception as soon as the path to the target is known.
  struct Stop_at : boost::default_dijkstra_visitor
  {
    std::size_t target;

    Stop_at(const boost::default_dijkstra_visitor& visitor, const std::size_t v)
      : boost::default_dijkstra_visitor(visitor), target(v)
    {}

    void examine_vertex(const std::size_t v, const Graph&) const
    {
      if(v == target)
        throw Reached();
    }
  };

  bool m_is_manifold = true;
  std::vector<std::size_t> m_first; // edge of each vertex
  std::vector<Edge> m_edges;
  std::vector<std::size_t> m_left, m_opposite;
  Graph m_graph;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_BOUNDARY_GRAPH_3_H
