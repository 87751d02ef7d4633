// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_BODY_INTERFACES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_BODY_INTERFACES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>

#include <map>
#include <memory>

namespace CGAL::Polycube_meshing_3::internal {

// Numbers of patches that meet at a vertex, edge or corner, from 1; 0 stands for the boundary of the body.
using Patches_3 = std::set<std::size_t>;

// Surfaces between the subdomains of a body, cut into smooth patches of two subdomains each, which end at lines: sharp edges,
// edges on the boundary of the body, and those where more than two subdomains meet.
class Body_interfaces_3
{
public:
  using Pair = std::array<int, 2>; // subdomains, the smaller reference first

  Body_interfaces_3(const Tetrahedron_soup_3& soup, const Body_surface_3& boundary)
    : m_points(vectors_of(soup.points)), m_boundary(boundary)
  {
    collect_facets(soup);
    number_patches();
    collect_lines(boundary_facets_3(soup.cells));
  }

  bool empty() const { return m_facets.empty(); }
  const Body_surface_3& boundary() const { return m_boundary; }

  // Returns the points of the corners where exactly these patches meet.
  const std::vector<Vector_3>& corners(const Patches_3& patches) { return m_corners[patches]; }

  // Returns the patches between each pair of subdomains that have an interface.
  const std::map<Pair, Patches_3>& patches_of_pairs() const { return m_patches_of_pair; }

  // Returns the patch for a quadrangle between a pair of subdomains, or 0 if these have no interface. Takes its center, its unit
  // normal out of the first subdomain, and its width. The patch has the least distance plus width times (1 - cosine of normals).
  std::size_t patch_of_quadrangle(const Vector_3& center, const Vector_3& normal, const double width, const Pair& pair)
  {
    std::pair<double, std::size_t> best = { (std::numeric_limits<double>::infinity)(), 0 };
    const auto take_if_better = [&](const std::size_t patch)
    {
      const Body_surface_3& candidate = surface({ patch });
      if(candidate.distance_from_bbox(center) > best.first)
        return;
      const double distance = (candidate.nearest(center, Freedom_3::SURFACE) - center).norm();
      best = (std::min)(best, { distance + width * (1 - candidate.normal(center).dot(normal)), patch });
    };
    if(const auto found = m_patches_of_pair.find(pair); found != m_patches_of_pair.end())
    {
      take_if_better(m_patch_of_facet.at(sorted(surface(found->second).nearest_facet(center))));
      for(const std::size_t patch : found->second)
        take_if_better(patch);
    }
    return best.second;
  }

  // Returns the surface of the patches between two subdomains; the surface of all patches if there is none between these.
  const Body_surface_3& surface_of_pair(const Pair& pair)
  {
    const auto found = m_patches_of_pair.find(pair);
    return surface(found != m_patches_of_pair.end() ? found->second : Patches_3(m_patches.begin(), m_patches.end()));
  }

  // Returns the surface of some patches. Its lines are the edges where exactly these patches meet. If there is no such edge, its
  // lines are the edges where only patches among these meet. With 0 among the patches, its lines are edges on the boundary where
  // all of these patches end, perhaps with others, or, if there is no such edge, where one of them ends.
  const Body_surface_3& surface(const Patches_3& patches)
  {
    std::unique_ptr<Body_surface_3>& result = m_surfaces[patches];
    if(!result)
    {
      std::vector<std::array<std::size_t, 3> > facets;
      for(std::size_t f = 0; f < m_facets.size(); ++f)
        if(patches.count(m_patches[f]) > 0)
          facets.push_back(m_facets[f]);
      const bool is_on_boundary = patches.count(0) > 0;
      std::vector<std::array<std::size_t, 2> > lines_of_all, lines_of_some;
      for(const auto& [edge, meeting] : m_lines)
      {
        if((meeting.count(0) > 0) != is_on_boundary)
          continue;
        const std::size_t number = number_of_common_patches(meeting, patches);
        if(number == patches.size() && (is_on_boundary || meeting == patches))
          lines_of_all.push_back(edge);
        if(is_on_boundary ? number > 1 : number == meeting.size())
          lines_of_some.push_back(edge);
      }
      result = std::make_unique<Body_surface_3>(m_points, facets, lines_of_all.empty() ? lines_of_some : lines_of_all);
    }
    return *result;
  }

  // Returns whether there is an edge where exactly these patches meet.
  bool has_line(const Patches_3& patches) const { return m_patches_at_lines.count(patches) > 0; }

private:
  static std::size_t number_of_common_patches(const Patches_3& some, const Patches_3& others)
  { return std::count_if(some.begin(), some.end(), [&](const std::size_t patch) { return others.count(patch) > 0; }); }

