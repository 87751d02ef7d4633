// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_INTERFACE_QUADRANGLES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_INTERFACE_QUADRANGLES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_interfaces_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/scaled_jacobians.h>

namespace CGAL::Polycube_meshing_3::internal {

// Quadrangle between hexahedra of two subdomains, as a side of both, the smaller reference first, and the patch of the
// body's interfaces that it belongs to; 0 if it has none.
struct Interface_quadrangle_3
{
  std::array<std::size_t, 4> vertices; // in the order in which the first hexahedron has them
  std::array<Quadrangle_of_hexahedron, 2> sides;
  std::size_t patch = 0;
};

// Returns the subdomains on both sides, the smaller reference first.
inline Body_interfaces_3::Pair subdomains_of(const Hexahedra_3& mesh, const Interface_quadrangle_3& q)
{ return { mesh.cell_references[q.sides[0].cell], mesh.cell_references[q.sides[1].cell] }; }

// Returns the quadrangles between hexahedra of different parts, in the order of their sorted vertices, without patches. Takes the
// part of each hexahedron; the sides of quadrangles have the smaller part first.
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

// Returns the quadrangles between subdomains, without patches.
inline std::vector<Interface_quadrangle_3> interface_quadrangles_3(const Hexahedra_3& mesh)
{ return quadrangles_between_3(mesh, mesh.cell_references); }

// Sets the patch of each quadrangle: first that nearest to its center, and then, in each round, one that most neighbors have.
inline void set_patches(const Hexahedra_3& mesh, Body_interfaces_3& interfaces,
                        std::vector<Interface_quadrangle_3>& quadrangles)
{
  constexpr int number_of_rounds = 3; // a guess
  std::vector<Body_interfaces_3::Pair> pairs; // of subdomains, of each quadrangle
  std::map<std::array<std::size_t, 2>, std::vector<std::size_t> > quadrangles_at_edges;
  for(Interface_quadrangle_3& q : quadrangles)
  {
    const Vector_3 area = area_vector(mesh.points, q.vertices);
    for(std::size_t i = 0; i < 4; ++i)
      quadrangles_at_edges[edge_of_quadrangle(q.vertices, i)].push_back(pairs.size());
    pairs.push_back(subdomains_of(mesh, q));
    q.patch = interfaces.patch_of_quadrangle(center_of(mesh.points, q.vertices), area.stableNormalized(),
                                             std::sqrt(area.norm()), pairs.back());
  }
  for(int round = 0; round < number_of_rounds; ++round)
  {
    std::vector<std::map<std::size_t, int> > numbers_of_neighbors(quadrangles.size()); // in each patch of the pair
    for(const auto& [edge, at_edge] : quadrangles_at_edges)
      for(const std::size_t i : at_edge)
        for(const std::size_t j : at_edge)
          if(i != j && pairs[i] == pairs[j])
            ++numbers_of_neighbors[i][quadrangles[j].patch];
    for(std::size_t i = 0; i < quadrangles.size(); ++i)
      for(const auto& [patch, number] : numbers_of_neighbors[i])
        if(number > 2) // of four edges
          quadrangles[i].patch = patch;
  }
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_INTERFACE_QUADRANGLES_3_H
