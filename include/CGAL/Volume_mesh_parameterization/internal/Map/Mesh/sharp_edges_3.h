// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SHARP_EDGES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SHARP_EDGES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <cmath>
#include <map>
#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the cosine of the angle between the normals of two facets.
template <typename Facet, typename Position>
double cosine_between_facets(const Facet& f, const Facet& g, const Position& position)
{
  const auto normal = [&](const Facet& facet)
  {
    const auto [a, b] = edges_of_facet(facet, position);
    return a.cross(b).stableNormalized();
  };
  return normal(f).dot(normal(g));
}

// Returns whether the edge between two facets is sharp.
template <typename Facet, typename Position>
bool is_sharp_edge(const Facet& f, const Facet& g, const Position& position, const bool are_oriented_alike = true)
{
  constexpr double cosine_of_sharp_edge = 0.5 + 1e-6; // a guess; 60 degrees between normals up to rounding, as of a hexagon
  return (are_oriented_alike ? 1 : -1) * cosine_between_facets(f, g, position) < cosine_of_sharp_edge;
}

// Returns whether a curve of sharp edges ends between two of its edges, as it turns there.
inline bool turns_sharply(const Vector_3& edge, const Vector_3& next)
{
  const double cosine_of_smooth_turn = std::sqrt(0.5); // a guess; 45 degrees
  return edge.stableNormalized().dot(next.stableNormalized()) < cosine_of_smooth_turn;
}

// Returns whether the edge between two points leads along an axis, bit by bit, as edges of a polycube and lines in its faces do.
inline bool leads_along_axis(const Vector_3& p, const Vector_3& q)
{ return (p[0] != q[0]) + (p[1] != q[1]) + (p[2] != q[2]) == 1; }

// Returns the sharp edges of a surface, the smaller vertex first: those among the marked ones, or if there are none, those
// whose normals on both sides make 60 degrees or more.
template <typename Vertex, typename Position>
std::vector<std::array<Vertex, 2> > sharp_edges_3(const std::vector<std::array<Vertex, 3> >& facets,
                                                  std::vector<std::array<Vertex, 2> > marked, const Position& position)
{
  for(std::array<Vertex, 2>& edge : marked)
    edge = sorted(edge);
  std::sort(marked.begin(), marked.end());
  std::vector<std::array<Vertex, 2> > found, by_angle;
  for_each_edge(facets, [&](const auto begin, const auto end)
  {
    if(std::binary_search(marked.begin(), marked.end(), begin->first))
      found.push_back(begin->first);
    const auto is_forward = [](const auto& corners) { return corners[1] % 3 == (corners[0] + 1) % 3; };
    const bool are_oriented_alike = end - begin != 2 || is_forward(begin->second) != is_forward((end - 1)->second);
    if(is_sharp_edge(facets[begin->second[0] / 3], facets[(end - 1)->second[0] / 3], position, are_oriented_alike))
      by_angle.push_back(begin->first);
  });
  return found.empty() ? by_angle : found;
}

// Returns the numbers of the patches of facets, which are joined across all edges but sorted borders, the smaller vertex first.
template <typename Vertex>
std::vector<std::size_t> patches_of_facets(const std::vector<std::array<Vertex, 3> >& facets,
                                           const std::vector<std::array<Vertex, 2> >& borders)
{
  Disjoint_sets sets(facets.size());
  for_each_edge(facets, [&](const auto begin, const auto end)
  {
    if(!std::binary_search(borders.begin(), borders.end(), begin->first))
      for(auto it = begin + 1; it != end; ++it)
        sets.unite(begin->second[0] / 3, it->second[0] / 3);
  });
  return sets.numbers();
}

// Returns the facet on the left of each directed edge.
inline std::map<std::array<std::size_t, 2>, std::size_t> facets_on_left(const std::vector<std::array<std::size_t, 3> >& facets)
{
  std::map<std::array<std::size_t, 2>, std::size_t> result;
  for(std::size_t f = 0; f < facets.size(); ++f)
    for(std::size_t i = 0; i < 3; ++i)
      result[{ facets[f][i], facets[f][(i + 1) % 3] }] = f;
  return result;
}

using Neighbors_along_edges = std::map<std::size_t, std::vector<std::size_t> >;

inline Neighbors_along_edges neighbors_along_edges(const std::vector<std::array<std::size_t, 2> >& edges)
{
  Neighbors_along_edges result;
  for(const auto& [v, w] : edges)
  {
    result[v].push_back(w);
    result[w].push_back(v);
  }
  return result;
}

// Returns the vertices where curves end: those without two neighbors, and if asked for, those where a curve turns sharply.
template <typename Position>
std::set<std::size_t> corners_of_curves(const Neighbors_along_edges& neighbors, const Position& position,
                                        const bool do_end_at_turns = true)
{
  std::set<std::size_t> result;
  for(const auto& [v, around] : neighbors)
    if(around.size() != 2
       || (do_end_at_turns && turns_sharply(position(v) - position(around[0]), position(around[1]) - position(v))))
      result.insert(v);
  return result;
}

// Returns the vertices of curves between corners, among which all vertices without two neighbors are. A closed curve begins and
// ends at the same vertex.
inline std::vector<std::vector<std::size_t> > curves_along_edges(const Neighbors_along_edges& neighbors,
                                                                 const std::set<std::size_t>& corners)
{
  std::set<std::array<std::size_t, 2> > used;
  std::vector<std::vector<std::size_t> > result;
  const auto follow_all = [&](const std::size_t first)
  {
    for(const std::size_t second : neighbors.at(first))
      if(used.insert(sorted(std::array<std::size_t, 2>{ first, second })).second)
      {
        std::vector<std::size_t> curve = { first, second };
        for(std::size_t v = second, last = first; corners.count(v) == 0 && v != first; curve.push_back(v))
        {
          const std::vector<std::size_t>& around = neighbors.at(v);
          last = std::exchange(v, around[0] == last ? around[1] : around[0]);
          used.insert(sorted(std::array<std::size_t, 2>{ last, v }));
        }
        result.push_back(std::move(curve));
      }
  };
  for(const std::size_t v : corners)
    follow_all(v);
  for(const auto& [v, around] : neighbors) // of closed curves without a corner
    follow_all(v);
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SHARP_EDGES_3_H
