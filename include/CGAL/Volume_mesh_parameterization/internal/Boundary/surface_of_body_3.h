// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SURFACE_OF_BODY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SURFACE_OF_BODY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE Numbered_surface_3 surface_of(const Body_3& body);

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::vector<std::size_t> non_manifold_points(const Body_3& body);

// Returns a sentence with the places at which the boundary of a body is not a manifold; an empty one for other errors.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::string where_boundary_fails(const Body_3& body, Error_code status);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/surface_of_body_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SURFACE_OF_BODY_3_H
