// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_INTERFACE_POSITIONS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_INTERFACE_POSITIONS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_interfaces_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Quadrangle_of_hexahedron.h>

namespace CGAL::Polycube_meshing_3::internal {

// Quadrangle between hexahedra of two subdomains, as a side of both, the smaller reference first, and the patch of the
// body's interfaces that it belongs to; 0 if it has none.
struct Interface_quadrangle_3
{
  std::array<std::size_t, 4> vertices; // in the order in which the first hexahedron has them
  std::array<Quadrangle_of_hexahedron, 2> sides;
  std::size_t patch = 0;
};

// Returns the subdomains on both sides.
inline Body_interfaces_3::Pair pair_of(const Hexahedra_3& mesh, const Interface_quadrangle_3& q)
{ return { mesh.cell_references[q.sides[0].cell], mesh.cell_references[q.sides[1].cell] }; }

// Returns the quadrangles between parts of the hexahedra, in the order of their sorted vertices.
inline std::vector<Interface_quadrangle_3> quadrangles_between_3(const Hexahedra_3& mesh, const std::vector<int>& parts)
{
  std::vector<Interface_quadrangle_3> result;
  for_each_quadrangle(mesh, [&](const auto begin, const auto end)
  {
    if(end - begin != 2)
      return;
    Quadrangle_of_hexahedron q = begin->second, r = (begin + 1)->second;
    if(parts[q.cell] > parts[r.cell])
      std::swap(q, r);
    if(parts[q.cell] != parts[r.cell])
      result.push_back({ vertices_of(mesh, q), { q, r } });
  });
  return result;
}

inline std::vector<Interface_quadrangle_3> interface_quadrangles_3(const Hexahedra_3& mesh)
{ return quadrangles_between_3(mesh, mesh.cell_references); }

// Finds the patch of each quadrangle: that nearest to its center, and then that of most of its neighbors.
inline void set_patches(const Hexahedra_3& mesh, Body_interfaces_3& interfaces,
                        std::vector<Interface_quadrangle_3>& quadrangles)
{
  constexpr int number_of_rounds = 3; // a guess
  std::vector<Body_interfaces_3::Pair> pairs;
  std::map<std::array<std::size_t, 2>, std::vector<std::size_t> > at_edges;
  for(Interface_quadrangle_3& q : quadrangles)
  {
    const Eigen::Vector3d area = area_vector(mesh.points, q.vertices);
    for(std::size_t i = 0; i < 4; ++i)
      at_edges[edge_of_quadrangle(q.vertices, i)].push_back(pairs.size());
    pairs.push_back(pair_of(mesh, q));
    q.patch = interfaces.patch_of_quadrangle(center_of(mesh.points, q.vertices), area.stableNormalized(),
                                             std::sqrt(area.norm()), pairs.back());
  }
  for(int round = 0; round < number_of_rounds; ++round)
  {
    std::vector<std::map<std::size_t, int> > neighbors(quadrangles.size()); // their number in each patch of the pair
    for(const auto& [edge, at_edge] : at_edges)
      for(const std::size_t i : at_edge)
        for(const std::size_t j : at_edge)
          if(i != j && pairs[i] == pairs[j])
            ++neighbors[i][quadrangles[j].patch];
    for(std::size_t i = 0; i < quadrangles.size(); ++i)
      for(const auto& [patch, number] : neighbors[i])
        if(number > 2)
          quadrangles[i].patch = patch;
  }
}

// Returns the corner of each vertex that gets one: of the nearest pair, then of the nearest one of others, and so on. Takes the
// distance, vertex and corner of all pairs.
template <typename Corner>
std::map<std::size_t, Corner> nearest_pairs(std::vector<std::tuple<double, std::size_t, Corner> > pairs)
{
  std::sort(pairs.begin(), pairs.end());
  std::map<std::size_t, Corner> result;
  std::set<Corner> taken;
  for(const auto& [distance, v, corner] : pairs)
    if(result.count(v) == 0 && taken.insert(corner).second)
      result.emplace(v, corner);
  return result;
}

// Where the vertices on interfaces are put, and where they may move.
struct Interface_positions_3
{
  struct Position
  {
    const Body_surface_3* surface = nullptr; // none: the vertex is on no interface
    Freedom_3 freedom = Freedom_3::NONE;
    Eigen::Vector3d point;
  };

