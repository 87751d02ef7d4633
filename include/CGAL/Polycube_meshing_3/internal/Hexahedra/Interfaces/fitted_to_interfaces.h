// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_FITTED_TO_INTERFACES_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_FITTED_TO_INTERFACES_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_with_domain_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Layers/sides_with_layer_3.h>

namespace CGAL::Polycube_meshing_3::internal {

// Moves the vertices on interfaces, in the domain, to the images of their positions, but not out of planes of the boundary.
inline void move_to_images_of_positions(const Body_with_domain_3& body, const Interface_positions_3& positions,
                                        Hexahedra_3& domain)
{
  std::vector<std::array<bool, 3> > is_held(domain.points.size());
  for(const std::array<std::size_t, 4>& facet : domain.facets)
    for(const std::size_t v : facet)
      is_held[v][axis_of_facet(domain.points, facet)] = true;
  for(std::size_t v = 0; v < domain.points.size(); ++v)
    if(const Interface_positions_3::Position& position = positions.of_vertices[v]; position.surface != nullptr)
      if(const auto image = body.map.nearest_image(exact_point(position.point)))
        for(int axis = 0; axis < 3; ++axis)
          if(!is_held[v][axis])
            domain.points[v][axis] = image->point[axis];
}

// Hexahedra of the body, and the positions of their vertices on interfaces.
struct Fitted_hexahedra_3
{
  Hexahedra_3 mesh;
  Interface_positions_3 positions;
};

// Returns the hexahedra of a domain, pulled back to the body, with the layers that interfaces need, and with the vertices on
// interfaces at their positions; none once the budget is exhausted.
inline Fitted_hexahedra_3 fitted_to_interfaces(const Body_with_domain_3& body, Hexahedra_3 domain, Body_interfaces_3& interfaces,
                                               const Budget& budget)
{
  Fitted_hexahedra_3 result = { pulled_back(body, domain, budget), {} };
  if(result.mesh.cells.empty())
    return result;
  const auto find_positions = [&](const std::vector<Interface_quadrangle_3>& quadrangles)
  {
    return interface_positions_3(result.mesh, quadrangles, freedoms_3(result.mesh, body.surface), interfaces);
  };
  std::vector<Interface_quadrangle_3> quadrangles = interface_quadrangles_3(result.mesh);
  set_patches(result.mesh, interfaces, quadrangles);
  result.positions = find_positions(quadrangles);
  move_to_images_of_positions(body, result.positions, domain);
  domain = Padding_3(domain, sides_with_layer_3(domain, quadrangles), domain.cell_references).result();
  std::vector<Interface_quadrangle_3> padded_quadrangles = interface_quadrangles_3(domain); // in the order of those before
  for(std::size_t i = 0; i < quadrangles.size(); ++i)
    padded_quadrangles[i].patch = quadrangles[i].patch;
  const Patches_3 patches = patches_with_straight_corners(padded_quadrangles, result.positions);
  if(!patches.empty())
    domain = with_enclosed_patches(domain, patches, padded_quadrangles);
  result.mesh = pulled_back(body, domain, budget);
  if(result.mesh.cells.empty())
    return result;
  if(!patches.empty())
    result.positions = find_positions(padded_quadrangles);
  for(std::size_t v = 0; v < result.positions.of_vertices.size(); ++v)
    if(result.positions.of_vertices[v].surface != nullptr)
      result.mesh.points[v] = result.positions.of_vertices[v].point;
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_FITTED_TO_INTERFACES_H
