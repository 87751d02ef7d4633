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
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <map>
#include <queue>
#include <set>

namespace CGAL::Polycube_meshing_3::internal {

// Closed loops of vertices on the boundary of a body that bound disjoint discs inside, one for each handle: cut along the
// discs, the body is a ball.
//
// The body is filled from one of its cells, each other cell through one facet. The filled cells are a ball, glued to itself
// at all other, closed facets. The ball remains one if a closed facet is opened with an edge inside that no other closed
// facet has; as long as there are such facets, the one nearest to the first cell is opened. So fronts from both sides of a
// handle leave a disc where they meet. If discs meet in a line, only discs that meet no other one become walls, and the body
// is filled again, from another cell.
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

  // Returns a number of loops, or fewer if no more are found. The body is filled from `first_cell` and other cells.
  std::vector<Loop> loops(const std::size_t number, const std::size_t first_cell, const Budget& budget)
  {
    constexpr std::size_t maximum_number_of_fillings = 16; // a guess
    m_loops.clear();
    m_is_wall.assign(m_cells.size(), false);
    m_is_on_wall.assign(m_edges.size(), false);
    m_is_used.clear();
    for(std::size_t i = 0; i < maximum_number_of_fillings && m_loops.size() < number && !budget.is_exhausted(); ++i)
    {
      fill_from((first_cell + i * m_facets_of_cell.size() / maximum_number_of_fillings) % m_facets_of_cell.size());
      open_facets();
      build_walls();
    }
    return m_loops;
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
        if(const std::size_t c = m_cells[f][0] + m_cells[f][1] - filled[i]; m_level[c] < 0 && !m_is_wall[f])
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
    return !m_edges[e].is_on_boundary && !m_is_on_wall[e] && number_of_closed_facets(m_edges[e]) == 1;
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

  // Makes walls of closed facets that are joined by edges, where they are discs that touch no other ones.
  void build_walls()
  {
    Disjoint_sets parts(m_cells.size());
    std::map<std::size_t, std::vector<std::size_t> > neighbors; // along borders of closed facets
    for(const Edge& edge : m_edges)
    {
      std::vector<std::size_t> closed;
      std::copy_if(edge.facets.begin(), edge.facets.end(), std::back_inserter(closed),
                   [this](const std::size_t f) { return m_is_closed[f]; });
      for(const std::size_t f : closed)
        parts.unite(f, closed.front());
      if(edge.is_on_boundary && !closed.empty())
        for(const std::size_t i : { 0, 1 })
          neighbors[edge.vertices[i]].push_back(edge.vertices[1 - i]);
    }
    std::map<std::size_t, std::vector<std::size_t> > facets_of_part;
    for(std::size_t f = 0; f < m_cells.size(); ++f)
      if(m_is_closed[f] && !m_is_wall[f])
        facets_of_part[parts.find(f)].push_back(f);
    for(const auto& part : facets_of_part)
      if(const Loop loop = border_of_disc(part.second, neighbors); !loop.empty())
        add_wall(part.second, loop);
  }

  // Returns the border of a disc of facets; an empty one if they are no disc, or touch other facets.
  Loop border_of_disc(const std::vector<std::size_t>& facets,
                      const std::map<std::size_t, std::vector<std::size_t> >& neighbors) const
  {
    std::set<std::size_t> edges, vertices, border;
    for(const std::size_t f : facets)
      edges.insert(m_edges_of_facet[f].begin(), m_edges_of_facet[f].end());
    for(const std::size_t e : edges)
    {
      const Edge& edge = m_edges[e];
      if(number_of_closed_facets(edge) != (edge.is_on_boundary ? 1 : 2))
        return {};
      vertices.insert(edge.vertices.begin(), edge.vertices.end());
      if(edge.is_on_boundary)
        border.insert(edge.vertices.begin(), edge.vertices.end());
    }
    const auto has_two_neighbors = [&](const std::size_t v) { return neighbors.at(v).size() == 2; };
    const bool is_free = std::all_of(border.begin(), border.end(), has_two_neighbors)
      && std::none_of(vertices.begin(), vertices.end(), [this](const std::size_t v) { return m_is_used.count(v) > 0; });
    if(!is_free || border.empty() || vertices.size() + facets.size() != edges.size() + 1)
      return {};
    Loop loop(1, *border.begin());
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
    return loop.size() == border.size() ? loop : Loop();
  }

  void add_wall(const std::vector<std::size_t>& facets, const Loop& loop)
  {
    m_loops.push_back(loop);
    for(const std::size_t f : facets)
    {
      m_is_wall[f] = true;
      for(const std::size_t e : m_edges_of_facet[f])
      {
        m_is_on_wall[e] = true;
        m_is_used.insert(m_edges[e].vertices.begin(), m_edges[e].vertices.end());
      }
    }
  }

  std::vector<std::array<std::size_t, 2> > m_cells; // cells on both sides of a facet
  std::vector<Edge> m_edges;
  std::vector<std::vector<std::size_t> > m_edges_of_facet, m_facets_of_cell;
  std::vector<int> m_level;      // number of facets between a cell and the first one
  std::vector<bool> m_is_closed, m_is_wall, m_is_on_wall; // by facet, by facet and by edge
  std::set<std::size_t> m_is_used;                        // vertices of walls
  std::vector<Loop> m_loops;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_MERIDIANS_3_H
