// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_PLACED_FEATURES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_PLACED_FEATURES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/scaled_jacobians.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Features/Layer_removal_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Layers/Padding_3.h>

namespace CGAL::Polycube_meshing_3::internal {

// Distance from a curve, in edges, that its bends keep: a guess.
constexpr double distance_of_bends = 0.06;

// Hexahedra with the places of an embedding: each quadrangle of the boundary has a region, and vertices are at a corner, on an
// arc, in a region or inside. Starts with hexahedra that have one layer along the boundary.
class Placed_features_3
{
public:
  // Takes the length of edges without distortion, and whether layers along the boundary may be removed if they are not needed.
  Placed_features_3(const Body_complex_3& complex, const Feature_embedding_3& embedding, const Hexahedra_3& mesh,
                    const double edge, const Body_surface_3& boundary, const bool may_remove_layers)
    : m_complex(complex), m_embedding(embedding), m_mesh(mesh), m_edge(edge), m_boundary(boundary)
  {
    take_embedding();
    find_arcs_of_edges();
    const std::set<std::size_t> cramped = cramped_regions();
    if(may_remove_layers)
      remove_layers(cramped);
    while(add_rings(cramped))
    {}
    add_sheets(cramped);
    collect_locations();
    make_surfaces();
    const std::vector<Vector_3> start = m_mesh.points;
    move_to_arcs();
    move_into_regions();
    move_inside(start);
  }

  bool has_removed_layers() const { return m_has_removed_layers; }

  // Returns the hexahedra with their positions, which refer to surfaces of this object.
  Placed_hexahedra_3 result() const
  {
    Placed_hexahedra_3 result = { m_mesh, {}, { { &m_boundary, {}, tolerance_of_boundary } } };
    for(std::size_t v = 0; v < m_mesh.points.size(); ++v)
    {
      const Location& location = m_locations[v];
      result.positions.push_back({ m_mesh.points[v], surface(location), location.freedom, location.freedom != Freedom_3::SPACE });
    }
    for(const std::array<std::size_t, 4>& q : m_mesh.facets)
      result.covered.front().add(q);
    return result;
  }

private:
  using Edge = std::array<std::size_t, 2>;

  struct Location
  {
    Freedom_3 freedom = Freedom_3::SPACE;
    std::size_t number = 0; // of a corner, an arc or a region
  };

  const Body_surface_3* surface(const Location& location) const
  {
    return location.freedom == Freedom_3::LINE ? m_lines[location.number].get()
         : location.freedom == Freedom_3::SURFACE ? m_surfaces[location.number].get() : &m_boundary;
  }

  // Takes the vertices of paths, the corners and the regions over from the embedding.
  void take_embedding()
  {
    const Boundary_graph_3& graph = m_embedding.graph();
    for(std::size_t a = 0; a < m_complex.arcs().size(); ++a)
    {
      std::vector<std::size_t> vertices;
      for(const std::size_t e : m_embedding.path(a))
        vertices.push_back(graph.source(e));
      if(!vertices.empty())
        vertices.push_back(graph.target(m_embedding.path(a).back()));
      m_paths.push_back(vertices);
    }
    for(std::size_t c = 0; c < m_complex.corners().size(); ++c)
      if(m_embedding.is_used(c))
        m_corners[m_embedding.vertex(c)] = c;
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
      m_regions.push_back(m_embedding.region(f));
  }

  // Finds the arc of each edge in a path, anew if the paths have changed.
  void find_arcs_of_edges()
  {
    m_arc_of_edge.clear();
    for(std::size_t a = 0; a < m_paths.size(); ++a)
      for(std::size_t i = 1; i < m_paths[a].size(); ++i)
        m_arc_of_edge[sorted(Edge{ m_paths[a][i - 1], m_paths[a][i] })] = a;
  }

