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

#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <array>
#include <cmath>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

The condition of the image of a vertex. The image is at its target, free, or in a plane or on a line through the target with a
given direction. The value type of the named parameter `vertex_condition_map`.

A vertex at its target has its coordinates to the bit. A plane orthogonal to an axis and a line along an axis prescribe
coordinates to the bit, too. Other planes and lines are met within rounding.
*/
class Vertex_condition_3
{
public:
  /// The kinds of conditions.
  enum Kind { FREE, IN_PLANE, ON_LINE, AT_TARGET };

  /// constructs the condition of a free vertex, which needs no target.
  Vertex_condition_3() = default;

  /// returns the condition of a vertex whose image is its target.
  static Vertex_condition_3 at_target() { return { AT_TARGET, {} }; }

  /// returns the condition of a vertex in the plane through its target with the normal (x, y, z).
  /// \pre The coordinates are finite, and not all of them are 0.
  static Vertex_condition_3 in_plane(const double x, const double y, const double z) { return { IN_PLANE, { x, y, z } }; }

  /// returns the condition of a vertex on the line through its target with the direction (x, y, z).
  /// \pre The coordinates are finite, and not all of them are 0.
  static Vertex_condition_3 on_line(const double x, const double y, const double z) { return { ON_LINE, { x, y, z } }; }

  /// returns the kind.
  Kind kind() const { return m_kind; }

  /// returns the normal of the plane or the direction of the line, and otherwise zeros. Its length has no meaning.
  const std::array<double, 3>& direction() const { return m_direction; }

private:
  Vertex_condition_3(const Kind kind, const std::array<double, 3>& direction) : m_kind(kind), m_direction(direction)
  {
    const double sum = std::abs(direction[0]) + std::abs(direction[1]) + std::abs(direction[2]);
    internal::require(kind == AT_TARGET || (sum > 0 && std::isfinite(sum)),
                      "The direction of a condition must be finite and not zero.");
  }

  Kind m_kind = FREE;
  std::array<double, 3> m_direction = {};
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_VERTEX_CONDITION_3_H
