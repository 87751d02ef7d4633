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

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_parameterizer_base_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/map_to_sphere_3.h>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationBoundary

maps the boundary of a complex that is a topological sphere onto the unit sphere around the origin.

The image is a polyhedron inscribed in the sphere. Its central projection covers the sphere once: the origin
sees each triangle from inside, which is checked with exact predicates on the coordinates written.

In the method of Praun and Hoppe \cgalCite{cgal:ph-spr-03}, edge collapses coarsen the surface to a tetrahedron. Then
the vertices come back one by one. The map from the boundary, scaled to the area of the sphere, has a low
distortion. The distortion is the symmetric Dirichlet energy, which compares lengths and areas.

Unless landmarks are given, the sphere is turned arbitrarily.

`parameterize()` writes points of the unit sphere, up to rounding, and returns `OK`. Otherwise, it writes nothing and returns one
of these codes: `ERROR_EMPTY_COMPLEX`, `ERROR_NON_FINITE_COORDINATE`, `ERROR_NON_MANIFOLD_BOUNDARY`,
`ERROR_SEVERAL_BOUNDARY_COMPONENTS`, `ERROR_BOUNDARY_NOT_OF_GENUS_ZERO`, `ERROR_INTERRUPTED`, or
`ERROR_BOUNDARY_MAP_NOT_BIJECTIVE` if rounding makes the map invalid. The running time is in \f$ O(n \log n) \f$ for \f$ n \f$
boundary vertices, if their degrees are bounded.

\cgalModels{BoundaryParameterizer_3}

\sa `Cube_boundary_parameterizer_3`
*/
class Ball_boundary_parameterizer_3 : public internal::Boundary_parameterizer_base_3<Ball_boundary_parameterizer_3>
{
  friend internal::Boundary_parameterizer_base_3<Ball_boundary_parameterizer_3>;

public:
  using internal::Boundary_parameterizer_base_3<Ball_boundary_parameterizer_3>::parameterize;

  /// writes the image of each vertex of the boundary of the complex, turned about the origin. The turn brings the landmarks as
  /// close to given points as possible, in the sense of least squares.
  ///
  /// \param c3t3 the complex
  /// \param landmarks vertices of the boundary, each with the point of the unit sphere that it should be near to
  /// \param target receives the images
  /// \param np optional \ref bgl_namedparameters "Named Parameters": `maximum_running_time` and `visitor`, as described in
  ///        `BoundaryParameterizer_3`
  ///
  /// \return the same as without landmarks, or `ERROR_INVALID_LANDMARK` if one is not a vertex of the boundary or its
  ///         point is not finite
  template <typename C3t3, typename VertexPointMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const C3t3& c3t3,
                          const std::vector<std::pair<typename C3t3::Vertex_handle,
                                                      typename C3t3::Triangulation::Geom_traits::Point_3> >& landmarks,
                          VertexPointMap target, const CGAL_NP_CLASS& np = parameters::default_values()) const
  {
    const internal::Body_of_complex_3<C3t3> body(c3t3);
    internal::Landmarks_3 of_body;
    for(const auto& [v, point] : landmarks)
      of_body.emplace_back(std::find(body.vertices.begin(), body.vertices.end(), v) - body.vertices.begin(),
                           internal::to_vector(point));
    return this->parameterize_complex(body, target, np, of_body);
  }

  /// writes the image of each point on the boundary of a mesh that is given by arrays, turned to landmarks as for a complex.
  template <typename PointRange, typename CellRange, typename TargetRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
            typename = internal::If_range<PointRange> >
  Error_code parameterize(const PointRange& points, const CellRange& cells,
                          const std::vector<std::pair<std::size_t, std::array<double, 3> > >& landmarks,
                          TargetRange& targets, const CGAL_NP_CLASS& np = parameters::default_values()) const
  {
    internal::Landmarks_3 of_body;
    for(const auto& [v, point] : landmarks)
      of_body.emplace_back(v, internal::to_vector(point));
    return this->parameterize_arrays(internal::body_of(points, cells), targets, np, of_body);
  }

private:
  using Given = internal::Landmarks_3;

  template <typename Surface> // a template, as `map_to_sphere_3()`
  Error_code map(const Surface& surface, const internal::Landmarks_3& landmarks, std::vector<internal::Vector_3>& images,
                 const internal::Budget& budget) const
  { return internal::map_to_sphere_3(surface, landmarks, images, budget); }
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BALL_BOUNDARY_PARAMETERIZER_3_H