  // Returns whether an edge is between two regions. Patches on both sides of an arc are one region if another arc was given up.
  bool is_border(const Edge& edge) const
  {
    const auto arc = m_arc_of_edge.find(edge);
    if(arc == m_arc_of_edge.end())
      return false;
    const auto& [left, right] = m_complex.arcs()[arc->second].patches;
    return std::none_of(m_embedding.patches().begin(), m_embedding.patches().end(),
                        [&, l = left, r = right](const std::set<std::size_t>& patches)
                        { return patches.count(l) > 0 && patches.count(r) > 0; });
  }

  // Returns the angle of a region at a corner, in radians, counterclockwise from the second arc to the first one.
  double angle(const std::size_t corner, const std::size_t first, const std::size_t second, const std::size_t region) const
  {
    const Vector_3& p = m_complex.points()[m_complex.corners()[corner].vertex];
    const auto direction = [&](const std::size_t arc)
    {
      const Polyline_3& line = m_complex.line(arc);
      const double length = (std::min)(0.3 * m_edge, 0.2 * line.length()); // guesses
      const bool is_first = m_complex.corner({ arc, 0 }) == corner;
      return (line.point(is_first ? length : line.length() - length) - p).stableNormalized();
    };
    const std::set<std::size_t>& patches = m_embedding.patches()[region];
    const auto distance = [&](const std::size_t patch)
    { return (m_complex.surface(patch).nearest(p, Freedom_3::SURFACE) - p).norm(); };
    const std::size_t patch = *std::min_element(patches.begin(), patches.end(), [&](const std::size_t a, const std::size_t b)
                                                { return distance(a) < distance(b); });
    const Vector_3 d = direction(first), e = direction(second), n = m_complex.surface(patch).normal(p);
    const double result = std::atan2(n.dot(e.cross(d)), d.dot(e));
    return result < 0 ? result + 2 * CGAL_PI : result;
  }

  // Returns whether a quadrangle has two edges on one curve, or two edges of paths that meet without a corner between them, or at
  // a corner where the region is almost straight.
  bool is_cramped(const std::size_t f) const
  {
    constexpr double largest_angle = 2.6; // a guess; in radians, 149 degrees
    const std::array<std::size_t, 4>& q = m_mesh.facets[f];
    std::map<std::size_t, std::set<std::size_t> > vertices_of_curve;
    for(std::size_t i = 0; i < 4; ++i)
    {
      const auto before = m_arc_of_edge.find(edge_of_quadrangle(q, i + 3)), after = m_arc_of_edge.find(edge_of_quadrangle(q, i));
      if(after == m_arc_of_edge.end())
        continue;
      vertices_of_curve[m_complex.arcs()[after->second].curve].insert({ q[i], q[(i + 1) % 4] });
      if(before == m_arc_of_edge.end())
        continue;
      const auto corner = m_corners.find(q[i]);
      if(corner == m_corners.end() || m_complex.arcs()[before->second].curve == m_complex.arcs()[after->second].curve
         || angle(corner->second, before->second, after->second, m_regions[f]) > largest_angle)
        return true;
    }
    return std::any_of(vertices_of_curve.begin(), vertices_of_curve.end(),
                       [](const auto& curve) { return curve.second.size() > 2; }); // those of two opposite edges
  }

  std::set<std::size_t> cramped_regions() const
  {
    std::set<std::size_t> result;
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
      if(is_cramped(f))
        result.insert(m_regions[f]);
    return result;
  }

  // Removes the layer along the boundary where it is not needed, and updates paths, corners and regions.
  void remove_layers(const std::set<std::size_t>& cramped)
  {
    const Layer_removal_3 removal(m_complex, m_embedding, m_mesh, cramped);
    m_has_removed_layers = removal.result().cells.size() < m_mesh.cells.size();
    m_mesh = removal.result();
    for(std::vector<std::size_t>& path : m_paths)
      path = removal.path(path);
    std::map<std::size_t, std::size_t> corners;
    for(const auto& [v, c] : m_corners)
      corners[removal.vertex(v)] = c;
    m_corners = corners;
    std::vector<std::size_t> regions;
    for(const std::size_t f : removal.facets())
      regions.push_back(m_regions[f]);
    m_regions = regions;
    find_arcs_of_edges();
  }

