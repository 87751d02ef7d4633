// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_EVALUATION_BARYCENTRIC_COORDINATES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_EVALUATION_BARYCENTRIC_COORDINATES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_point_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/determinant.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Volume_mesh_parameterization::internal {

using Corners_3 = std::array<Exact_point_3, 4>;

// Six times the volumes of the four tetrahedra in which a point replaces one corner.
template <typename FT>
std::array<FT, 4> volumes_with_point_3(const Corners_3& corners, const Exact_point_3& p)
{
  std::array<std::array<FT, 3>, 4> d;
  for(std::size_t i = 0; i < 4; ++i)
    for(int k = 0; k < 3; ++k)
      d[i][static_cast<std::size_t>(k)] = FT(corners[i][k]) - FT(p[k]);
  const auto volume = [&](const std::size_t i, const std::size_t j, const std::size_t k)
  {
    return FT(CGAL::determinant<FT>(d[i][0], d[i][1], d[i][2], d[j][0], d[j][1], d[j][2], d[k][0], d[k][1], d[k][2]));
  };
  return { volume(1, 2, 3), volume(0, 3, 2), volume(0, 1, 3), volume(0, 2, 1) };
}

// The barycentric coordinates of a point in the closed tetrahedron: not negative, of sum 1 up to rounding. Rounding
// errs by some 1e-15 L^3 in each volume, for a tetrahedron of size L. Where this is not small against their sum,
// the volumes are computed exactly.
inline std::array<double, 4> barycentric_coordinates_3(const Corners_3& corners, const Exact_point_3& p)
{
  double size = 0;
  for(const Exact_point_3& corner : corners)
    for(int k = 0; k < 3; ++k)
      size = (std::max)(size, std::abs(corner[k] - p[k]));
  std::array<double, 4> result = volumes_with_point_3<double>(corners, p);
  double sum = result[0] + result[1] + result[2] + result[3];
  if(!(std::abs(sum) > 1e-5 * size * size * size))
  {
    const std::array<Exact_rational, 4> exact = volumes_with_point_3<Exact_rational>(corners, p);
    const Exact_rational exact_sum = exact[0] + exact[1] + exact[2] + exact[3];
    for(std::size_t i = 0; i < 4; ++i)
      result[i] = CGAL::to_double(Exact_rational(exact[i] / exact_sum));
    sum = 1;
  }
  double clamped_sum = 0;
  for(double& coordinate : result)
    clamped_sum += coordinate = (std::max)(0., coordinate / sum);
  for(double& coordinate : result)
    coordinate /= clamped_sum;
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_EVALUATION_BARYCENTRIC_COORDINATES_3_H
