// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_BODY_COMPLEX_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_BODY_COMPLEX_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Mapped_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Polyline_3.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace CGAL::Polycube_meshing_3::internal {

// Part of a curve of the body between two corners of its complex, and the patches on its left and right, seen from outside.
struct Arc_3
{
  std::size_t curve;
  int reference; // of the edges of the curve
  std::vector<std::size_t> vertices; // with those at both corners
  std::array<std::size_t, 2> patches;
};

// End of an arc: its first vertex (side 0) or its last one (side 1).
struct End_of_arc_3
{
  std::size_t arc, side;
};

// Corner of the complex, with the arcs that end there, counterclockwise as seen from outside.
struct Corner_3
{
  std::size_t vertex;
  bool is_of_body; // or is only a cut of a closed curve?
  std::vector<End_of_arc_3> ends = {};
};

// Boundary of a body as a complex of corners, curves and patches. Curves are the sharp edges, but not seams, which have one patch
// on both sides. Corners are marked points, and those where curves meet, end or turn. Closed curves are cut into arcs.
class Body_complex_3
{
public:
  // Takes the width in which hexahedra have no room, and the least length, in widths, of a needle: a small angle between two arcs.
  // If the width is positive, edges between subdomains are curves, too, and arcs shorter than the width become corners. Two arcs
  // along a needle share their part within the width, because hexahedra between the arcs would be too flat.
  Body_complex_3(const Mapped_soup_3& soup, const std::vector<Vector_3>& points, const double width_without_room = 0,
                 const double length_of_needles = 8)
    : m_points(points), m_facets(boundary_facets_3(soup.cells))
  {
    const std::vector<int> subdomains = subdomains_of_facets(soup);
    std::vector<Edge> edges = sharp_edges_3(m_facets, soup.edges, [&](const std::size_t v) { return points[v]; });
    if(width_without_room > 0)
      add_edges_between(subdomains, edges);
    m_patches = patches_of_facets(m_facets, edges);
    m_left = facets_on_left(m_facets);
    find_arcs(edges, soup);
    collect_ends();
    if(width_without_room > 0 && is_manifold())
    {
      contract_short_arcs(width_without_room);
      share_needles(width_without_room, length_of_needles * width_without_room);
    }
    make_surfaces();
    m_subdomains.resize(m_surfaces.size());
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      m_subdomains[m_patches[f]] = subdomains[f];
  }

  bool is_manifold() const { return m_left.size() == 3 * m_facets.size(); } // with one facet on the left of each directed edge
  std::size_t number_of_patches() const { return m_surfaces.size(); }
  std::size_t number_of_curves() const { return m_number_of_curves; }
  const std::vector<Vector_3>& points() const { return m_points; }
  const std::vector<Arc_3>& arcs() const { return m_arcs; }
  const std::vector<Corner_3>& corners() const { return m_corners; }
  const Polyline_3& line(const std::size_t arc) const { return m_lines[arc]; }
  const Body_surface_3& surface(const std::size_t patch) const { return *m_surfaces[patch]; }
  int subdomain(const std::size_t patch) const { return m_subdomains[patch]; } // the only one if the width is positive

  // Returns the corner where an arc ends.
  std::size_t corner(const End_of_arc_3& end) const { return m_corners_of_arcs[end.arc][end.side]; }

  // Returns the patch on the left or right of an arc, seen from this end of it.
  std::size_t left_patch(const End_of_arc_3& end) const { return m_arcs[end.arc].patches[end.side]; }
  std::size_t right_patch(const End_of_arc_3& end) const { return m_arcs[end.arc].patches[1 - end.side]; }

  std::size_t patch_of_facet(const std::array<std::size_t, 3>& facet) const { return patch_on_left(facet[0], facet[1]); }

  // Returns whether this complex has the arcs of another one.
  bool has_arcs_of(const Body_complex_3& other) const
  {
    return std::equal(m_arcs.begin(), m_arcs.end(), other.m_arcs.begin(), other.m_arcs.end(),
                      [](const Arc_3& a, const Arc_3& b) { return a.vertices == b.vertices; });
  }

