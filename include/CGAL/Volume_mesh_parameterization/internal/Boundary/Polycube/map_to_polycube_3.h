// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_MAP_TO_POLYCUBE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_MAP_TO_POLYCUBE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/inline.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Maps a surface onto a polycube. Without labels of the facets, which are the axes that their images are normal to, some
// are proposed such that there are as many details as possible. The coordinates of the faces are multiples of the
// spacing, or any if that is 0.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Error_code map_to_polycube_3(const Numbered_surface_3& surface, const std::vector<std::size_t>& labels, double spacing,
                             std::vector<Eigen::Vector3d>& images, const Budget& budget);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/map_to_polycube_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_MAP_TO_POLYCUBE_3_H
