// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_POLYCUBE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_POLYCUBE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/compiled_engine.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Map of a surface whose edges are split for it, one after the other: each gets a new point at its midpoint, which comes behind
// all others.
struct Map_of_split_surface_3
{
  std::vector<std::array<std::size_t, 2> > splits;
  std::vector<Eigen::Vector3d> images; // also of the new points; none if there is no map
};

// Maps a surface onto a polycube. Labels are the axis directions that the images of facets are normal to; without labels,
// those that keep as many details as possible are proposed. The coordinates of the faces are multiples of the spacing, or
// any if the spacing is 0. If axes are to be found, a surface without labels is turned about the center of its bounding box
// by the rotation, and its images are those of the turned one; with a spacing, they are moved to be close to it.
//
// If the surface may be split, another map may be found, which is the better one; there may be no other then, and no images.
CGAL_POLYCUBE_MESHING_3_INLINE
Error_code map_to_polycube_3(const Numbered_surface_3& surface, const std::vector<std::size_t>& labels, double spacing,
                             bool do_find_axes, std::vector<Eigen::Vector3d>& images, Eigen::Matrix3d& rotation,
                             const Budget& budget, Map_of_split_surface_3* of_split_surface = nullptr);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_POLYCUBE_MESHING_3_COMPILED_ENGINE
#  include <CGAL/Polycube_meshing_3/internal/Polycube/map_to_polycube_3_impl.h>
#endif

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_POLYCUBE_3_H