  // Returns the center of the largest facet of a patch.
  Vector_3 point_in_patch(const std::size_t patch) const
  {
    std::pair<double, std::size_t> largest = { -1, 0 };
    const auto position = [&](const std::size_t v) { return m_points[v]; };
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      if(m_patches[f] == patch)
        largest = (std::max)(largest, { area_of_facet(edges_of_facet(m_facets[f], position)), f });
    const auto& [a, b, c] = m_facets[largest.second];
    return (m_points[a] + m_points[b] + m_points[c]) / 3;
  }

  // Returns the facets of patches.
  std::vector<std::array<std::size_t, 3> > facets_of(const std::set<std::size_t>& patches) const
  {
    std::vector<std::array<std::size_t, 3> > result;
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      if(patches.count(m_patches[f]) > 0)
        result.push_back(m_facets[f]);
    return result;
  }

private:
  using Edge = std::array<std::size_t, 2>;

  std::vector<int> subdomains_of_facets(const Mapped_soup_3& soup) const
  {
    std::map<std::array<std::size_t, 3>, int> references;
    for(std::size_t c = 0; c < soup.cells.size(); ++c)
      for(std::size_t i = 0; i < 4; ++i)
        references[sorted(facet_of_cell(soup.cells[c], i))] = soup.cell_references[c];
    std::vector<int> result;
    for(const std::array<std::size_t, 3>& facet : m_facets)
      result.push_back(references.at(sorted(facet)));
    return result;
  }

  // Adds the edges between facets of different subdomains to edges, which remain sorted.
  void add_edges_between(const std::vector<int>& subdomains, std::vector<Edge>& edges) const
  {
    for_each_edge(m_facets, [&](const auto begin, const auto end)
    {
      if(subdomains[begin->second[0] / 3] != subdomains[(end - 1)->second[0] / 3])
        edges.push_back(begin->first);
    });
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  }

  // Returns the patch on the left of the edge from v to w; the first patch if no facet has this directed edge.
  std::size_t patch_on_left(const std::size_t v, const std::size_t w) const
  {
    const auto found = m_left.find({ v, w });
    return found == m_left.end() ? 0 : m_patches[found->second];
  }

  // Makes arcs of sharp edges between different patches, and finds their corners. A seam that meets a curve makes a corner there,
  // and a curve that has a reference may turn without one.
  void find_arcs(const std::vector<Edge>& edges, const Mapped_soup_3& soup)
  {
    std::map<Edge, int> references;
    for(std::size_t e = 0; e < soup.edges.size(); ++e)
      references.emplace(sorted(soup.edges[e]), soup.edge_references.empty() ? 0 : soup.edge_references[e]);
    const auto reference = [&](const std::size_t v, const std::size_t w)
    {
      const auto found = references.find(sorted(Edge{ v, w }));
      return found == references.end() ? 0 : found->second;
    };
    const Neighbors_along_edges with_seams = neighbors_along_edges(edges);
    std::vector<Edge> edges_of_curves = edges;
    edges_of_curves.erase(std::remove_if(edges_of_curves.begin(), edges_of_curves.end(), [&](const Edge& e)
    { return patch_on_left(e[0], e[1]) == patch_on_left(e[1], e[0]); }), edges_of_curves.end());
    const Neighbors_along_edges neighbors = neighbors_along_edges(edges_of_curves);
    const std::set<std::size_t> marked(soup.corners.begin(), soup.corners.end());
    std::set<std::size_t> corners;
    for(const auto& [v, around] : neighbors)
    {
      const auto turns = [&, v = v](const std::size_t w, const std::size_t x)
      {
        return reference(v, w) != reference(v, x)
          || (reference(v, w) == 0 && turns_sharply(m_points[v] - m_points[w], m_points[x] - m_points[v]));
      };
      if(around.size() != 2 || with_seams.at(v).size() != 2 || marked.count(v) > 0 || turns(around[0], around[1]))
        corners.insert(v);
    }
    for(const std::vector<std::size_t>& vertices : curves_along_edges(neighbors, corners))
      add_curve(vertices, reference(vertices[0], vertices[1]));
    for(std::size_t a = 0; a < m_arcs.size(); ++a)
      for(const std::size_t v : { m_arcs[a].vertices.front(), m_arcs[a].vertices.back() })
        if(m_numbers.emplace(v, m_corners.size()).second)
          m_corners.push_back({ v, corners.count(v) > 0 });
  }