  std::vector<Position> of_vertices;
  // The quadrangles of each patch that is to be covered by them.
  std::vector<std::pair<const Body_surface_3*, std::vector<std::array<std::size_t, 4> > > > covered;
};

// Finds the positions of vertices on interfaces by the patches that meet there: on a patch; on a line where just these meet, in
// the body as well; or in a corner that has them, each of which is given to the vertex nearest to it. Vertices on the boundary
// are on lines there, or have no position if none of their interfaces ends near them. `freedom` is that of vertices without
// interfaces: where a line of the boundary holds them, an interface crosses the line in a corner.
inline Interface_positions_3 interface_positions_3(const Hexahedra_3& mesh,
                                                   const std::vector<Interface_quadrangle_3>& quadrangles,
                                                   const std::vector<Freedom_3>& freedom, Body_interfaces_3& interfaces)
{
  constexpr double largest_move = 1.5; // a guess; on the boundary, relative to the width of a quadrangle
  std::vector<Patches_3> patches(mesh.points.size());
  std::vector<double> width(mesh.points.size(), 0);
  std::map<std::size_t, std::vector<std::array<std::size_t, 4> > > of_patches;
  for(const Interface_quadrangle_3& q : quadrangles)
    if(q.patch != 0)
    {
      of_patches[q.patch].push_back(q.vertices);
      for(const std::size_t v : q.vertices)
      {
        patches[v].insert(q.patch);
        width[v] = (std::max)(width[v], std::sqrt(area_vector(mesh.points, q.vertices).norm()));
      }
    }
  Interface_positions_3 result;
  for(const auto& [patch, of_patch] : of_patches)
    result.covered.emplace_back(&interfaces.surface({ patch }), of_patch);

  result.of_vertices.resize(mesh.points.size());
  using Corner = std::pair<Patches_3, std::size_t>; // number of a corner where these patches meet
  std::vector<std::tuple<double, std::size_t, Corner> > ways; // squared distance, vertex, corner
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    if(patches[v].empty())
      continue;
    const bool is_outer = freedom[v] != Freedom_3::SPACE;
    if(is_outer)
      patches[v].insert(0);
    const Body_surface_3& surface = interfaces.surface(patches[v]);
    const Eigen::Vector3d& p = mesh.points[v];
    if(is_outer && (!surface.has_lines() || (surface.nearest(p, Freedom_3::LINE) - p).norm() > largest_move * width[v]))
      continue; // a line of the same patches elsewhere would take the vertex away
    Interface_positions_3::Position& position = result.of_vertices[v];
    position.surface = &surface;
    position.freedom = patches[v].size() > 1 && surface.has_lines() ? Freedom_3::LINE : Freedom_3::SURFACE;
    position.point = surface.nearest(p, position.freedom);
    const bool is_on_line_of_boundary = freedom[v] == Freedom_3::LINE || freedom[v] == Freedom_3::NONE;
    if(patches[v].size() > 1 && (is_on_line_of_boundary || !interfaces.has_line(patches[v])))
      for(std::size_t c = 0; c < interfaces.corners(patches[v]).size(); ++c)
        ways.emplace_back((p - interfaces.corners(patches[v])[c]).squaredNorm(), v, Corner(patches[v], c));
  }
  for(const auto& [v, corner] : nearest_pairs(std::move(ways)))
  {
    result.of_vertices[v].freedom = Freedom_3::NONE;
    result.of_vertices[v].point = interfaces.corners(corner.first)[corner.second];
  }
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_INTERFACE_POSITIONS_3_H
