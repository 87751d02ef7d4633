// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_TURNED_FACETS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_TURNED_FACETS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Counts the facets whose normals are opposite to those of a surface at the nearest points of their vertices and center.
inline std::size_t number_of_turned_facets(const Boundary_mesh_3& mesh, const Triangulated_surface_3& surface)
{
  const auto is_turned = [&](const Boundary_mesh_3::Face_index f)
  {
    const auto [a, b, c] = vertices_of_face(mesh, f);
    const Vector_3 p = to_vector(mesh.point(a)), q = to_vector(mesh.point(b)), r = to_vector(mesh.point(c)),
                   center = (p + q + r) / 3, normal = (q - p).cross(r - p);
    const auto points = { p, q, r, center };
    return std::all_of(points.begin(), points.end(), [&](const Vector_3& x)
    { return normal.dot(to_vector(surface.nearest_point(coordinates(x)).direction)) <= 0; });
  };
  return static_cast<std::size_t>(std::count_if(mesh.faces().begin(), mesh.faces().end(), is_turned));
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_TURNED_FACETS_3_H
