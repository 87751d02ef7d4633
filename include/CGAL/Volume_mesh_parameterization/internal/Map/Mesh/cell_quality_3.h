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
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_arithmetic_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Computes all from the six lengths and the four normals. Has minus the cotangent of an angle, which grows with it, in place of
// the angle: arcs are computed only of the smallest and of the largest angle of all cells.
inline Cell_quality_3 quality_of_cell(const std::array<Vector_3, 4>& p)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<Vector_3, 4> normals; // as long as twice the area of the facet
  double area = 0, longest = 0, smallest_cotangent = infinity, largest_cotangent = -infinity;
  for(int i = 0; i < 4; ++i)
  {
    const auto& [a, b, c] = facets_of_cell[i];
    normals[i] = (p[b] - p[a]).cross(p[c] - p[a]);
    area += normals[i].norm() / 2;
  }
  const double determinant = normals[3].dot(p[0] - p[3]);
  std::array<double, 4> lengths = { 1, 1, 1, 1 }; // products of the lengths of the edges at each corner
  for(int i = 0; i < 4; ++i)
    for(int j = i + 1; j < 4; ++j)
    {
      const int k = i > 0 ? 0 : j == 1 ? 2 : 1, l = 6 - i - j - k; // the other two vertices
      const double length = (p[i] - p[j]).norm(), sine = std::abs(determinant) * length, cosine = -normals[k].dot(normals[l]);
      const double cotangent = sine > 0 ? cosine / sine : cosine < 0 ? -infinity : infinity; // angles of a flat cell are 0 or 180
      smallest_cotangent = (std::min)(smallest_cotangent, cotangent);
      largest_cotangent = (std::max)(largest_cotangent, cotangent);
      longest = (std::max)(longest, length);
      lengths[i] *= length;
      lengths[j] *= length;
    }
  const double radius = determinant / 2 / area; // three times the volume by the area
  const auto [shortest_lengths, longest_lengths] = std::minmax_element(lengths.begin(), lengths.end());
  return { -largest_cotangent, -smallest_cotangent,
           (std::min)(1., std::sqrt(2.) * determinant / *(determinant < 0 ? shortest_lengths : longest_lengths)),
           (std::max)(1., longest / (2 * std::sqrt(6.) * radius)) };
}

inline Cell_quality_3 worse(const Cell_quality_3& a, const Cell_quality_3& b)
{
  return { (std::min)(a.minimum_dihedral_angle, b.minimum_dihedral_angle),
           (std::max)(a.maximum_dihedral_angle, b.maximum_dihedral_angle),
           (std::min)(a.minimum_scaled_jacobian, b.minimum_scaled_jacobian),
           (std::max)(a.maximum_aspect_ratio, b.maximum_aspect_ratio) };
}

// Returns the worst of all qualities; for none, what no cell is better than.
inline Cell_quality_3 worst_quality(const std::vector<Cell_quality_3>& of_cells)
{
  constexpr double infinity = std::numeric_limits<double>::infinity(), degrees = 180 / 3.14159265358979323846;
  Cell_quality_3 result = std::accumulate(of_cells.begin(), of_cells.end(), Cell_quality_3{ infinity, -infinity, 1, 1 }, worse);
  for(double* const angle : { &result.minimum_dihedral_angle, &result.maximum_dihedral_angle })
    *angle = degrees * std::atan2(1, -*angle);
  return result;
}

// Returns the distortion of a cell; `source(i)` and `image(i)` return the points of its vertices.
template <typename Source, typename Image>
Cell_distortion_3 distortion_of_cell(const Source& source, const Image& image)
{
  Eigen::Matrix3d X, U;
  for(int i = 0; i < 3; ++i)
  {
    X.col(i) = Eigen::Vector3d(source(i + 1) - source(0));
    U.col(i) = Eigen::Vector3d(image(i + 1) - image(0));
  }
  const Vector_3 s = signed_singular_values_3(U * X.inverse());
  const double ratio = s.maxCoeff() / s.minCoeff(), determinant = s.prod();
  return { ratio + 1 / ratio, determinant + 1 / determinant, determinant };
}

// Returns the distortions of cells, whose indices have been checked.
inline std::vector<Cell_distortion_3> distortions_of_cells_3(const std::vector<std::array<double, 3> >& points,
                                                             const std::vector<std::array<std::size_t, 4> >& cells,
                                                             const std::vector<std::array<double, 3> >& images)
{
  std::vector<Cell_distortion_3> result;
  result.reserve(cells.size());
  for(const std::array<std::size_t, 4>& cell : cells)
    result.push_back(distortion_of_cell([&](const int i) { return to_vector(points[cell[i]]); },
                                        [&](const int i) { return to_vector(images[cell[i]]); }));
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_CELL_QUALITY_3_H
