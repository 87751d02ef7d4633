// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_MAP_TO_BOX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_MAP_TO_BOX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#include <optional>

namespace CGAL::Volume_mesh_parameterization::internal {

// Maps a topological sphere onto the boundary of a box around the origin. Without corners, eight vertices are chosen. With a range
// for splits, edges are split if the surface is too coarse; new vertices come behind all others.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Error_code map_to_box_3(const Numbered_surface_3& surface, const Vector_3& half_lengths,
                        const std::optional<std::array<int, 8> >& corners, std::vector<Vector_3>& images,
                        const Budget& budget, std::vector<std::array<std::size_t, 2> >* splits = nullptr);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/Box/map_to_box_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_MAP_TO_BOX_3_H
