// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_CELL_QUALITY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_CELL_QUALITY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the angle between the two facets at the edge from `p` to `q`, in degrees.
inline double dihedral_angle(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r, const Eigen::Vector3d& s)
{
  constexpr double degrees = 180 / 3.14159265358979323846;
  const Eigen::Vector3d edge = q - p, m = edge.cross(r - p), n = edge.cross(s - p);
  return degrees * std::atan2(m.cross(n).norm(), m.dot(n));
}

inline Cell_quality_3 quality_of_cell(const std::array<Eigen::Vector3d, 4>& p)
{
  const double determinant = (p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]);
  Cell_quality_3 result = { 180, 0, 1, 1 };
  double area = 0, longest = 0;
  for(int i = 0; i < 4; ++i)
  {
    const auto& [a, b, c] = std::array{ p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4] };
    area += (b - a).cross(c - a).norm() / 2;
    const double lengths = (a - p[i]).norm() * (b - p[i]).norm() * (c - p[i]).norm();
    result.smallest_scaled_Jacobian = (std::min)(result.smallest_scaled_Jacobian, std::sqrt(2.) * determinant / lengths);
    for(int j = i + 1; j < 4; ++j)
    {
      const int k = i > 0 ? 0 : j == 1 ? 2 : 1, l = 6 - i - j - k; // the other two vertices
      const double angle = dihedral_angle(p[i], p[j], p[k], p[l]);
      result.smallest_dihedral_angle = (std::min)(result.smallest_dihedral_angle, angle);
      result.largest_dihedral_angle = (std::max)(result.largest_dihedral_angle, angle);
      longest = (std::max)(longest, (p[i] - p[j]).norm());
    }
  }
  const double radius = determinant / 2 / area; // three times the volume by the area
  result.largest_aspect_ratio = longest / (2 * std::sqrt(6.) * radius);
  return result;
}

inline Cell_quality_3 worse(const Cell_quality_3& a, const Cell_quality_3& b)
{
  return { (std::min)(a.smallest_dihedral_angle, b.smallest_dihedral_angle),
           (std::max)(a.largest_dihedral_angle, b.largest_dihedral_angle),
           (std::min)(a.smallest_scaled_Jacobian, b.smallest_scaled_Jacobian),
           (std::max)(a.largest_aspect_ratio, b.largest_aspect_ratio) };
}

// Returns the worst of all qualities; for none, what no cell is better than.
inline Cell_quality_3 worst_quality(const std::vector<Cell_quality_3>& of_cells)
{ return std::accumulate(of_cells.begin(), of_cells.end(), Cell_quality_3{ 180, 0, 1, 1 }, worse); }

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_CELL_QUALITY_3_H
