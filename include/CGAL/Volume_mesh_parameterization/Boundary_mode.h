// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_MODE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_MODE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

The ways in which a map meets its boundary: see the named parameter `boundary_mode` of
`CGAL::stretch_minimizing_volume_parameterization()`.
*/
enum class Boundary_mode
{
  AUTO,  ///< first `FIXED`; if no valid map is found, `SOFT`
  FIXED, ///< prescribed vertices are at their targets from the beginning, and cells are untangled
  SOFT   ///< no cell is ever inverted, and a penalty pulls the prescribed vertices to their targets
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_MODE_H