  // Returns the tips of regions: quadrangles that alone fill a small angle between two paths at a corner, with the place of the
  // corner among their vertices. A tip is free if it has no other corner, and no path at the vertex opposite to the corner.
  std::map<std::size_t, std::size_t> tips(const std::set<std::size_t>& regions, const bool are_free) const
  {
    constexpr double largest_angle = 0.9; // a guess; in radians, 52 degrees
    std::set<std::size_t> in_paths;
    for(const std::vector<std::size_t>& path : m_paths)
      in_paths.insert(path.begin(), path.end());
    std::map<std::size_t, std::size_t> result;
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
      for(std::size_t i = 0; i < 4 && regions.count(m_regions[f]) > 0; ++i)
      {
        const std::array<std::size_t, 4>& q = m_mesh.facets[f];
        const auto before = m_arc_of_edge.find(edge_of_quadrangle(q, i + 3)), after = m_arc_of_edge.find(edge_of_quadrangle(q, i));
        const bool is_free = in_paths.count(q[(i + 2) % 4]) == 0
                             && m_corners.count(q[(i + 1) % 4]) + m_corners.count(q[(i + 3) % 4]) == 0;
        if(const auto corner = m_corners.find(q[i]);
           is_free == are_free && corner != m_corners.end() && before != m_arc_of_edge.end() && after != m_arc_of_edge.end()
           && angle(corner->second, before->second, after->second, m_regions[f]) < largest_angle)
          result[f] = i;
      }
    return result;
  }

  // Puts rings of hexahedra around corners of tips that are not free: the smaller tips are. A corner has no ring if its hexahedra
  // are in another ring, or have a quadrangle of the boundary without the corner. Returns whether there are new rings, outside of
  // which other corners may have rings, too.
  bool add_rings(const std::set<std::size_t>& cramped)
  {
    std::map<std::size_t, std::vector<std::size_t> > cells_at; // of vertices at corners with a ring
    for(const auto& [f, i] : tips(cramped, false))
      cells_at[m_mesh.facets[f][i]];
    for(std::size_t c = 0; c < m_mesh.cells.size(); ++c)
      for(const std::size_t v : m_mesh.cells[c])
        if(const auto found = cells_at.find(v); found != cells_at.end())
          found->second.push_back(c);
    std::set<Quadrangle_of_hexahedron> on_boundary;
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
      on_boundary.insert({ m_mesh.facet_cells[f], side_of_facet(m_mesh, f) });
    std::vector<int> parts(m_mesh.cells.size(), 0);
    std::vector<Quadrangle_of_hexahedron> covered;
    for(auto it = cells_at.begin(); it != cells_at.end(); )
    {
      std::vector<Quadrangle_of_hexahedron> around;
      for(const std::size_t c : it->second)
        for(std::size_t side = 0; side < 6; ++side)
          if(const auto q = vertices_of(m_mesh, { c, side }); std::find(q.begin(), q.end(), it->first) == q.end())
            around.push_back({ c, side });
      if(std::any_of(around.begin(), around.end(), [&](const auto& q) { return parts[q.cell] > 0 || on_boundary.count(q) > 0; }))
      {
        it = cells_at.erase(it);
        continue;
      }
      for(const std::size_t c : it->second)
        parts[c] = static_cast<int>(1 + it->first);
      covered.insert(covered.end(), around.begin(), around.end());
      ++it;
    }
    if(!covered.empty())
      insert_rings(cells_at, covered, parts);
    return !covered.empty();
  }

