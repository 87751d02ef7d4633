// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_FEATURE_EMBEDDING_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_FEATURE_EMBEDDING_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Features/Body_complex_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Features/Boundary_graph_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/Positions_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <unordered_map>

namespace CGAL::Polycube_meshing_3::internal {

// Finds vertices for corners, and disjoint paths of edges for arcs, on the boundary of hexahedra. The paths meet at corners in
// the order of the body. Arcs compete for vertices, whose prices grow as long as several arcs use them (McMurchie and Ebeling,
// PathFinder, 1995). If that does not end, the curve with the most conflicts is given up. The patches beside it are one region.
// Paths have the subdomains of their patches beside them: those of the hexahedra do not change.
class Feature_embedding_3
{
public:
  // Takes the length of edges of hexahedra without distortion, to which distances are relative.
  Feature_embedding_3(const Body_complex_3& complex, const Hexahedra_3& mesh, const double edge)
    : m_complex(complex), m_mesh(mesh), m_graph(mesh), m_edge(edge), m_is_given_up(complex.arcs().size(), false),
      m_paths(complex.arcs().size()), m_costs(complex.arcs().size()), m_deviations(complex.number_of_patches()),
      m_ports(complex.arcs().size(), std::array<std::size_t, 2>{ none, none }), m_corner_at(mesh.points.size(), none)
  {
    for(const std::array<std::size_t, 4>& q : mesh.facets)
    {
      m_centers.push_back(center_of(mesh.points, q));
      m_normals.push_back(area_vector(mesh.points, q).stableNormalized());
    }
    if(is_possible())
      assign_corners();
  }

  bool is_possible() const { return m_complex.is_manifold() && m_graph.is_manifold() && !m_complex.arcs().empty(); }

  // Finds paths for all curves but those that are given up. A curve beside wrong regions is given up, too. Returns whether there
  // are some paths, and each region of quadrangles belongs to one patch of the body, or to patches that are joined.
  bool run(const Budget& budget, const std::set<std::size_t>& curves_given_up = {})
  {
    if(!is_possible())
      return false;
    m_occupied.assign(m_mesh.points.size(), 0);
    m_history.assign(m_mesh.points.size(), 0);
    m_occupied_edges.assign(m_graph.number_of_edges(), 0);
    m_history_of_edges.assign(m_graph.number_of_edges(), 0);
    for(const std::size_t curve : curves_given_up)
      give_up(curve);
    while(number_given_up() < std::ptrdiff_t(m_paths.size()) && find_paths(budget))
    {
      const std::vector<std::size_t> wrong = find_regions();
      if(wrong.empty())
        return number_given_up() < std::ptrdiff_t(m_paths.size());
      give_up_longest_detour(wrong);
    }
    return false;
  }

  // Returns a hexahedron at each corner whose vertex has fewer edges than arcs; no two of them share a vertex of the boundary.
  std::vector<std::size_t> hexahedra_without_room() const
  {
    std::vector<std::size_t> result;
    std::set<std::size_t> used;
    for(std::size_t c = 0; c < m_vertices.size(); ++c)
    {
      const std::size_t v = m_vertices[c];
      if(v == none || m_complex.corners()[c].ends.size() <= m_graph.degree(v))
        continue;
      const std::size_t f = m_graph.left(m_graph.first(v));
      const std::array<std::size_t, 4>& q = m_mesh.facets[f];
      if(std::any_of(q.begin(), q.end(), [&](const std::size_t w) { return used.count(w) > 0; }))
        continue;
      used.insert(q.begin(), q.end());
      result.push_back(m_mesh.facet_cells[f]);
    }
    return result;
  }

  const Boundary_graph_3& graph() const { return m_graph; }
  std::ptrdiff_t number_given_up() const { return std::count(m_is_given_up.begin(), m_is_given_up.end(), true); }
  const std::vector<std::size_t>& path(const std::size_t arc) const { return m_paths[arc]; } // edges
  const std::set<std::size_t>& contested() const { return m_contested; } // edges of arcs given up, at vertices of other arcs
  std::size_t vertex(const std::size_t corner) const { return m_vertices[corner]; }
  std::size_t region(const std::size_t quadrangle) const { return m_regions[quadrangle]; }
  const std::vector<std::set<std::size_t> >& patches() const { return m_patches; } // of each region

