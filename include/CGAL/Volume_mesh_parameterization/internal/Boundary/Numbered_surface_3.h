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

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Boundary of a body as plain arrays: the seam between complexes of any type and maps of their boundaries, which are
// compiled once.
struct Numbered_surface_3
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::size_t, 3> > facets; // counterclockwise as seen from outside
  std::vector<std::array<std::size_t, 2> > sharp_edges;
  std::vector<std::size_t> vertices;               // points of the body, each once, in the order of the facets
  const std::vector<std::array<std::size_t, 4> >* cells = nullptr; // cells of the body, by its points
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_NUMBERED_SURFACE_3_H
