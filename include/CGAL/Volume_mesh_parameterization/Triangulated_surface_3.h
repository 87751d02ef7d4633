// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TRIANGULATED_SURFACE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TRIANGULATED_SURFACE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Vertex_condition_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationSurfaces

A triangulated surface on which vertices slide. Its feature edges bound patches, and join to curves. A curve ends at vertices where
it turns by more than 45 degrees, or where several curves meet. These vertices are corners.

Points are put back to the nearest point, which is found by an AABB tree. Copies share the trees.

\cgalModels{SlidingSurface_3}
*/
class Triangulated_surface_3
{
public:
  /// builds the trees of a surface. Triangles without area are left out.
  ///
  /// \param points the points
  /// \param triangles the triangles, by the indices of their points
  /// \param features the feature edges, likewise. If there are none, edges with 60 degrees or more between the normals of their
  ///        triangles are features. Edges with more than two triangles always are
  ///
  /// Throws `Input_error` if an index or a coordinate is wrong, or if no triangle has an area.
  Triangulated_surface_3(const std::vector<std::array<double, 3> >& points,
                         std::vector<std::array<std::size_t, 3> > triangles,
                         const std::vector<std::array<std::size_t, 2> >& features = {});

  /// returns the number of patches.
  std::size_t number_of_patches() const { return m_patches.size(); }

  /// returns the patch with an index.
  const Any_surface_3& patch(const std::size_t i) const { return m_patches[i]; }

  /// returns the number of curves.
  std::size_t number_of_curves() const { return m_curves.size(); }

  /// returns the curve with an index.
  const Any_surface_3& curve(const std::size_t i) const { return m_curves[i]; }

  /// returns what a vertex at a point of the surface, given by its index, may do if it is to keep to its patch or curve.
  const Vertex_condition_3& condition(const std::size_t point) const { return m_conditions[point]; }

  /// returns the nearest point of the surface, with the normal of its triangle, or the sum of the unit normals of all triangles
  /// there. Therefore, the normal depends on the point only.
  Surface_point_3 nearest_point(const std::array<double, 3>& p) const { return m_surface.front().nearest_point(p); }

private:
  std::vector<Any_surface_3> m_surface; // the only element
  std::vector<Any_surface_3> m_patches, m_curves;
  std::vector<Vertex_condition_3> m_conditions; // of each point
};

} // namespace CGAL::Volume_mesh_parameterization

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Triangulated_surface_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TRIANGULATED_SURFACE_3_H