  // Returns whether any arc that ends in a corner is not given up.
  bool is_used(const std::size_t corner) const
  {
    const std::vector<End_of_arc_3>& ends = m_complex.corners()[corner].ends;
    return std::any_of(ends.begin(), ends.end(), [&](const End_of_arc_3& end) { return !m_is_given_up[end.arc]; });
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Returns how far a quadrangle is from a patch: the distance in edges, up to a bound, and the weighted angle between normals.
  double deviation(const std::size_t f, const std::size_t patch)
  {
    constexpr double largest = 3, weight_of_normal = 0.7; // guesses
    const auto [found, is_new] = m_deviations[patch].try_emplace(f, 0);
    if(is_new)
    {
      const Body_surface_3& surface = m_complex.surface(patch);
      const double distance = (surface.nearest(m_centers[f], Freedom_3::SURFACE) - m_centers[f]).norm() / m_edge;
      found->second = (std::min)(distance, largest) + weight_of_normal * (1 - surface.normal(m_centers[f]).dot(m_normals[f]));
    }
    return found->second;
  }

  // Returns the distance of a vertex from an arc, in edges.
  double distance(const std::size_t v, const std::size_t arc) const
  { return m_complex.line(arc).nearest(m_mesh.points[v]).first / m_edge; }

  // Returns the cost of an edge in the path of an arc: its length, the more the farther its ends are from the arc, and the
  // quadrangles beside it from the patches beside the arc.
  double cost(const std::size_t e, const std::size_t arc)
  {
    constexpr double price_of_edge = 0.05, price_of_length = 0.3, price_of_distance = 1.5, price_of_deviation = 0.6; // guesses
    const auto [found, is_new] = m_costs[arc].try_emplace(e, 0);
    if(is_new)
    {
      const std::size_t v = m_graph.source(e), w = m_graph.target(e);
      const double to_v = distance(v, arc), to_w = distance(w, arc);
      const auto& [left, right] = m_complex.arcs()[arc].patches;
      const double price = price_of_length + price_of_distance * (to_v * to_v + to_w * to_w) + price_of_deviation
        * (deviation(m_graph.left(e), left) + deviation(m_graph.left(m_graph.opposite(e)), right));
      found->second = price_of_edge + price * (m_mesh.points[w] - m_mesh.points[v]).norm() / m_edge;
    }
    return found->second;
  }

  // Returns the index by which an edge and its opposite one are counted together.
  std::size_t undirected(const std::size_t e) const { return (std::min)(e, m_graph.opposite(e)); }

  int subdomain(const std::size_t quadrangle) const { return m_mesh.cell_references[m_mesh.facet_cells[quadrangle]]; }

  // Returns whether an edge is between the subdomains that an arc is between.
  bool has_subdomains(const std::size_t e, const std::size_t arc) const
  {
    const auto& [left, right] = m_complex.arcs()[arc].patches;
    return subdomain(m_graph.left(e)) == m_complex.subdomain(left)
           && subdomain(m_graph.left(m_graph.opposite(e))) == m_complex.subdomain(right);
  }

  // Returns the arcs that end in a corner and are not given up.
  std::vector<End_of_arc_3> kept_ends(const std::size_t corner) const
  {
    std::vector<End_of_arc_3> result;
    for(const End_of_arc_3& end : m_complex.corners()[corner].ends)
      if(!m_is_given_up[end.arc])
        result.push_back(end);
    return result;
  }

  // Gives each corner a vertex near it: first the pair of the least cost, and so on. Gives curves at corners without a vertex up.
  void assign_corners()
  {
    constexpr std::size_t number_of_candidates = 60; // a guess
    std::vector<std::size_t> outer;
    for(std::size_t v = 0; v < m_mesh.points.size(); ++v)
      if(m_graph.degree(v) > 0)
        outer.push_back(v);
    std::vector<std::tuple<double, std::size_t, std::size_t> > pairs; // cost, vertex, corner
    for(std::size_t c = 0; c < m_complex.corners().size(); ++c)
    {
      if(m_complex.corners()[c].ends.empty()) // another corner stands for it
        continue;
      const Vector_3& p = m_complex.points()[m_complex.corners()[c].vertex];
      const auto is_nearer = [&](const std::size_t v, const std::size_t w)
      { return (m_mesh.points[v] - p).squaredNorm() < (m_mesh.points[w] - p).squaredNorm(); };
      const std::size_t n = (std::min)(number_of_candidates, outer.size());
      std::partial_sort(outer.begin(), outer.begin() + n, outer.end(), is_nearer);
      for(std::size_t i = 0; i < n; ++i)
        pairs.emplace_back(cost_of_corner(c, outer[i]), outer[i], c);
    }
    m_vertices.assign(m_complex.corners().size(), none);
    for(const auto& [v, c] : matched_corners(pairs))
    {
      m_vertices[c] = v;
      m_corner_at[v] = c;
    }
    for(std::size_t c = 0; c < m_vertices.size(); ++c)
      if(m_vertices[c] == none)
        for(const End_of_arc_3& end : m_complex.corners()[c].ends)
          give_up(m_complex.arcs()[end.arc].curve);
  }

  // Returns the cost of a vertex for a corner: for its distance, edges that arcs lack, other normals, and other subdomains.
  double cost_of_corner(const std::size_t c, const std::size_t v) const
  {
    constexpr double price_of_edge = 1.5, price_of_normals = 0.7, price_of_subdomains = 10; // guesses
    const Corner_3& corner = m_complex.corners()[c];
    const Vector_3& p = m_complex.points()[corner.vertex];
    const double missing = static_cast<double>(corner.ends.size()) - static_cast<double>(m_graph.degree(v));
    double turn = 0;
    std::set<int> subdomains, subdomains_of_corner;
    for(std::size_t e = m_graph.first(v); e < m_graph.first(v + 1); ++e)
      subdomains.insert(subdomain(m_graph.left(e)));
    for(const End_of_arc_3& end : corner.ends)
    {
      subdomains_of_corner.insert(m_complex.subdomain(m_complex.left_patch(end)));
      const Vector_3 normal = m_complex.surface(m_complex.left_patch(end)).normal(p);
      double least = 2;
      for(std::size_t e = m_graph.first(v); e < m_graph.first(v + 1); ++e)
        least = (std::min)(least, 1 - normal.dot(m_normals[m_graph.left(e)]));
      turn += least / static_cast<double>(corner.ends.size());
    }
    return (m_mesh.points[v] - p).squaredNorm() / (m_edge * m_edge) + price_of_edge * (std::max)(0., missing)
           + price_of_normals * turn + price_of_subdomains * (subdomains != subdomains_of_corner);
  }

  // Chooses a port for each arc at a corner, the edge by which the arc should leave: those with the least sum of costs. Tries all
  // choices of edges in the order of the body. If edges are too few, ports stay as they are.
  void choose_ports(const std::size_t corner)
  {
    const std::vector<End_of_arc_3> leaving = kept_ends(corner);
    const std::size_t v = m_vertices[corner], n = m_graph.degree(v), number = leaving.size();
    if(number == 0 || number > n)
      return;
    std::vector<std::vector<double> > costs(number);
    for(std::size_t i = 0; i < number; ++i)
      for(std::size_t j = 0; j < n; ++j)
        costs[i].push_back(cost_of_port(corner, leaving[i], m_graph.first(v) + j));
    double least = (std::numeric_limits<double>::infinity)();
    std::vector<std::size_t> ports(number), best;
    const std::function<void(std::size_t, std::size_t, double)> choose
      = [&](const std::size_t i, const std::size_t from, const double sum)
    {
      if(sum >= least)
        return;
      if(i == number)
      {
        least = sum;
        best = ports;
        return;
      }
      const std::size_t end = (i == 0 ? n : ports[0] + n - (number - 1 - i));
      for(std::size_t j = from; j < end; ++j)
      {
        ports[i] = j;
        choose(i + 1, j + 1, sum + costs[i][j % n]);
      }
    };
    choose(0, 0, 0);
    for(std::size_t i = 0; i < number; ++i)
      m_ports[leaving[i].arc][leaving[i].side] = m_graph.target(m_graph.first(v) + best[i] % n);
  }

  // Returns the cost of an edge as port of an arc: for its direction, distance, quadrangles beside it, and another corner there.
  double cost_of_port(const std::size_t corner, const End_of_arc_3& end, const std::size_t e)
  {
    constexpr double price_of_distance = 0.3, price_of_deviation = 0.5, price_of_other_corner = 5; // guesses
    const Polyline_3& line = m_complex.line(end.arc);
    const std::size_t w = m_graph.target(e), other = m_complex.corner({ end.arc, 1 - end.side });
    const Vector_3 way = m_mesh.points[w] - m_mesh.points[m_graph.source(e)];
    const double length = (std::min)(way.norm(), line.length());
    const Vector_3 along
      = line.point(end.side == 0 ? length : line.length() - length) - m_complex.points()[m_complex.corners()[corner].vertex];
    const double result = 1 - way.stableNormalized().dot(along.stableNormalized()) + price_of_distance * distance(w, end.arc)
      + price_of_deviation * (deviation(m_graph.left(e), m_complex.left_patch(end))
                              + deviation(m_graph.left(m_graph.opposite(e)), m_complex.right_patch(end)));
    return result + (m_corner_at[w] != none && m_corner_at[w] != other ? price_of_other_corner : 0);
  }

  // Returns the edges of the cheapest path for an arc; none if there is no path. Each other path at a vertex or edge costs the
  // price, besides what the history of conflicts there costs.
  std::vector<std::size_t> route(const std::size_t arc, const double price)
  {
    const std::size_t source_corner = m_complex.corner({ arc, 0 }), target_corner = m_complex.corner({ arc, 1 });
    const std::size_t source = m_vertices[source_corner], target = m_vertices[target_corner];
    return m_graph.shortest_path(source, target, [&](const std::size_t e)
    {
      const std::size_t v = m_graph.source(e), w = m_graph.target(e);
      if(w == source || (w != target && m_corner_at[w] != none && is_used(m_corner_at[w])) || !has_subdomains(e, arc))
        return (std::numeric_limits<double>::max)();
      double result = cost(e, arc);
      if(w != target)
        result += m_history[w] + price * m_occupied[w];
      result += m_history_of_edges[undirected(e)] + price * m_occupied_edges[undirected(e)];
      if(v == source && w != m_ports[arc][0])
        result += m_penalties[source_corner];
      if(w == target && v != m_ports[arc][1])
        result += m_penalties[target_corner];
      return result;
    });
  }

  // Counts the path of an arc (with the change 1), or counts it no longer (-1), at its edges and the vertices between them.
  void count_path(const std::size_t arc, const int change)
  {
    for(const std::size_t e : m_paths[arc])
    {
      m_occupied_edges[undirected(e)] += change;
      if(e != m_paths[arc].back())
        m_occupied[m_graph.target(e)] += change;
    }
  }

  // Returns whether the paths at a corner leave it in the order of the body.
  bool is_in_order(const std::size_t corner) const
  {
    std::vector<std::size_t> edges;
    for(const End_of_arc_3& end : kept_ends(corner))
      if(const std::vector<std::size_t>& path = m_paths[end.arc]; !path.empty())
        edges.push_back(end.side == 0 ? path.front() : m_graph.opposite(path.back()));
    int number_of_descents = 0;
    for(std::size_t i = 0; i < edges.size() && edges.size() > 1; ++i)
    {
      const std::size_t next = edges[(i + 1) % edges.size()];
      if(edges[i] == next)
        return false;
      number_of_descents += next < edges[i];
    }
    return number_of_descents <= 1;
  }

  // Returns the number of conflicts in the path of an arc, lowered for long paths, which are rather kept. Corners out of order
  // count, too. An arc without a path has more conflicts than others.
  double conflicts(const std::size_t arc) const
  {
    constexpr double without_path = 100, part_of_edge = 0.05; // guesses
    if(m_paths[arc].empty())
      return without_path;
    double result = 0;
    for(const std::size_t e : m_paths[arc])
    {
      result += m_occupied_edges[undirected(e)] - 1;
      if(e != m_paths[arc].back())
        result += m_occupied[m_graph.target(e)] - 1;
    }
    for(const std::size_t side : { 0, 1 })
      result += !is_in_order(m_complex.corner({ arc, side }));
    return result / (1 + part_of_edge * static_cast<double>(m_paths[arc].size()));
  }

  // Gives a curve up: removes the paths of its arcs, and adds their edges at vertices of other paths to the contested ones.
  void give_up(const std::size_t curve)
  {
    for(std::size_t a = 0; a < m_paths.size(); ++a)
      if(m_complex.arcs()[a].curve == curve && !m_is_given_up[a])
      {
        for(const std::size_t e : m_paths[a])
          if((std::max)(m_occupied[m_graph.source(e)], m_occupied[m_graph.target(e)]) > 1)
            m_contested.insert(e);
        count_path(a, -1);
        m_paths[a].clear();
        m_is_given_up[a] = true;
      }
  }

  // Gives up the curve of the arc, of these, whose path is longest relative to the arc. Before that, the arc gets the path that it
  // would have if others left room, as edges of this path are contested.
  void give_up_longest_detour(const std::vector<std::size_t>& arcs)
  {
    std::pair<double, std::size_t> longest = { -1, none };
    for(const std::size_t a : arcs)
    {
      double length = 0;
      for(const std::size_t e : m_paths[a])
        length += (m_mesh.points[m_graph.target(e)] - m_mesh.points[m_graph.source(e)]).norm();
      longest = (std::max)(longest, { length / m_complex.line(a).length(), a });
    }
    replace_path(longest.second, 0);
    give_up(m_complex.arcs()[longest.second].curve);
  }

  void replace_path(const std::size_t arc, const double price)
  {
    count_path(arc, -1);
    m_paths[arc] = route(arc, price);
    count_path(arc, 1);
  }

  // Finds paths of the arcs that are not given up. Returns whether these paths are disjoint and in order. Curves are given up
  // after the last round, or when rounds do not lower a large number of conflicts: one curve, or as many as have a tenth of the
  // conflicts. Since then, only arcs with conflicts get other paths after the first round.
  bool find_paths(const Budget& budget)
  {
    constexpr int number_of_rounds = 45, patience = 12, largest_number_given_up = 60; // guesses
    std::vector<std::size_t> order;
    for(std::size_t a = 0; a < m_paths.size(); ++a)
      order.push_back(a);
    std::sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b)
              { return m_complex.line(a).length() < m_complex.line(b).length(); });
    for(int number_given_up = 0; number_given_up <= largest_number_given_up; )
    {
      m_penalties.assign(m_complex.corners().size(), 1);
      for(std::size_t c = 0; c < m_vertices.size(); ++c)
        if(m_vertices[c] != none)
          choose_ports(c);
      double price = number_given_up == 0 ? 0.3 : 1;
      std::size_t fewest = none, number = none; // of conflicts
      for(int round = 0, in_vain = 0; round < number_of_rounds && in_vain < patience && !budget.is_exhausted();
          ++round, price = (std::min)(1.25 * price, 40.))
      {
        for(const std::size_t a : order)
          if(!m_is_given_up[a] && (round == 0 || number_given_up == 0 || conflicts(a) > 0))
            replace_path(a, price);
        number = number_of_conflicts();
        if(number == 0)
          return true;
        in_vain = number < fewest || 10 * number < m_paths.size() ? 0 : in_vain + 1;
        fewest = (std::min)(fewest, number);
        raise_prices();
      }
      if(budget.is_exhausted())
        return false;
      do
      {
        const std::size_t worst = worst_arc();
        if(worst == none)
          return false;
        give_up(m_complex.arcs()[worst].curve);
        ++number_given_up;
      }
      while(number_of_conflicts() > number - number / 10);
    }
    return false;
  }

