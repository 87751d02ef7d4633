// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BALL_BOUNDARY_PARAMETERIZER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BALL_BOUNDARY_PARAMETERIZER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/map_to_sphere_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/parameterize_boundary_3.h>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationBoundary

maps the boundary of a complex that is a topological sphere onto the unit sphere around the origin.

The image is a polyhedron inscribed in the sphere. Its central projection covers the sphere once: the origin
sees each triangle from inside, which is checked with exact predicates on the coordinates written.

With the method of Praun and Hoppe \cgalCite{cgal:ph-spr-03} the surface is coarsened to a tetrahedron by edge
collapses, and the vertices come back one by one. The distortion that is kept low is the symmetric Dirichlet
energy, which compares lengths and areas, of the map from the boundary, scaled to the area of the sphere.

`parameterize()` writes points of the unit sphere, up to rounding, and returns `OK`; or, with nothing written,
`ERROR_EMPTY_COMPLEX`, `ERROR_NON_FINITE_COORDINATE`, `ERROR_NON_MANIFOLD_BOUNDARY`, `ERROR_SEVERAL_BOUNDARY_COMPONENTS`,
`ERROR_BOUNDARY_NOT_OF_GENUS_ZERO`, `ERROR_BOUNDARY_MAP_NOT_BIJECTIVE` if rounding spoilt the map, or `ERROR_INTERRUPTED`.
The running time is in \f$ O(n \log n) \f$ for \f$ n \f$ boundary vertices, if their degrees are bounded.

\cgalModels{BoundaryParameterizer_3}

\sa `Cube_boundary_parameterizer_3`
*/
class Ball_boundary_parameterizer_3 : public internal::Boundary_parameterizer_base_3<Ball_boundary_parameterizer_3>
{
  friend internal::Boundary_parameterizer_base_3<Ball_boundary_parameterizer_3>;

  // a template, like what it calls
  template <typename Surface>
  Error_code map(const Surface& surface, std::vector<Eigen::Vector3d>& images, const internal::Budget& budget) const
  { return internal::map_to_sphere_3(surface, images, budget); }
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BALL_BOUNDARY_PARAMETERIZER_3_H
