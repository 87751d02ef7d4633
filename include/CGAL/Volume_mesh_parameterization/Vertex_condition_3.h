// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_VERTEX_CONDITION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_VERTEX_CONDITION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Any_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <array>
#include <cmath>
#include <optional>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

The condition of the image of a vertex. The image is at its target, free, or in a plane or on a line through the target with a
given direction, or it slides on a surface, on a curve, or in the boundary. The value type of the named parameter
`vertex_condition_map`.

A vertex at its target has its coordinates to the bit. A plane orthogonal to an axis and a line along an axis prescribe
coordinates to the bit, too. Other planes and lines, and surfaces and curves, are met within rounding.

A vertex that slides first is at its target, which is put on the surface or the curve. It slides after a map is found.
*/
class Vertex_condition_3
{
public:
  /// The kinds of conditions.
  enum Kind
  {
    FREE,       ///< the image may be anywhere
    IN_PLANE,   ///< the image is in a plane through the target
    ON_LINE,    ///< the image is on a line through the target
    AT_TARGET,  ///< the image is the target
    ON_SURFACE, ///< the image is on a surface
    ON_CURVE,   ///< the image is on a curve
    IN_BOUNDARY ///< the image is in the patches of the boundary that have the target
  };

  /// constructs the condition of a free vertex, which needs no target.
  Vertex_condition_3() = default;

  /// returns the condition of a free vertex.
  static Vertex_condition_3 free() { return Vertex_condition_3(); }

  /// returns the condition of a vertex whose image is its target.
  static Vertex_condition_3 at_target() { return { AT_TARGET, {} }; }

  /// returns the condition of a vertex in the plane through its target with the normal (x, y, z).
  /// \pre The coordinates are finite, and not all of them are 0.
  static Vertex_condition_3 in_plane(const double x, const double y, const double z) { return { IN_PLANE, { x, y, z } }; }

  /// returns the condition of a vertex on the line through its target with the direction (x, y, z).
  /// \pre The coordinates are finite, and not all of them are 0.
  static Vertex_condition_3 on_line(const double x, const double y, const double z) { return { ON_LINE, { x, y, z } }; }

  /// returns the condition of a vertex that slides on a surface. It starts at the nearest point of its target.
  static Vertex_condition_3 on_surface(const Any_surface_3& surface) { return { ON_SURFACE, surface }; }

  /// returns the condition of a vertex that slides on a curve, likewise.
  static Vertex_condition_3 on_curve(const Any_surface_3& curve) { return { ON_CURVE, curve }; }

  /// returns the condition of a vertex of the boundary that slides in patches of the target, and along the edges between them
  /// (\ref VMPBoundarySlide). If its target is not a number, it slides in the boundary of the source, from the start. With
  /// `do_slide_boundary(true)`, all vertices of the boundary that are not constrained do so.
  /// A vertex inside, or of a facet with a vertex that is not at its target first, stays at its target.
  static Vertex_condition_3 in_boundary() { return { IN_BOUNDARY, {} }; }

  /// returns the kind.
  Kind kind() const { return m_kind; }

  /// returns the number of directions in which the image may move: 3 if it is free, 2 in a plane, on a surface or in the boundary,
  /// 1 on a line or a curve, and 0 at its target.
  int dimension() const
  {
    constexpr int of_kinds[] = { 3, 2, 1, 0, 2, 1, 2 };
    return of_kinds[m_kind];
  }

  /// returns the normal of the plane or the direction of the line, and otherwise zeros. Its length has no meaning.
  const std::array<double, 3>& direction() const { return m_direction; }

  /// returns whether the image slides on a surface or a curve.
  bool is_sliding() const { return m_surface.has_value(); }

  /// returns the surface or the curve.
  /// \pre `is_sliding()`
  const Any_surface_3& surface() const { return *m_surface; }

private:
  Vertex_condition_3(const Kind kind, const std::array<double, 3>& direction) : m_kind(kind), m_direction(direction)
  {
    const bool is_finite = std::isfinite(direction[0]) && std::isfinite(direction[1]) && std::isfinite(direction[2]);
    const bool is_zero = direction == std::array<double, 3>{};
    internal::require(kind == AT_TARGET || kind == IN_BOUNDARY || (is_finite && !is_zero),
                      "The direction of a condition must be finite and not zero.");
  }

  Vertex_condition_3(const Kind kind, const Any_surface_3& surface) : m_kind(kind), m_surface(surface) {}

  Kind m_kind = FREE;
  std::array<double, 3> m_direction = {};
  std::optional<Any_surface_3> m_surface;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_VERTEX_CONDITION_3_H
