// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PLACE_OF_BOUNDARY_ERROR_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PLACE_OF_BOUNDARY_ERROR_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/to_vector.h>
#include <CGAL/Volume_mesh_parameterization/internal/sentence.h>

#include <iterator>
#include <string>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Where the boundary of a complex is not a manifold, as a sentence; empty for other errors.
template <typename C3t3>
std::string place_of_boundary_error(const C3t3& c3t3, const Error_code status)
{
  if(status != ERROR_NON_MANIFOLD_BOUNDARY)
    return "";
  std::vector<typename C3t3::Vertex_handle> vertices;
  non_manifold_boundary_vertices(c3t3, std::back_inserter(vertices));
  const auto& tr = c3t3.triangulation();
  const auto p = tr.geom_traits().construct_point_3_object()(tr.point(vertices.front()));
  return sentence(" It is none at ", vertices.size(), " vertices, among them the one at ", describe(to_vector(p)), ".");
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_PLACE_OF_BOUNDARY_ERROR_H
