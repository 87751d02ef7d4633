// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_SURFACE_FIT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_SURFACE_FIT_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/turned_facets_3.h>

#include <CGAL/Polygon_mesh_processing/distance.h>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

How close the boundary of a mesh is to a surface with other triangles.
*/
struct Surface_fit_3
{
  /// the largest distance of a vertex of the boundary to the surface
  double largest_distance_to_surface = 0;

  /// the largest distance of a point of the surface to the boundary, up to a tenth of it, or a thousandth of the diagonal of
  /// the surface if it is less
  double largest_distance_from_surface = 0;

  /// the largest distance of the image of a landmark to its point; 0 without landmarks
  double largest_distance_of_landmarks = 0;

  /// the number of facets whose normals are opposite to those of the surface at the nearest points of their vertices and center
  std::size_t number_of_turned_facets = 0;

  /// the number of pairs of facets that intersect each other
  std::size_t number_of_intersections = 0;
};

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

measures how close the boundary of a mesh is to a surface, for instance after a fit by `Surface_fit_boundary_parameterizer_3`.

\param points the points of the mesh: the images, a range as `CGAL::stretch_minimizing_volume_parameterization()` takes it
\param cells four indices of points each
\param points_of_surface the points of the surface
\param triangles the triangles of the surface, by the indices of their points
\param landmarks points of the mesh, by their indices, each with the point to which it should come

\exception Input_error names a wrong index or a coordinate that is not finite.

\pre Both surfaces are closed manifolds; otherwise `CGAL::Precondition_exception` is thrown, in every build.

\sa `Surface_fit_boundary_parameterizer_3`
*/
template <typename PointRange, typename CellRange>
Surface_fit_3 measure_surface_fit(const PointRange& points, const CellRange& cells,
                                  const std::vector<std::array<double, 3> >& points_of_surface,
                                  const std::vector<std::array<std::size_t, 3> >& triangles,
                                  const std::vector<std::pair<std::size_t, std::array<double, 3> > >& landmarks = {})
{
  const Triangulated_surface_3 surface(points_of_surface, triangles); // with the checks
  const auto mesh_of = [](const internal::Numbered_surface_3& numbered)
  {
    internal::Boundary_mesh_3 mesh;
    internal::require(internal::build_boundary_mesh_3(numbered, mesh) == OK, "The surfaces must be closed manifolds.");
    return mesh;
  };
  internal::Numbered_surface_3 target;
  target.points = internal::vectors_of(points_of_surface);
  target.facets = triangles;
  const internal::Boundary_mesh_3 image = mesh_of(internal::surface_of(internal::body_of(points, cells)));
  const internal::Boundary_mesh_3 mesh_of_target = mesh_of(target);

  Surface_fit_3 result;
  for(const internal::Vector_3& p : internal::points_of(image))
  {
    const internal::Vector_3 q = internal::to_vector(surface.nearest_point(internal::coordinates(p)).point);
    result.largest_distance_to_surface = (std::max)(result.largest_distance_to_surface, (p - q).norm());
  }
  const auto images = internal::vectors_of(internal::coordinates_of(points));
  for(const auto& [v, goal] : landmarks)
    result.largest_distance_of_landmarks
      = (std::max)(result.largest_distance_of_landmarks, (images.at(v) - internal::to_vector(goal)).norm());
  result.number_of_turned_facets = internal::turned_facets(image, surface).size();
  // The distance may be too large by its error. A smaller error takes longer, without end where the surfaces are the same.
  const double diagonal = internal::bounding_box(target.points).diagonal().norm();
  double error = 1e-3 * diagonal;
  const auto measure = [&]
  { return Polygon_mesh_processing::bounded_error_Hausdorff_distance<Sequential_tag>(mesh_of_target, image, error); };
  result.largest_distance_from_surface = measure();
  while(result.largest_distance_from_surface > error && error > 0.1 * result.largest_distance_from_surface)
  {
    error /= 10;
    result.largest_distance_from_surface = measure();
  }
  result.number_of_intersections = internal::intersecting_facets(image).size();
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_SURFACE_FIT_H
