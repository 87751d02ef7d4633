// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_NUMBERED_SURFACE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_NUMBERED_SURFACE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Edges of a surface, the smaller vertex first, in ascending order.
using Sorted_edges = std::vector<std::array<std::size_t, 2> >;

// Boundary of a body, with points of its own.
struct Numbered_surface_3
{
  std::vector<Vector_3> points;
  std::vector<std::array<std::size_t, 3> > facets; // counterclockwise as seen from outside
  Sorted_edges sharp_edges;
  std::vector<std::size_t> vertices;               // points of the body, each once, in the order of the facets
  const std::vector<std::array<std::size_t, 4> >* cells = nullptr; // cells of the body, by its points
};

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE Numbered_surface_3 surface_of(const Body_3& body);

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::vector<std::size_t> non_manifold_points(const Body_3& body);

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::string where_boundary_fails(const Body_3& body, Error_code status);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_NUMBERED_SURFACE_3_H
