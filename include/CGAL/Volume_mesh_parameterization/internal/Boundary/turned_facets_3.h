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

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <iterator>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the facets whose normals are opposite to those of a surface at the nearest points of their vertices and center.
inline std::vector<Boundary_mesh_3::Face_index> turned_facets(const Boundary_mesh_3& mesh, const Triangulated_surface_3& surface)
{
  const auto normal = [&](const Vector_3& p) { return to_vector(surface.nearest_point(coordinates(p)).direction); };
  std::vector<Vector_3> normals(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for(const Boundary_mesh_3::Vertex_index v : mesh.vertices())
    normals[v] = normal(to_vector(mesh.point(v)));
  const auto is_turned = [&](const Boundary_mesh_3::Face_index f)
  {
    const auto [a, b, c] = vertices_of_face(mesh, f);
    const Vector_3 p = to_vector(mesh.point(a)), q = to_vector(mesh.point(b)), r = to_vector(mesh.point(c));
    return is_turned_3({ p, q, r }, { normals[a], normals[b], normals[c] }, [&](const Vector_3& center)
    {
      const Vector_3 n = normal(center);
      return Matrix_3(n, n, n);
    });
  };
  std::vector<Boundary_mesh_3::Face_index> result;
  std::copy_if(mesh.faces().begin(), mesh.faces().end(), std::back_inserter(result), is_turned);
  return result;
}

// Returns the pairs of facets that intersect each other.
inline std::vector<std::pair<Boundary_mesh_3::Face_index, Boundary_mesh_3::Face_index> >
intersecting_facets(const Boundary_mesh_3& mesh)
{
  std::vector<std::pair<Boundary_mesh_3::Face_index, Boundary_mesh_3::Face_index> > result;
  Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(result));
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_TURNED_FACETS_3_H