  // Covers quadrangles around the hexahedra at corners, and leads paths through the rings.
  void insert_rings(const std::map<std::size_t, std::vector<std::size_t> >& cells_at,
                    const std::vector<Quadrangle_of_hexahedron>& covered, const std::vector<int>& parts)
  {
    const Hexahedra_3 before = std::exchange(m_mesh, Padding_3(m_mesh, covered, parts).result());
    std::map<std::pair<std::size_t, Edge>, std::size_t> regions; // by hexahedra and edges of their quadrangles
    for(std::size_t f = 0; f < before.facets.size(); ++f)
      for(std::size_t i = 0; i < 4; ++i)
        regions[{ before.facet_cells[f], edge_of_quadrangle(before.facets[f], i) }] = m_regions[f];
    for(std::size_t f = before.facets.size(); f < m_mesh.facets.size(); ++f)
    {
      std::vector<std::size_t> outer;
      for(const std::size_t v : m_mesh.facets[f])
        if(v < before.points.size())
          outer.push_back(v);
      const std::size_t c = covered[m_mesh.facet_cells[f] - before.cells.size()].cell;
      m_regions.push_back(regions.at({ c, sorted(Edge{ outer[0], outer[1] }) }));
    }
    const auto vertex_in_ring = [&](const std::size_t corner, const std::size_t v)
    {
      std::size_t result = v;
      for(const std::size_t c : cells_at.at(corner))
        for(std::size_t k = 0; k < 8; ++k)
          if(before.cells[c][k] == v)
            result = m_mesh.cells[c][k];
      return result;
    };
    for(std::vector<std::size_t>& path : m_paths)
    {
      if(!path.empty() && cells_at.count(path.front()) > 0)
        path.insert(path.begin() + 1, vertex_in_ring(path.front(), path[1]));
      if(!path.empty() && cells_at.count(path.back()) > 0)
        path.insert(path.end() - 1, vertex_in_ring(path.back(), path[path.size() - 2]));
    }
    find_arcs_of_edges();
  }

  // Puts sheets of hexahedra around the layer under each region with a cramped quadrangle, so that no other quadrangle there has
  // two edges on its curves. Tips stay outside, as a sheet would halve their angles.
  void add_sheets(const std::set<std::size_t>& cramped)
  {
    const std::map<std::size_t, std::size_t> outside = tips(cramped, true);
    std::set<Edge> edges_of_tips;
    for(const auto& [f, i] : outside)
      for(std::size_t k = 0; k < 4; ++k)
        edges_of_tips.insert(edge_of_quadrangle(m_mesh.facets[f], k));
    std::vector<int> parts(m_mesh.cells.size(), 0);
    std::vector<Quadrangle_of_hexahedron> covered;
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
    {
      if(cramped.count(m_regions[f]) == 0 || outside.count(f) > 0)
        continue;
      const std::size_t c = m_mesh.facet_cells[f];
      parts[c] = static_cast<int>(1 + m_regions[f]);
      const std::array<std::size_t, 4>& top = m_mesh.facets[f];
      for(std::size_t side = 0; side < 6; ++side)
      {
        std::vector<std::size_t> common;
        for(const std::size_t v : vertices_of(m_mesh, { c, side }))
          if(std::find(top.begin(), top.end(), v) != top.end())
            common.push_back(v);
        const Edge edge = common.size() == 2 ? sorted(Edge{ common[0], common[1] }) : Edge();
        if(common.empty() || (common.size() == 2 && (is_border(edge) || edges_of_tips.count(edge) > 0)))
          covered.push_back({ c, side });
      }
    }
    if(covered.empty())
      return;
    const std::size_t number = m_mesh.cells.size();
    m_mesh = Padding_3(m_mesh, covered, parts).result();
    for(std::size_t f = m_regions.size(); f < m_mesh.facets.size(); ++f)
      m_regions.push_back(parts[covered[m_mesh.facet_cells[f] - number].cell] - 1);
  }