  // Collects the facets between two subdomains. Side 4 c + i is facet i of cell c.
  void collect_facets(const Tetrahedron_soup_3& soup)
  {
    const auto facet_of_side = [&](const std::size_t side) { return facet_of_cell(soup.cells[side / 4], side % 4); };
    const auto facet_and_side = [&](const std::size_t side) { return std::make_pair(sorted(facet_of_side(side)), side); };
    for_each_group(4 * soup.cells.size(), facet_and_side, [&](const auto begin, const auto end)
    {
      if(end - begin != 2)
        return;
      std::size_t side = begin->second, other = (begin + 1)->second;
      if(soup.cell_references[side / 4] > soup.cell_references[other / 4])
        std::swap(side, other);
      const Pair pair = { soup.cell_references[side / 4], soup.cell_references[other / 4] };
      if(pair[0] == pair[1])
        return;
      m_facets.push_back(facet_of_side(side));
      m_pairs.push_back(pair);
    });
  }

  // Joins facets of the same two subdomains to patches, across edges of two facets that are not sharp.
  void number_patches()
  {
    const auto position = [this](const std::size_t v) { return m_points[v]; };
    Disjoint_sets sets(m_facets.size());
    for_each_edge(m_facets, [&](const auto begin, const auto end)
    {
      const std::size_t f = begin->second[0] / 3, g = (end - 1)->second[0] / 3;
      if(end - begin == 2 && m_pairs[f] == m_pairs[g] && !is_sharp_edge(m_facets[f], m_facets[g], position))
        sets.unite(f, g);
    });
    for(const std::size_t number : sets.numbers())
      m_patches.push_back(1 + number);
    for(std::size_t f = 0; f < m_facets.size(); ++f)
    {
      m_patch_of_facet[sorted(m_facets[f])] = m_patches[f];
      m_patches_of_pair[m_pairs[f]].insert(m_patches[f]);
    }
  }

  // Finds the edges where patches meet each other or the boundary of the body, and the corners among their vertices.
  void collect_lines(const std::vector<std::array<std::size_t, 3> >& boundary_facets)
  {
    std::set<std::array<std::size_t, 2> > edges_of_boundary;
    for_each_edge(boundary_facets, [&](const auto begin, auto) { edges_of_boundary.insert(begin->first); });
    std::map<std::size_t, std::vector<Patches_3> > patches_of_edges_at; // vertices
    for_each_edge(m_facets, [&](const auto begin, const auto end)
    {
      Patches_3 patches;
      for(auto it = begin; it != end; ++it)
        patches.insert(m_patches[it->second[0] / 3]);
      if(edges_of_boundary.count(begin->first) > 0)
        patches.insert(0);
      if(patches.size() < 2)
        return;
      m_lines.emplace_back(begin->first, patches);
      m_patches_at_lines.insert(patches);
      for(const std::size_t v : begin->first)
        patches_of_edges_at[v].push_back(patches);
    });
    for(const auto& [v, patches_of_edges] : patches_of_edges_at)
      add_if_corner(m_points[v], patches_of_edges);
  }

  // Adds a point as a corner unless one line goes on through it: two edges with the same patches, away from lines of the boundary.
  void add_if_corner(const Vector_3& p, const std::vector<Patches_3>& patches_of_edges)
  {
    Patches_3 patches;
    for(const Patches_3& of_edge : patches_of_edges)
      patches.insert(of_edge.begin(), of_edge.end());
    const bool is_on_one_line = patches_of_edges.size() == 2 && patches_of_edges[0] == patches_of_edges[1];
    if(!is_on_one_line || (patches.count(0) > 0 && m_boundary.is_on_line(p)))
      m_corners[patches].push_back(p);
  }

  const std::vector<Vector_3> m_points;
  const Body_surface_3& m_boundary;
  std::vector<std::array<std::size_t, 3> > m_facets; // their normals point out of the first subdomain
  std::vector<Pair> m_pairs;                         // of each facet
  std::vector<std::size_t> m_patches;                // of each facet
  std::map<std::array<std::size_t, 3>, std::size_t> m_patch_of_facet;
  std::map<Pair, Patches_3> m_patches_of_pair;
  std::vector<std::pair<std::array<std::size_t, 2>, Patches_3> > m_lines;
  std::set<Patches_3> m_patches_at_lines;
  std::map<Patches_3, std::vector<Vector_3> > m_corners; // by the patches that meet there
  std::map<Patches_3, std::unique_ptr<Body_surface_3> > m_surfaces; // results of surface(), made at the first call
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_BODY_INTERFACES_3_H
