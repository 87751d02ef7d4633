// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_BOX_BOUNDARY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_BOX_BOUNDARY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Where the vertices of a surface lie on the boundary of a box around the origin.
// As a domain of `Radial_map_3` it lets them move in their face or along their edge.
class Box_boundary_3
{
public:
  // On which side of the box a vertex lies along each axis: 1, -1, or 0 for between.
  using Sides = std::array<int, 3>;

  static constexpr double curvature = 0;

  Box_boundary_3(const std::size_t number_of_vertices, const Eigen::Vector3d& half_lengths)
    : m_sides(number_of_vertices, Sides{}), m_half_lengths(half_lengths)
  {}

  const Eigen::Vector3d& half_lengths() const { return m_half_lengths; }
  Sides& sides(const int v) { return m_sides[v]; }
  const Sides& sides(const int v) const { return m_sides[v]; }
  bool is_placed(const int v) const { return m_sides[v] != Sides{}; }

  double area() const
  {
    return 8 * (m_half_lengths[0] * m_half_lengths[1] + m_half_lengths[1] * m_half_lengths[2]
                + m_half_lengths[2] * m_half_lengths[0]);
  }

  // The coordinates that the sides prescribe are exact.
  Eigen::Vector3d on_sides(const int v, Eigen::Vector3d image) const
  {
    for(int axis = 0; axis < 3; ++axis)
      if(m_sides[v][axis] != 0)
        image[axis] = m_sides[v][axis] * m_half_lengths[axis];
    return image;
  }

  Eigen::Matrix<double, 3, 2> tangents(const int v, const Eigen::Vector3d&) const
  {
    Eigen::Matrix<double, 3, 2> result = Eigen::Matrix<double, 3, 2>::Zero();
    int column = 0;
    for(int axis = 0; axis < 3; ++axis)
      if(m_sides[v][axis] == 0)
        result(axis, column++) = 1;
    return result;
  }

  Eigen::Vector3d move(const Eigen::Vector3d& image, const Eigen::Vector3d& step) const
  {
    return image + step;
  }

  // The distance of the face that contains the triangle from the origin.
  double height(const int a, const int b, const int c) const
  {
    for(int axis = 0; axis < 3; ++axis)
      if(m_sides[a][axis] != 0 && m_sides[a][axis] == m_sides[b][axis] && m_sides[a][axis] == m_sides[c][axis])
        return m_half_lengths[axis];
    return 1;
  }

private:
  std::vector<Sides> m_sides;
  Eigen::Vector3d m_half_lengths;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_BOX_BOUNDARY_3_H
