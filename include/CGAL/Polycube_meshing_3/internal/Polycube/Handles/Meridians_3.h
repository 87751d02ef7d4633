// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_MERIDIANS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_MERIDIANS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>

#include <map>
#include <queue>
#include <set>

namespace CGAL::Polycube_meshing_3::internal {

// Meridians of a body with one handle: closed loops of vertices on the boundary that bound discs inside. Cut along such a disc,
// the body is a ball.
//
// The body is filled from one of its cells, each other cell through one facet. The filled cells are a ball, glued to itself
// at all other, closed facets. The ball remains one if a closed facet is opened with an edge inside that no other closed
// facet has; as long as there are such facets, the one nearest to the first cell is opened. So fronts from both sides of the
// handle leave a disc where they meet.
class Meridians_3
{
public:
  using Loop = std::vector<std::size_t>;

  explicit Meridians_3(const std::vector<std::array<std::size_t, 4> >& cells)
    : m_facets_of_cell(cells.size())
  {
    std::vector<std::array<std::size_t, 3> > facets, boundary;
    const auto facet_and_cell = [&](const std::size_t side)
    { return std::make_pair(sorted(facet_of_cell(cells[side / 4], side % 4)), side / 4); };
    for_each_group(4 * cells.size(), facet_and_cell, [&](const auto begin, const auto end)
    {
      if(end - begin == 1)
        boundary.push_back(begin->first);
      else
      {
        for(auto it = begin; it != end; ++it)
          m_facets_of_cell[it->second].push_back(facets.size());
        facets.push_back(begin->first);
        m_cells.push_back({ begin->second, (begin + 1)->second });
      }
    });
    m_edges_of_facet.resize(facets.size());
    facets.insert(facets.end(), boundary.begin(), boundary.end());
    for_each_edge(facets, [&](const auto begin, const auto end)
    {
      Edge edge = { begin->first, {}, false };
      for(auto it = begin; it != end; ++it)
        if(const std::size_t f = it->second[0] / 3; f < m_cells.size())
        {
          edge.facets.push_back(f);
          m_edges_of_facet[f].push_back(m_edges.size());
        }
        else
          edge.is_on_boundary = true;
      m_edges.push_back(edge);
    });
  }

  // Returns the meridian where the fronts from a cell meet; an empty one if they do not leave one disc.
  Loop from(const std::size_t first_cell)
  {
    fill_from(first_cell);
    open_facets();
    return border_of_closed_facets();
  }

private:
  struct Edge
  {
    std::array<std::size_t, 2> vertices;
    std::vector<std::size_t> facets; // facets between two cells
    bool is_on_boundary;
  };

  void fill_from(const std::size_t first_cell)
  {
    m_level.assign(m_facets_of_cell.size(), -1);
    m_is_closed.assign(m_cells.size(), true);
    m_level[first_cell] = 0;
    std::vector<std::size_t> filled(1, first_cell);
    for(std::size_t i = 0; i < filled.size(); ++i)
      for(const std::size_t f : m_facets_of_cell[filled[i]])
        if(const std::size_t c = m_cells[f][0] + m_cells[f][1] - filled[i]; m_level[c] < 0)
        {
          m_level[c] = m_level[filled[i]] + 1;
          m_is_closed[f] = false;
          filled.push_back(c);
        }
  }

  std::size_t number_of_closed_facets(const Edge& edge) const
  {
    return std::count_if(edge.facets.begin(), edge.facets.end(), [this](const std::size_t f) { return m_is_closed[f]; });
  }

  bool is_inside_of_one_facet(const std::size_t e) const
  {
    return !m_edges[e].is_on_boundary && number_of_closed_facets(m_edges[e]) == 1;
  }

  void open_facets()
  {
    using Entry = std::pair<int, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    const auto push_facet_of = [&](const std::size_t e)
    {
      if(is_inside_of_one_facet(e))
        for(const std::size_t f : m_edges[e].facets)
          if(m_is_closed[f])
            queue.push({ m_level[m_cells[f][0]] + m_level[m_cells[f][1]], f });
    };
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      push_facet_of(e);
    while(!queue.empty())
    {
      const std::size_t f = queue.top().second;
      const auto& edges = m_edges_of_facet[f];
      queue.pop();
      if(!m_is_closed[f]
         || std::none_of(edges.begin(), edges.end(), [this](const std::size_t e) { return is_inside_of_one_facet(e); }))
        continue;
      m_is_closed[f] = false;
      std::for_each(edges.begin(), edges.end(), push_facet_of);
    }
  }

  // Returns the border of the closed facets; an empty one if they are not one disc.
  Loop border_of_closed_facets() const
  {
    const std::size_t number_of_facets = std::count(m_is_closed.begin(), m_is_closed.end(), true);
    std::size_t number_of_edges = 0;
    std::set<std::size_t> vertices;
    std::map<std::size_t, std::vector<std::size_t> > neighbors; // along the border
    for(const Edge& edge : m_edges)
    {
      const std::size_t number = number_of_closed_facets(edge);
      if(number == 0)
        continue;
      if(number != (edge.is_on_boundary ? 1 : 2))
        return {};
      ++number_of_edges;
      vertices.insert(edge.vertices.begin(), edge.vertices.end());
      if(edge.is_on_boundary)
        for(const std::size_t i : { 0, 1 })
          neighbors[edge.vertices[i]].push_back(edge.vertices[1 - i]);
    }
    const auto has_two_neighbors = [](const auto& entry) { return entry.second.size() == 2; };
    if(neighbors.empty() || !std::all_of(neighbors.begin(), neighbors.end(), has_two_neighbors)
       || vertices.size() + number_of_facets != number_of_edges + 1)
      return {};
    Loop loop(1, neighbors.begin()->first);
    for(std::size_t previous = loop[0], v = previous; ; )
    {
      const std::vector<std::size_t>& around = neighbors.at(v);
      const std::size_t next = around[around[0] == previous];
      if(next == loop[0])
        break;
      loop.push_back(next);
      previous = v;
      v = next;
    }
    return loop.size() == neighbors.size() ? loop : Loop();
  }

  std::vector<std::array<std::size_t, 2> > m_cells; // cells on both sides of a facet
  std::vector<Edge> m_edges;
  std::vector<std::vector<std::size_t> > m_edges_of_facet, m_facets_of_cell;
  std::vector<int> m_level; // number of facets between a cell and the first one
  std::vector<bool> m_is_closed;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_MERIDIANS_3_H