  // Finds the locations of all vertices, and the regions at those of the boundary.
  void collect_locations()
  {
    m_locations.resize(m_mesh.points.size());
    m_regions_at.resize(m_mesh.points.size());
    for(std::size_t f = 0; f < m_mesh.facets.size(); ++f)
      for(const std::size_t v : m_mesh.facets[f])
      {
        m_locations[v] = { Freedom_3::SURFACE, m_regions[f] };
        m_regions_at[v].insert(m_regions[f]);
      }
    for(std::size_t a = 0; a < m_paths.size(); ++a)
      for(const std::size_t v : m_paths[a])
        m_locations[v] = { Freedom_3::LINE, a };
    for(const auto& [v, c] : m_corners)
      m_locations[v] = { Freedom_3::NONE, c };
  }

  // Makes the surface of each region, and for each arc the surface of the patches beside it, with the arc as line.
  void make_surfaces()
  {
    for(const std::set<std::size_t>& patches : m_embedding.patches())
      m_surfaces.push_back(std::make_unique<Body_surface_3>(m_complex.points(), m_complex.facets_of(patches)));
    for(const Arc_3& arc : m_complex.arcs())
    {
      std::vector<std::array<std::size_t, 2> > edges;
      for(std::size_t i = 1; i < arc.vertices.size(); ++i)
        edges.push_back({ arc.vertices[i - 1], arc.vertices[i] });
      m_lines.push_back(std::make_unique<Body_surface_3>(m_complex.points(),
                                                         m_complex.facets_of({ arc.patches[0], arc.patches[1] }), edges));
    }
  }

  // Puts the vertices of paths on their arcs: some at bends, where they stay, and the others near the nearest points, in order.
  void move_to_arcs()
  {
    for(std::size_t a = 0; a < m_paths.size(); ++a)
    {
      const std::vector<std::size_t>& path = m_paths[a];
      const Polyline_3& line = m_complex.line(a);
      if(path.size() < 3)
        continue;
      std::vector<double> lengths;
      for(const std::size_t v : path)
        lengths.push_back(line.nearest(m_mesh.points[v]).second);
      lengths.front() = 0;
      lengths.back() = line.length();
      spread(0, path.size() - 1, lengths);
      std::size_t first = 0;
      const std::vector<double> bends = bends_for(path.size() - 1, line);
      const std::vector<std::size_t> at_bends = vertices_at(bends, lengths);
      for(std::size_t k = 0; k < bends.size(); ++k)
      {
        lengths[at_bends[k]] = bends[k];
        m_locations[path[at_bends[k]]].freedom = Freedom_3::NONE;
        spread(first, at_bends[k], lengths);
        first = at_bends[k];
      }
      spread(first, path.size() - 1, lengths);
      for(std::size_t i = 1; i + 1 < path.size(); ++i)
        m_mesh.points[path[i]] = line.point(lengths[i]);
    }
    for(const auto& [v, c] : m_corners)
      m_mesh.points[v] = m_complex.points()[m_complex.corners()[c].vertex];
  }

  // Returns the bends of a line, as lengths along it: fewer than a path has edges, as each needs a vertex between two edges.
  std::vector<double> bends_for(const std::size_t number_of_edges, const Polyline_3& line) const
  {
    constexpr double growth = 1.2; // a guess
    double distance = distance_of_bends * m_edge;
    std::vector<double> result = line.bends(distance);
    while(result.size() >= number_of_edges)
      result = line.bends(distance *= growth);
    return result;
  }