  // Adds a curve; cuts a closed one into three arcs of like lengths.
  void add_curve(const std::vector<std::size_t>& vertices, const int reference)
  {
    const std::size_t n = vertices.size() - 1, number_of_arcs = vertices.front() == vertices.back() && n >= 3 ? 3 : 1;
    const Polyline_3 line = line_through(vertices);
    Arc_3 arc = { m_number_of_curves, reference, { vertices[0] }, {} };
    for(std::size_t i = 1, part = 1; i <= n; ++i)
    {
      arc.vertices.push_back(vertices[i]);
      if(i < n && (part == number_of_arcs || (3 * line.lengths()[i] < static_cast<double>(part) * line.length()
                                              && n - i > number_of_arcs - part)))
        continue;
      arc.patches = { patch_on_left(arc.vertices[0], arc.vertices[1]), patch_on_left(arc.vertices[1], arc.vertices[0]) };
      m_arcs.push_back(arc);
      arc.vertices = { vertices[i] };
      ++part;
    }
    ++m_number_of_curves;
  }

  // Finds the arcs at each corner, in the order of the facets around it.
  void collect_ends()
  {
    std::map<Edge, End_of_arc_3> ends; // by the first edge, from the corner
    for(std::size_t a = 0; a < m_arcs.size(); ++a)
    {
      const std::vector<std::size_t>& v = m_arcs[a].vertices;
      ends[{ v[0], v[1] }] = { a, 0 };
      ends[{ v.back(), v[v.size() - 2] }] = { a, 1 };
      m_corners_of_arcs.push_back({ m_numbers.at(v.front()), m_numbers.at(v.back()) });
      m_lines.push_back(line_through(v));
    }
    if(!is_manifold())
      return; // facets around a corner might not be in a circle
    for(Corner_3& corner : m_corners)
    {
      const auto begin = ends.lower_bound({ corner.vertex, 0 });
      std::size_t w = begin->first[1];
      const std::size_t first = w;
      do
      {
        if(const auto found = ends.find({ corner.vertex, w }); found != ends.end())
          corner.ends.push_back(found->second);
        const auto left = m_left.find({ corner.vertex, w });
        if(left == m_left.end())
          break;
        const std::array<std::size_t, 3>& facet = m_facets[left->second];
        const std::size_t i = std::find(facet.begin(), facet.end(), corner.vertex) - facet.begin();
        w = facet[(i + 2) % 3];
      }
      while(w != first);
    }
  }

  Polyline_3 line_through(const std::vector<std::size_t>& vertices) const
  {
    std::vector<Vector_3> points;
    for(const std::size_t v : vertices)
      points.push_back(m_points[v]);
    return Polyline_3(points);
  }

  // Makes one corner of both ends of each arc that is shorter than a distance, unless other arcs join them, too.
  void contract_short_arcs(const double length)
  {
    for(std::size_t a = 0; a < m_arcs.size(); )
    {
      const auto [c, d] = m_corners_of_arcs[a];
      const auto number_of_arcs = std::count_if(m_corners[c].ends.begin(), m_corners[c].ends.end(), [&, d = d](const auto& end)
                                                { return corner({ end.arc, 1 - end.side }) == d; });
      if(c != d && number_of_arcs == 1 && m_lines[a].length() < length)
        contract(a);
      else
        ++a;
    }
  }

