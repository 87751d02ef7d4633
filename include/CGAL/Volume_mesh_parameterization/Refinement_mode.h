// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_REFINEMENT_MODE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_REFINEMENT_MODE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

Which vertices refinement may add: see the named parameter `refinement_mode` of
`CGAL::stretch_minimizing_volume_parameterization()`, and Section \ref VMPRefinement.

A new vertex on the boundary is the midpoint of an edge of the boundary, with coordinates rounded to their number type. Therefore,
it lies on the edge up to rounding, and in exact arithmetic it may be off the edge.
*/
enum class Refinement_mode
{
  NEEDED, ///< only those without which the boundary is not reached
  HELPFUL, ///< also those in bridges, simplices inside whose vertices are all prescribed, that make the map slow or distorted
  BOUNDARY ///< also those on the boundary, at edges that `boundary_parameterizer` splits; only that for polycubes does so
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_REFINEMENT_MODE_H