  // Returns the arc whose path has most conflicts; none if no path has any.
  std::size_t worst_arc() const
  {
    std::pair<double, std::size_t> worst = { 0, none };
    for(std::size_t a = 0; a < m_paths.size(); ++a)
      if(!m_is_given_up[a])
        worst = (std::max)(worst, { conflicts(a), a });
    return worst.second;
  }

  // Returns the number of vertices and edges in two paths, of corners out of order, and of arcs without a path.
  std::size_t number_of_conflicts() const
  {
    const auto is_shared = [](const int number) { return number > 1; };
    std::size_t result = std::count_if(m_occupied.begin(), m_occupied.end(), is_shared)
                         + std::count_if(m_occupied_edges.begin(), m_occupied_edges.end(), is_shared);
    for(std::size_t c = 0; c < m_penalties.size(); ++c)
      result += !is_in_order(c);
    for(std::size_t a = 0; a < m_paths.size(); ++a)
      result += !m_is_given_up[a] && m_paths[a].empty();
    return result;
  }

  // Raises the prices of vertices, edges and corners with conflicts.
  void raise_prices()
  {
    constexpr double growth_of_history = 0.4, growth_of_penalty = 1.6, largest_penalty = 1e4; // guesses
    const auto raise = [&](const std::vector<int>& occupied, std::vector<double>& history)
    {
      for(std::size_t i = 0; i < occupied.size(); ++i)
        history[i] += growth_of_history * (std::max)(0, occupied[i] - 1);
    };
    raise(m_occupied, m_history);
    raise(m_occupied_edges, m_history_of_edges);
    for(std::size_t c = 0; c < m_penalties.size(); ++c)
      if(!is_in_order(c))
        m_penalties[c] = (std::min)(growth_of_penalty * m_penalties[c], largest_penalty);
  }