  // Lets the arcs at the second corner of an arc end at the first one, in its place.
  void contract(const std::size_t a)
  {
    const auto [c, d] = m_corners_of_arcs[a];
    const auto is_of_arc = [&](const End_of_arc_3& end) { return end.arc == a; };
    std::vector<End_of_arc_3>& at_c = m_corners[c].ends;
    std::vector<End_of_arc_3> at_d = std::exchange(m_corners[d].ends, {});
    std::rotate(at_d.begin(), std::find_if(at_d.begin(), at_d.end(), is_of_arc), at_d.end());
    at_d.erase(at_d.begin());
    for(const End_of_arc_3& end : at_d)
    {
      std::vector<std::size_t>& vertices = m_arcs[end.arc].vertices;
      (end.side == 0 ? vertices.front() : vertices.back()) = m_corners[c].vertex;
      m_lines[end.arc] = line_through(vertices);
      m_corners_of_arcs[end.arc][end.side] = c;
    }
    at_c.insert(at_c.erase(std::find_if(at_c.begin(), at_c.end(), is_of_arc)), at_d.begin(), at_d.end());
    for(Corner_3& corner : m_corners)
      for(End_of_arc_3& end : corner.ends)
        end.arc -= end.arc > a;
    m_arcs.erase(m_arcs.begin() + a);
    m_lines.erase(m_lines.begin() + a);
    m_corners_of_arcs.erase(m_corners_of_arcs.begin() + a);
  }

  // Shares needles at all corners but new ones, as long as there are any.
  void share_needles(const double width, const double least_length)
  {
    const std::size_t n = m_corners.size();
    for(std::size_t c = 0; c < n; ++c)
      for(std::size_t i = 0; i < m_corners[c].ends.size() && m_corners[c].ends.size() > 1; )
        if(!share_needle(c, i, width, least_length))
          ++i;
  }

  // Lets end i at a corner and the next one share their first part, up to a new corner, if the arcs are close to each other for a
  // least length. The part of the arc with the smaller detour is kept. Returns whether the arcs share a part now.
  bool share_needle(const std::size_t c, const std::size_t i, const double width, const double least_length)
  {
    const std::size_t next = (i + 1) % m_corners[c].ends.size();
    End_of_arc_3 kept = m_corners[c].ends[i], other = m_corners[c].ends[next];
    if(kept.arc == other.arc)
      return false;
    const bool is_other_left = detour(kept.arc) <= detour(other.arc);
    if(!is_other_left)
      std::swap(kept, other);
    const double shared_of_other = shared_length(kept, other, width),
                 length_along_kept = m_lines[kept.arc].nearest(point_at(other, shared_of_other)).second,
                 shared_of_kept = length_from(kept, length_along_kept);
    if(shared_of_kept < least_length || m_lines[kept.arc].length() - shared_of_kept < 2 * width
       || m_lines[other.arc].length() - shared_of_other < 2 * width)
      return false;
    m_points.push_back(m_lines[kept.arc].point(length_along_kept));
    add_shared_arc(c, kept, other, shared_of_kept, is_other_left);
    begin_at_last_corner(kept, shared_of_kept);
    begin_at_last_corner(other, shared_of_other);
    m_corners[c].ends[i] = { m_arcs.size() - 1, 0 };
    m_corners[c].ends.erase(m_corners[c].ends.begin() + next);
    return true;
  }

  // Adds the first part of an arc, from corner c, as an arc to a new corner at the last point. The patch between the arc and the
  // other one, which is on its left or right, is not beside this part.
  void add_shared_arc(const std::size_t c, const End_of_arc_3& kept, const End_of_arc_3& other, const double length,
                      const bool is_other_left)
  {
    Arc_3 shared = m_arcs[kept.arc];
    shared.vertices = vertices_between(kept, 0, (1 - rounding) * length);
    shared.vertices.push_back(m_points.size() - 1);
    shared.patches = { left_patch(is_other_left ? other : kept), right_patch(is_other_left ? kept : other) };
    const End_of_arc_3 back = { m_arcs.size(), 1 };
    m_corners_of_arcs.push_back({ c, m_corners.size() });
    m_corners.push_back({ m_points.size() - 1, false, { kept, other, back } });
    if(!is_other_left)
      std::swap(m_corners.back().ends[0], m_corners.back().ends[1]);
    m_lines.push_back(line_through(shared.vertices));
    m_arcs.push_back(shared);
  }

