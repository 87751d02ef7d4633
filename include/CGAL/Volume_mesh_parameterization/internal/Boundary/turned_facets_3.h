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
    std::array<Vector_3, 4> points; // the last one is the center
    for(int i = 0; i < 3; ++i)
      points[i] = to_vector(mesh.point(vertices_of_face(mesh, f)[i]));
    points[3] = (points[0] + points[1] + points[2]) / 3;
    const Vector_3 normal = (points[1] - points[0]).cross(points[2] - points[0]);
    return std::all_of(points.begin(), points.end(), [&](const Vector_3& p)
    { return normal.dot(to_vector(surface.nearest_point(coordinates(p)).direction)) <= 0; });
  };
  return static_cast<std::size_t>(std::count_if(mesh.faces().begin(), mesh.faces().end(), is_turned));
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_TURNED_FACETS_3_H
