// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SPHERE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SPHERE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Maps a topological sphere onto the unit sphere. It is a template, of `Numbered_surface_3`, for the sake of those who
// include the default boundary but call another one.
template <typename Surface>
Error_code map_to_sphere_3(const Surface& surface, std::vector<Eigen::Vector3d>& images, const Budget& budget);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/map_to_sphere_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SPHERE_3_H
