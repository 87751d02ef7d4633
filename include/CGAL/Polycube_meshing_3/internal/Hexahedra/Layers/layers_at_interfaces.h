// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_LAYERS_LAYERS_AT_INTERFACES_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_LAYERS_LAYERS_AT_INTERFACES_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/Positions_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Layers/Layer_choice_3.h>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the sides of quadrangles of interfaces that get a layer of hexahedra. A side needs a layer if its hexahedron has another
// quadrangle in the patch: the patch is smooth, and the angle between both almost straight. A layer extends over all quadrangles
// of interfaces of its subdomain that vertices join. Side i is that of quadrangle i / 2 with the index i % 2.
inline std::vector<Quadrangle_of_hexahedron>
sides_with_layer_3(const Hexahedra_3& mesh, const std::vector<Interface_quadrangle_3>& quadrangles)
{
  Disjoint_sets sets(2 * quadrangles.size()); // of sides
  std::map<std::pair<std::size_t, int>, std::size_t> side_at;      // by vertex and subdomain
  std::set<std::array<std::size_t, 2> > cells_and_patches;         // met so far
  std::vector<std::size_t> sides_in_need;
  for(std::size_t i = 0; i < 2 * quadrangles.size(); ++i)
  {
    const Interface_quadrangle_3& q = quadrangles[i / 2];
    const Quadrangle_of_hexahedron& side = q.sides[i % 2];
    for(const std::size_t v : q.vertices)
      sets.unite(i, side_at.emplace(std::make_pair(v, mesh.cell_references[side.cell]), i).first->second);
    if(!cells_and_patches.insert({ side.cell, q.patch }).second)
      sides_in_need.push_back(i);
  }
  std::set<std::size_t> sets_with_layer;
  for(const std::size_t i : sides_in_need)
    sets_with_layer.insert(sets.find(i));
  std::vector<Quadrangle_of_hexahedron> result;
  for(std::size_t i = 0; i < 2 * quadrangles.size(); ++i)
    if(sets_with_layer.count(sets.find(i)) > 0)
      result.push_back(quadrangles[i / 2].sides[i % 2]);
  return result;
}

// Returns the patches in which a quadrangle has a straight corner: two of its edges separate patches, and meet at a vertex
// that moves along a smooth line. Takes the position of each vertex.
inline Patches_3 patches_with_straight_corners(const std::vector<Interface_quadrangle_3>& quadrangles,
                                               const std::vector<Position_3>& positions)
{
  std::map<std::array<std::size_t, 2>, Patches_3> patches_at; // edges
  const auto edge = [](const Interface_quadrangle_3& q, const std::size_t i) { return edge_of_quadrangle(q.vertices, i); };
  for(const Interface_quadrangle_3& q : quadrangles)
    for(std::size_t i = 0; i < 4; ++i)
      patches_at[edge(q, i)].insert(q.patch);
  Patches_3 result;
  for(const Interface_quadrangle_3& q : quadrangles)
    for(std::size_t i = 0; i < 4; ++i)
      if(q.patch != 0 && patches_at[edge(q, i)].size() > 1 && patches_at[edge(q, i + 1)].size() > 1
         && positions[q.vertices[(i + 1) % 4]].freedom == Freedom_3::LINE)
        result.insert(q.patch);
  return result;
}

// Patches of quadrangles of interfaces, by their sorted vertices, which a layer on a side of a quadrangle keeps.
using Patches_of_quadrangles_3 = std::map<std::array<std::size_t, 4>, std::size_t>;

inline Patches_of_quadrangles_3 patches_by_vertices_3(const std::vector<Interface_quadrangle_3>& quadrangles)
{
  Patches_of_quadrangles_3 result;
  for(const Interface_quadrangle_3& q : quadrangles)
    result.emplace(sorted(q.vertices), q.patch);
  return result;
}