  // Sets regions: joins patches across curves that were given up, and quadrangles across edges without a path. Returns the arcs
  // beside wrong quadrangles: paths of other arcs give these another region, or there is a second set of quadrangles for a patch
  // that is not joined to others.
  std::vector<std::size_t> find_regions()
  {
    Disjoint_sets patches(m_complex.number_of_patches()), quadrangles(m_mesh.facets.size());
    std::vector<bool> is_wall(m_graph.number_of_edges(), false);
    for(std::size_t a = 0; a < m_paths.size(); ++a)
    {
      const auto& [left, right] = m_complex.arcs()[a].patches;
      if(m_is_given_up[a])
        patches.unite(left, right);
      for(const std::size_t e : m_paths[a])
        is_wall[e] = is_wall[m_graph.opposite(e)] = true;
    }
    for(std::size_t e = 0; e < is_wall.size(); ++e)
      if(!is_wall[e])
        quadrangles.unite(m_graph.left(e), m_graph.left(m_graph.opposite(e)));
    const std::vector<std::size_t> numbers = patches.numbers();
    m_patches.assign(numbers.empty() ? 0 : 1 + *std::max_element(numbers.begin(), numbers.end()), {});
    for(std::size_t p = 0; p < numbers.size(); ++p)
      m_patches[numbers[p]].insert(p);
    std::map<std::size_t, std::size_t> region_of_set, set_of_region;
    const auto assign_region = [&](const std::size_t e, const std::size_t patch) // to the quadrangles on the left of e
    {
      const std::size_t set = quadrangles.find(m_graph.left(e)), region = numbers[patch];
      return region_of_set.emplace(set, region).first->second == region
             && (set_of_region.emplace(region, set).first->second == set || m_patches[region].size() > 1);
    };
    std::vector<std::size_t> wrong;
    for(std::size_t a = 0; a < m_paths.size(); ++a)
      for(const std::size_t e : m_paths[a])
        if(!assign_region(e, m_complex.arcs()[a].patches[0])
           || !assign_region(m_graph.opposite(e), m_complex.arcs()[a].patches[1]))
          wrong.push_back(a);
    m_regions.clear();
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
    {
      const std::size_t set = quadrangles.find(f);
      if(region_of_set.count(set) == 0) // a component of the boundary without paths
        region_of_set[set] = numbers[nearest_patch(f)];
      m_regions.push_back(region_of_set[set]);
    }
    return wrong;
  }