  // Returns the index in its path of a vertex for each bend, in order, with the least sum of squared distances. Takes the lengths
  // along the line of bends and vertices.
  static std::vector<std::size_t> vertices_at(const std::vector<double>& bends, const std::vector<double>& lengths)
  {
    std::vector<std::vector<double> > least( // for the first bends among the first vertices
      bends.size() + 1, std::vector<double>(lengths.size() - 1, (std::numeric_limits<double>::infinity)()));
    least[0].assign(lengths.size() - 1, 0);
    for(std::size_t k = 1; k <= bends.size(); ++k)
      for(std::size_t i = 1; i + 1 < lengths.size(); ++i)
        least[k][i] = (std::min)(least[k][i - 1], least[k - 1][i - 1] + std::pow(lengths[i] - bends[k - 1], 2));
    std::vector<std::size_t> result(bends.size());
    for(std::size_t k = bends.size(), i = lengths.size() - 2; k > 0; --k, --i)
    {
      while(least[k][i] == least[k][i - 1])
        --i;
      result[k - 1] = i;
    }
    return result;
  }

  // Makes the lengths between the indices first and last increase by a least distance each. Blends them with equal distances, and
  // lowers the k-th one by k least distances. Pools adjacent violators (isotonic regression), and adds these distances again.
  static void spread(const std::size_t first, const std::size_t last, std::vector<double>& lengths)
  {
    constexpr double part_of_equal_distances = 0.25, least_distance = 0.45; // guesses; the latter relative to the mean
    const double step = (lengths[last] - lengths[first]) / static_cast<double>(last - first), gap = least_distance * step;
    std::vector<std::pair<double, std::size_t> > blocks; // mean and number of lengths
    for(std::size_t i = first + 1; i < last; ++i)
    {
      const double k = static_cast<double>(i - first);
      blocks.emplace_back((1 - part_of_equal_distances) * (lengths[i] - lengths[first]) + part_of_equal_distances * k * step
                          - k * gap, 1);
      while(blocks.size() > 1 && blocks[blocks.size() - 2].first > blocks.back().first)
      {
        const auto [mean, number] = blocks.back();
        blocks.pop_back();
        auto& [other_mean, other_number] = blocks.back();
        other_mean = (other_mean * static_cast<double>(other_number) + mean * static_cast<double>(number))
                     / static_cast<double>(other_number + number);
        other_number += number;
      }
    }
    const double largest = (lengths[last] - lengths[first]) - gap * static_cast<double>(last - first);
    std::size_t i = first + 1;
    for(const auto& [mean, number] : blocks)
      for(std::size_t k = 0; k < number; ++k, ++i)
        lengths[i] = lengths[first] + std::clamp(mean, 0., largest) + gap * static_cast<double>(i - first);
  }

  // Returns for each vertex v the vertices w at the other ends of its edges for which `is_neighbor(v, w)` is true.
  template <typename Predicate>
  std::vector<std::vector<std::size_t> > neighbors(const Predicate& is_neighbor) const
  {
    std::vector<std::vector<std::size_t> > result(m_mesh.points.size());
    for_each_corner(m_mesh, [&](const std::array<std::size_t, 4>& corner)
    {
      for(std::size_t i = 1; i < 4; ++i)
        if(is_neighbor(corner[0], corner[i]))
          result[corner[0]].push_back(corner[i]);
    });
    for(std::vector<std::size_t>& around : result)
    {
      std::sort(around.begin(), around.end());
      around.erase(std::unique(around.begin(), around.end()), around.end());
    }
    return result;
  }

  // Puts vertices in regions near the means of their neighbors there.
  void move_into_regions()
  {
    constexpr int number_of_sweeps = 15, sweeps_between_projections = 5; // guesses
    const std::set<Edge> edges = boundary_edges_3(m_mesh);
    const auto is_joined = [&](const std::size_t v, const std::size_t w)
    { return m_locations[v].freedom == Freedom_3::SURFACE && edges.count(sorted(Edge{ v, w })) > 0; };
    const auto around = neighbors(is_joined);
    for(int sweep = 0; sweep <= number_of_sweeps; ++sweep)
      for(std::size_t v = 0; v < around.size(); ++v)
        if(m_locations[v].freedom == Freedom_3::SURFACE)
        {
          if(sweep > 0)
            m_mesh.points[v] = mean_of(m_mesh.points, around[v]);
          if(sweep % sweeps_between_projections == 0)
            m_mesh.points[v] = surface(m_locations[v])->nearest(m_mesh.points[v], Freedom_3::SURFACE);
        }
  }

