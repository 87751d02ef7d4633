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

#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

namespace CGAL::Polycube_meshing_3::internal {

// Surface that is to be mapped to a polycube, and how.
struct Polycube_problem_3
{
  Numbered_surface_3 surface;
  std::vector<std::size_t> labels = {}; // axis directions that images of facets are normal to; none if they are to be proposed
  double spacing = 0;                   // that coordinates of faces are multiples of, or 0 for any coordinates
  bool do_find_axes = false; // may the surface be turned, if it has no labels, and the polycube be moved to be close to it?
  bool may_split = false;    // may edges of the surface be split for a better map?
};

// Map of a surface to a polycube, and perhaps a better one of the surface with split edges; then there may be no other. The
// surface is turned about the center of its bounding box. Edges are split one after the other: each gets a new point at its
// midpoint, which comes behind all others.
struct Found_polycube_3
{
  Error_code status = ERROR_NO_POLYCUBE;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  std::vector<Eigen::Vector3d> images = {};
  std::vector<std::array<std::size_t, 2> > splits = {};
  std::vector<Eigen::Vector3d> images_with_splits = {}; // also of the new points
};

// Maps a surface onto a polycube. Without labels, those that keep as many details as possible are proposed.
CGAL_POLYCUBE_MESHING_3_INLINE
Found_polycube_3 map_to_polycube_3(const Polycube_problem_3& problem, const Budget& budget);

} // namespace CGAL::Polycube_meshing_3::internal

#ifndef CGAL_POLYCUBE_MESHING_3_COMPILED_ENGINE
#  include <CGAL/Polycube_meshing_3/internal/Polycube/map_to_polycube_3_impl.h>
#endif

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_POLYCUBE_3_H
