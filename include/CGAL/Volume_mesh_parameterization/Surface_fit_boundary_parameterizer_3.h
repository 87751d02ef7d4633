// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_SURFACE_FIT_BOUNDARY_PARAMETERIZER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_SURFACE_FIT_BOUNDARY_PARAMETERIZER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_parameterizer_base_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/map_to_surface_3.h>

#include <limits>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationBoundary

maps the boundary of a complex onto a surface with other triangles, for instance a scan. Both are topological spheres.

Both surfaces are mapped to the unit sphere, as by `Ball_boundary_parameterizer_3`. There, the boundary is turned. With landmarks,
the turn brings them as close to their points as possible, in the sense of least squares, and then their vertices are pulled to
the points. `measure_surface_fit()` measures how far they are in the end. Otherwise, it puts the principal axes of
the boundary on those of the target, with the signs that have the lowest distortion. Then each vertex has a place in a triangle of
the target. Vertices move on the target to lower the distortion of the boundary. As long as facets are turned over or intersect
each other, vertices of both surfaces move in turn, each on the other surface: where few facets of the boundary cover a limb of the
target, the vertices of the limb spread out, and more vertices of the boundary reach it.

All vertices are on the target. Edges of the image are chords, and leave the target where it bends. `measure_surface_fit()`
measures both distances. With a tolerance and `Refinement_mode::BOUNDARY`,
`CGAL::stretch_minimizing_volume_parameterization()` splits edges of the boundary. It ends when midpoints of edges are at most this
far from the target, and points on edges of the target, examined at this distance from each other, at most this far from the image.
No new vertex turns a facet over or makes facets intersect each other.

The images of the boundary are starting points: vertices slide on the target if the call for a map is repeated with
`Vertex_condition_3::on_surface()` for the boundary. This lowers the energy, but facets may be turned over or intersect each other
then. Call `measure_surface_fit()`, and keep the first map if they are.

`parameterize()` returns `OK` if `measure_surface_fit()` counts no facet that is turned over, and no intersection. Otherwise, it
writes nothing and returns `ERROR_BOUNDARY_NOT_FITTED`, `ERROR_INVALID_LANDMARK` if a landmark is not finite,
`ERROR_TARGET_NOT_A_SPHERE`, or one of the codes of `Ball_boundary_parameterizer_3`. Fits fail where limbs are thin, or far from
those of the body. In the latter case, landmarks help. Bodies with handles are mapped by `Surface_boundary_parameterizer_3` or
`Polycube_boundary_parameterizer_3`. A call for a map returns `ERROR_FIT_TOLERANCE_NOT_REACHED` if the boundary does not become as
close to the target as the tolerance. The function `parameterize()` splits no edges.

The running time is in \f$ O(n \log n) \f$ for \f$ n \f$ vertices of both surfaces.

\cgalModels{BoundaryParameterizer_3}

\sa `Surface_boundary_parameterizer_3`
\sa `Triangulated_surface_3`
*/
class Surface_fit_boundary_parameterizer_3
  : public internal::Boundary_parameterizer_base_3<Surface_fit_boundary_parameterizer_3>
{
  friend internal::Boundary_parameterizer_base_3<Surface_fit_boundary_parameterizer_3>;

public:
  /// The type of a point.
  using Point = std::array<double, 3>;

  /// stores copies of the surface and the landmarks.
  ///
  /// \param points the points of the target
  /// \param triangles its triangles, by the indices of their points, counterclockwise as seen from outside
  /// \param landmarks points of the body, each with the point of the target that it should be near to. The nearest vertex of the
  ///        boundary and the nearest point of the target stand for them
  /// \param tolerance the distance beyond which edges of the boundary are split with `Refinement_mode::BOUNDARY`
  ///
  /// \pre The indices are in range, and the tolerance is positive; otherwise `CGAL::Precondition_exception` is thrown, in every
  /// build.
  Surface_fit_boundary_parameterizer_3(const std::vector<Point>& points,
                                       const std::vector<std::array<std::size_t, 3> >& triangles,
                                       const std::vector<std::pair<Point, Point> >& landmarks = {},
                                       const double tolerance = (std::numeric_limits<double>::infinity)())
    : m_tolerance(tolerance)
  {
    internal::require(tolerance > 0, "The tolerance must be positive.");
    for(const Point& p : points)
      m_target.points.push_back(internal::to_vector(p));
    for(const std::array<std::size_t, 3>& triangle : triangles)
      for(const std::size_t v : triangle)
        internal::require(v < points.size(), "A triangle of the target has a point that does not exist.");
    m_target.facets = triangles;
    for(const auto& [p, q] : landmarks)
      m_landmarks.emplace_back(internal::to_vector(p), internal::to_vector(q));
  }

private:
  struct Given {};

  Error_code find(const internal::Body_3& body, Given, const bool may_refine, const internal::Budget& budget,
                  std::vector<internal::Mapped_boundary_3>& boundaries) const
  {
    const internal::Numbered_surface_3 surface = internal::surface_of(body);
    const double tolerance = may_refine ? m_tolerance : (std::numeric_limits<double>::infinity)();
    internal::Fitted_surface_3 fitted;
    const Error_code status = internal::map_to_surface_3(surface, m_target, m_landmarks, tolerance, fitted, budget);
    if(budget.is_exhausted()) // then the status does not matter
      return ERROR_INTERRUPTED;
    if(status != OK)
      return status;
    boundaries.push_back(this->mapped_boundary(body, surface, fitted.splits, fitted.images));
    boundaries.back().is_complete = fitted.is_complete;
    return OK;
  }

  internal::Numbered_surface_3 m_target;
  internal::Point_pairs_3 m_landmarks;
  double m_tolerance;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_SURFACE_FIT_BOUNDARY_PARAMETERIZER_3_H