  // Returns the unit vector into the body whose least angle with the regions at a vertex is largest, up to steps of a search.
  Vector_3 direction_inside(const std::size_t v) const
  {
    constexpr int number_of_steps = 60; // a guess
    std::vector<Vector_3> normals;
    Vector_3 result = Vector_3::Zero();
    for(const std::size_t region : m_regions_at[v])
    {
      normals.push_back(-m_surfaces[region]->normal(m_mesh.points[v]));
      result += normals.back();
    }
    result = result.stableNormalized();
    for(int step = 0; step < number_of_steps; ++step)
    {
      const Vector_3& worst = *std::min_element(normals.begin(), normals.end(), [&](const Vector_3& n, const Vector_3& m)
                                                { return n.dot(result) < m.dot(result); });
      result = (result + 0.5 / (step + 2) * worst).stableNormalized();
    }
    return result;
  }

  // Puts the vertices under the boundary near it, in the direction inside, and lets all others follow: each moves by the mean of
  // the moves of its neighbors from the start. Therefore, hexahedra far inside remain valid.
  void move_inside(const std::vector<Vector_3>& start)
  {
    constexpr double depth = 0.3;       // a guess; relative to the edges at the vertex
    constexpr int number_of_sweeps = 50; // a guess
    const auto around = neighbors([](std::size_t, std::size_t) { return true; });
    const auto is_inside = [&](const std::size_t v) { return m_locations[v].freedom == Freedom_3::SPACE; };
    std::vector<bool> may_follow(around.size());
    for(std::size_t v = 0; v < around.size(); ++v)
      may_follow[v] = is_inside(v);
    for(std::size_t v = 0; v < around.size(); ++v)
    {
      if(is_inside(v))
        continue;
      std::vector<std::size_t> inner;
      double length = 0;
      for(const std::size_t w : around[v])
        if(is_inside(w))
          inner.push_back(w);
        else
          length += (m_mesh.points[w] - m_mesh.points[v]).norm();
      if(inner.size() != 1)
        continue;
      length /= static_cast<double>(around[v].size() - 1);
      const std::size_t w = inner[0];
      m_mesh.points[w]
        = m_mesh.points[v] + (std::min)({ depth * length, depth * m_edge, (start[w] - start[v]).norm() }) * direction_inside(v);
      may_follow[w] = false;
    }
    for(int sweep = 0; sweep < number_of_sweeps; ++sweep)
      for(std::size_t v = 0; v < around.size(); ++v)
        if(may_follow[v])
        {
          Vector_3 way = Vector_3::Zero();
          for(const std::size_t w : around[v])
            way += (m_mesh.points[w] - start[w]) / static_cast<double>(around[v].size());
          m_mesh.points[v] = start[v] + way;
        }
  }

  const Body_complex_3& m_complex;
  const Feature_embedding_3& m_embedding;
  Hexahedra_3 m_mesh;
  const double m_edge;
  const Body_surface_3& m_boundary;
  bool m_has_removed_layers = false;
  std::map<Edge, std::size_t> m_arc_of_edge;           // the arc of each edge in a path
  std::vector<std::vector<std::size_t> > m_paths; // vertices of each arc
  std::map<std::size_t, std::size_t> m_corners;  // by their vertices
  std::vector<std::size_t> m_regions;            // of each quadrangle
  std::vector<Location> m_locations;
  std::vector<std::set<std::size_t> > m_regions_at; // vertices of the boundary
  std::vector<std::unique_ptr<Body_surface_3> > m_surfaces, m_lines; // of regions and arcs
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_PLACED_FEATURES_3_H