  // Returns the patch from which a quadrangle deviates least.
  std::size_t nearest_patch(const std::size_t f)
  {
    std::pair<double, std::size_t> nearest = { (std::numeric_limits<double>::infinity)(), 0 };
    for(std::size_t patch = 0; patch < m_complex.number_of_patches(); ++patch)
      nearest = (std::min)(nearest, { deviation(f, patch), patch });
    return nearest.second;
  }

  const Body_complex_3& m_complex;
  const Hexahedra_3& m_mesh;
  const Boundary_graph_3 m_graph;
  const double m_edge;
  std::vector<Vector_3> m_centers, m_normals; // of quadrangles
  std::vector<bool> m_is_given_up;             // of each arc
  std::vector<std::vector<std::size_t> > m_paths; // edges of each arc
  std::vector<std::unordered_map<std::size_t, double> > m_costs, m_deviations; // of edges for arcs, quadrangles for patches
  std::vector<std::array<std::size_t, 2> > m_ports; // second vertices that paths should have from both ends of each arc
  std::vector<std::size_t> m_corner_at, m_vertices; // corner of each vertex, vertex of each corner
  std::vector<double> m_history, m_history_of_edges, m_penalties; // prices of vertices, edges, and corners
  std::vector<int> m_occupied, m_occupied_edges; // numbers of paths
  std::set<std::size_t> m_contested; // edges
  std::vector<std::size_t> m_regions; // of each quadrangle
  std::vector<std::set<std::size_t> > m_patches; // of each region
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_FEATURE_EMBEDDING_3_H
