// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_MOVE_TO_CORNERS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_MOVE_TO_CORNERS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_with_domain_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/Interface_positions_3.h>

namespace CGAL::Polycube_meshing_3::internal {

// Moves to each marked corner of the boundary the vertex with the nearest image: along its line to a corner on a line, else on the
// surface. A corner without one up to the spacing, as where corners are closer to each other, is given up. Vertices on
// interfaces have positions of their own.
inline void move_to_corners_3(const Body_with_domain_3& body, const double spacing, const Interface_positions_3& positions,
                              Hexahedra_3& mesh)
{
  const Body_surface_3& surface = body.surface;
  const std::vector<Freedom_3> freedom = freedoms_3(mesh, surface);
  std::vector<std::tuple<double, std::size_t, std::size_t> > ways; // distance, vertex, corner
  for(const std::size_t corner : surface.corners())
  {
    const Eigen::Vector3d& p = body.points[corner];
    const bool is_on_line = surface.is_on_line(p);
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      const Eigen::Vector3d way = mesh.images[v] - body.images[corner];
      const bool is_in_same_planes = (way.array() == 0).count() >= (is_on_line ? 2 : 1); // the other side of a thin body is not
      const bool is_on_interface = v < positions.of_vertices.size() && positions.of_vertices[v].surface != nullptr;
      if(freedom[v] == Freedom_3::NONE && surface.are_equal(mesh.points[v], p))
        ways.emplace_back(0, v, corner);
      else if(freedom[v] == (is_on_line ? Freedom_3::LINE : Freedom_3::SURFACE) && is_in_same_planes && !is_on_interface
              && way.norm() <= spacing)
        ways.emplace_back(way.norm(), v, corner);
    }
  }
  for(const auto& [v, corner] : nearest_pairs(std::move(ways)))
    mesh.points[v] = body.points[corner];
}

// Returns the marked corners of the boundary that are not vertices of the hexahedra.
inline std::vector<std::array<double, 3> > corners_given_up_3(const Body_with_domain_3& body, const Hexahedra_3& mesh)
{
  std::vector<std::array<double, 3> > result;
  for(const std::size_t corner : body.surface.corners())
    if(std::none_of(mesh.points.begin(), mesh.points.end(), [&](const Eigen::Vector3d& p)
                    { return body.surface.are_equal(p, body.points[corner]); }))
      result.push_back(body.soup.points[corner]);
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_INTERFACES_MOVE_TO_CORNERS_3_H