  // Cuts the part up to a length off an end of an arc. The arc has this end at the last corner then.
  void begin_at_last_corner(const End_of_arc_3& end, const double length)
  {
    std::vector<std::size_t> vertices = vertices_between(end, (1 + rounding) * length, 2 * m_lines[end.arc].length());
    vertices.insert(vertices.begin(), m_corners.back().vertex);
    if(end.side == 1)
      std::reverse(vertices.begin(), vertices.end());
    m_arcs[end.arc].vertices = vertices;
    m_corners_of_arcs[end.arc][end.side] = m_corners.size() - 1;
    m_lines[end.arc] = line_through(vertices);
  }

  static constexpr double rounding = 1e-9; // of lengths

  // Returns how much longer an arc is than its chord.
  double detour(const std::size_t arc) const
  { return m_lines[arc].length() - (m_lines[arc].points().front() - m_lines[arc].points().back()).norm(); }

  // Returns a length along an arc as one from an end of it, and vice versa.
  double length_from(const End_of_arc_3& end, const double length) const
  { return end.side == 0 ? length : m_lines[end.arc].length() - length; }

  // Returns the point of an arc at a length from one of its ends.
  Vector_3 point_at(const End_of_arc_3& end, const double length) const
  { return m_lines[end.arc].point(length_from(end, length)); }

  // Returns the length from its end up to which the other arc remains within the width of the kept one.
  double shared_length(const End_of_arc_3& kept, const End_of_arc_3& other, const double width) const
  {
    constexpr double step = 0.25; // a guess; in widths
    double result = 0;
    while(result < m_lines[other.arc].length()
          && m_lines[kept.arc].nearest(point_at(other, result + step * width)).first <= width)
      result += step * width;
    return result;
  }

  // Returns the vertices of an arc at lengths from one of its ends in [first, last), in the order from there.
  std::vector<std::size_t> vertices_between(const End_of_arc_3& end, const double first, const double last) const
  {
    std::vector<std::pair<double, std::size_t> > vertices;
    for(std::size_t k = 0; k < m_arcs[end.arc].vertices.size(); ++k)
      if(const double length = length_from(end, m_lines[end.arc].lengths()[k]); length >= first && length < last)
        vertices.emplace_back(length, m_arcs[end.arc].vertices[k]);
    std::sort(vertices.begin(), vertices.end());
    std::vector<std::size_t> result;
    for(const auto& [length, v] : vertices)
      result.push_back(v);
    return result;
  }

  void make_surfaces()
  {
    const std::size_t n = m_patches.empty() ? 0 : 1 + *std::max_element(m_patches.begin(), m_patches.end());
    for(std::size_t patch = 0; patch < n; ++patch)
      m_surfaces.push_back(std::make_unique<Body_surface_3>(m_points, facets_of({ patch })));
  }

  std::vector<Vector_3> m_points;
  const std::vector<std::array<std::size_t, 3> > m_facets;
  std::vector<std::size_t> m_patches; // of each facet
  std::map<Edge, std::size_t> m_left; // facet on the left of a directed edge
  std::size_t m_number_of_curves = 0;
  std::vector<Arc_3> m_arcs;
  std::vector<Polyline_3> m_lines; // of arcs
  std::vector<Corner_3> m_corners;
  std::map<std::size_t, std::size_t> m_numbers; // of corners, by their vertices
  std::vector<std::array<std::size_t, 2> > m_corners_of_arcs;
  std::vector<std::unique_ptr<Body_surface_3> > m_surfaces; // of patches
  std::vector<int> m_subdomains; // of patches
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FEATURES_BODY_COMPLEX_3_H
