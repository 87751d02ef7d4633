// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PARAMETERIZE_BOUNDARY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PARAMETERIZE_BOUNDARY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>

namespace CGAL::Volume_mesh_parameterization::internal {

template <typename C3t3>
Numbered_surface_3 numbered_surface_3(const C3t3& c3t3, const Boundary_facets<C3t3>& boundary)
{
  Numbered_surface_3 surface;
  surface.facets = boundary.facets;
  for(const auto v : boundary.vertices)
    surface.points.push_back(to_vector(point_of_vertex(c3t3.triangulation(), v)));
  return surface;
}

// From a complex to the images of its boundary vertices, which `map(boundary, surface, images, budget)` finds. What that
// returns does not matter once the budget is exhausted. Writes nothing unless this succeeds.
template <typename C3t3, typename VertexPointMap, typename NamedParameters, typename Map>
Error_code parameterize_boundary_3(const C3t3& c3t3, VertexPointMap target, const NamedParameters& np, const Map& map)
{
  using Point_3 = typename C3t3::Triangulation::Geom_traits::Point_3;

  check_named_parameters(np);
  Limits<NamedParameters> limits(np);
  const Budget budget = limits.budget();
  const Boundary_facets<C3t3> boundary(c3t3);
  std::vector<Eigen::Vector3d> images;
  const Error_code status = map(boundary, numbered_surface_3(c3t3, boundary), images, budget);
  if(budget.is_exhausted())
    return ERROR_INTERRUPTED;
  if(status == OK)
    for(std::size_t v = 0; v < images.size(); ++v)
      put(target, boundary.vertices[v], Point_3(images[v][0], images[v][1], images[v][2]));
  return status;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PARAMETERIZE_BOUNDARY_3_H
