// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_ANY_SURFACE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_ANY_SURFACE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <array>
#include <functional>
#include <memory>
#include <type_traits>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationSurfaces

A point on a surface or on a curve, with the direction that is known there.
*/
struct Surface_point_3
{
  std::array<double, 3> point;     ///< the point
  std::array<double, 3> direction; ///< the normal of the surface, or the tangent of the curve. Its length has no meaning
};

/*!
\ingroup PkgVolumeMeshParameterizationSurfaces

A surface or a curve whose type is chosen when the program runs. It holds a copy of a model of `SlidingSurface_3`. Copies share it.

\cgalModels{SlidingSurface_3}
*/
class Any_surface_3
{
public:
  /// holds a copy of `surface`.
  ///
  /// \tparam Surface a model of `SlidingSurface_3`
  template <typename Surface, typename = std::enable_if_t<!std::is_same_v<Surface, Any_surface_3> > >
  Any_surface_3(const Surface& surface)
    : m_nearest_point(std::make_shared<const Nearest_point>([surface](const std::array<double, 3>& p)
                                                            { return surface.nearest_point(p); }))
  {}

  /// returns the point of the surface to which a point is put back.
  Surface_point_3 nearest_point(const std::array<double, 3>& p) const { return (*m_nearest_point)(p); }

  /// returns whether two objects share a surface.
  friend bool operator==(const Any_surface_3& a, const Any_surface_3& b) { return a.m_nearest_point == b.m_nearest_point; }

private:
  using Nearest_point = std::function<Surface_point_3(const std::array<double, 3>&)>;

  std::shared_ptr<const Nearest_point> m_nearest_point;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_ANY_SURFACE_3_H