// Returns hexahedra with a layer around those on both sides of each of these patches, and updates the quadrangles of interfaces.
// Quadrangles of the patch have one edge each on its lines then. Returns the same mesh if a hexahedron is at two of the patches.
inline Hexahedra_3 with_enclosed_patches(const Hexahedra_3& mesh, const Patches_3& patches,
                                         std::vector<Interface_quadrangle_3>& quadrangles)
{
  std::vector<int> parts(mesh.cells.size(), 0); // numbers of the patches; 0 for other hexahedra
  const Patches_of_quadrangles_3 old_patches = patches_by_vertices_3(quadrangles);
  for(const Interface_quadrangle_3& q : quadrangles)
    for(const Quadrangle_of_hexahedron& side : q.sides)
      if(int& part = parts[side.cell]; patches.count(q.patch) > 0)
      {
        if(part != 0 && part != static_cast<int>(q.patch))
          return mesh;
        part = static_cast<int>(q.patch);
      }
  std::vector<Quadrangle_of_hexahedron> covered;
  for(const Interface_quadrangle_3& q : quadrangles_between_3(mesh, parts))
    std::copy_if(q.sides.begin(), q.sides.end(), std::back_inserter(covered),
                 [&](const Quadrangle_of_hexahedron& side) { return parts[side.cell] != 0; });
  const Hexahedra_3 result = Padding_3(mesh, covered, parts).result();
  for(const Quadrangle_of_hexahedron& side : covered)
    parts.push_back(parts[side.cell]);
  quadrangles = interface_quadrangles_3(result);
  for(Interface_quadrangle_3& q : quadrangles)
  {
    const int part = parts[q.sides[0].cell];
    const bool is_in_part = part != 0 && part == parts[q.sides[1].cell];
    q.patch = is_in_part ? static_cast<std::size_t>(part) : old_patches.at(sorted(q.vertices));
  }
  return result;
}

// Moves vertices of the domain that are on interfaces to the images of their positions, but not out of planes of the boundary.
inline void move_to_images_of_positions(const Body_with_domain_3& body, const std::vector<Position_3>& positions,
                                        Hexahedra_3& domain)
{
  std::vector<std::array<bool, 3> > is_held(domain.points.size());
  for(const std::array<std::size_t, 4>& facet : domain.facets)
    for(const std::size_t v : facet)
      is_held[v][axis_of_facet(domain.points, facet)] = true;
  for(std::size_t v = 0; v < domain.points.size(); ++v)
    if(positions[v].surface != &body.surface) // on an interface: vertices inside have the surface of the body, too
      if(const auto image = body.map.nearest_image(exact_point(positions[v].point)))
        for(int axis = 0; axis < 3; ++axis)
          if(!is_held[v][axis])
            domain.points[v][axis] = image->point[axis];
}

// Returns hexahedra of a domain, moved to the images of interfaces, with the layers that these need. Sets the quadrangles of
// interfaces. Returns the domain as it is once the budget is exhausted.
inline Hexahedra_3 with_layers_at_interfaces(const Body_with_domain_3& body, Hexahedra_3 domain, Body_interfaces_3& interfaces,
                                             const Budget& budget, std::vector<Interface_quadrangle_3>& quadrangles)
{
  const Hexahedra_3 mesh = pulled_back(body, domain, budget);
  if(mesh.cells.empty())
    return domain;
  std::vector<Interface_quadrangle_3> plain_quadrangles = interface_quadrangles_3(mesh);
  set_patches(mesh, interfaces, plain_quadrangles);
  const std::vector<Position_3> positions = Search_for_positions_3(mesh, plain_quadrangles, interfaces).run();
  move_to_images_of_positions(body, positions, domain);
  domain = Padding_3(domain, sides_with_layer_3(domain, plain_quadrangles), domain.cell_references).result();
  quadrangles = interface_quadrangles_3(domain);
  const Patches_of_quadrangles_3 plain_patches = patches_by_vertices_3(plain_quadrangles);
  for(Interface_quadrangle_3& q : quadrangles)
    q.patch = plain_patches.at(sorted(q.vertices));
  const Patches_3 patches = patches_with_straight_corners(quadrangles, positions);
  return patches.empty() ? domain : with_enclosed_patches(domain, patches, quadrangles);
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_LAYERS_LAYERS_AT_INTERFACES_H
