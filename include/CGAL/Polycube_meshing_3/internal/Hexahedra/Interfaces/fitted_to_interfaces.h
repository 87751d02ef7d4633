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

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/pulled_back.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Layers/Interface_layers_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Moves the vertices on interfaces, in the domain, to the images of their positions, but not out of planes of the boundary.
inline void move_to_images_of_positions(const Volume_map_3& map, const Interface_positions_3& positions, Hexahedron_soup_3& domain)
{
  std::vector<std::array<bool, 3> > is_held(domain.points.size());
  for(const std::array<std::size_t, 4>& facet : domain.facets)
    for(const std::size_t v : facet)
      is_held[v][axis_of_facet(domain.points, facet)] = true;
  for(std::size_t v = 0; v < domain.points.size(); ++v)
    if(const Interface_positions_3::Position& position = positions.of_vertices[v]; position.surface != nullptr)
      if(const auto image = map.nearest_image(Volume_map_3::Point_3(position.point[0], position.point[1], position.point[2])))
        for(std::size_t axis = 0; axis < 3; ++axis)
          if(!is_held[v][axis])
            domain.points[v][axis] = image->point[static_cast<int>(axis)];
}

// Returns the hexahedra of a domain, pulled back to the body, with the layers that interfaces need, and with the vertices on
// interfaces at their positions; none once the budget is exhausted.
inline Hexahedron_soup_3 fitted_to_interfaces(const Volume_map_3& map, Hexahedron_soup_3 domain, const Body_surface_3& surface,
                                              Body_interfaces_3& interfaces, const bool is_parallel, const Budget& budget,
                                              Interface_positions_3& positions)
{
  Hexahedron_soup_3 body = pulled_back(map, domain, is_parallel, budget);
  if(body.cells.empty())
    return body;
  std::vector<Interface_quadrangle_3> quadrangles = interface_quadrangles_3(body);
  set_patches(body, interfaces, quadrangles);
  positions = interface_positions_3(body, quadrangles, freedoms_3(body, surface), interfaces);
  move_to_images_of_positions(map, positions, domain);
  domain = Padding_3(domain, sides_with_layer_3(domain, quadrangles), domain.cell_references).result();
  std::vector<Interface_quadrangle_3> padded_quadrangles = interface_quadrangles_3(domain); // in the order of those before
  for(std::size_t i = 0; i < quadrangles.size(); ++i)
    padded_quadrangles[i].patch = quadrangles[i].patch;
  if(const Patches_3 patches = patches_with_straight_corners(padded_quadrangles, positions); !patches.empty())
  {
    domain = with_enclosed_patches(domain, patches, padded_quadrangles);
    body = pulled_back(map, domain, is_parallel, budget);
    if(!body.cells.empty())
      positions = interface_positions_3(body, padded_quadrangles, freedoms_3(body, surface), interfaces);
  }
  else
    body = pulled_back(map, domain, is_parallel, budget);
  for(std::size_t v = 0; v < positions.of_vertices.size() && !body.cells.empty(); ++v)
    if(positions.of_vertices[v].surface != nullptr)
      body.points[v] = coordinates(positions.of_vertices[v].point);
  return body;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_FITTED_TO_INTERFACES_H
