// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_IS_POSITIVE_HEXAHEDRON_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_IS_POSITIVE_HEXAHEDRON_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/basic.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

template <typename FT>
using Hexahedron_points_3 = std::array<std::array<FT, 3>, 8>; // in the order of VTK

// Bernstein coefficients of a polynomial on the unit cube whose degree in each variable is 2: that of (i, j, k) is at 9i + 3j + k.
template <typename FT>
using Bernstein_coefficients_3 = std::array<FT, 27>;

// Returns the coefficients of the Jacobian determinant of the trilinear map of the unit cube to a hexahedron. The derivative by a
// variable is bilinear in both others, with edges as coefficients; each coefficient of the determinant is the mean of those of
// the triples of edges, one along each axis, whose positions add up to its index (Johnen, Weill and Remacle, Robust and efficient
// validation of the linear hexahedral element, 2017).
template <typename FT>
Bernstein_coefficients_3<FT> jacobian_coefficients_3(const Hexahedron_points_3<FT>& points)
{
  const auto edge_along = [&](const std::size_t axis, std::array<std::size_t, 3> at)
  {
    constexpr std::size_t vertex[2][2][2] = { { {0, 4}, {3, 7} }, { {1, 5}, {2, 6} } }; // at each corner of the unit cube
    at[axis] = 1;
    std::array<FT, 3> result = points[vertex[at[0]][at[1]][at[2]]];
    at[axis] = 0;
    for(std::size_t i = 0; i < 3; ++i)
      result[i] -= points[vertex[at[0]][at[1]][at[2]]][i];
    return result;
  };
  std::array<std::array<std::array<FT, 3>, 4>, 3> edges; // along each axis, by the positions on both others
  for(std::size_t l = 0; l < 4; ++l)
  {
    edges[0][l] = edge_along(0, { 0, l / 2, l % 2 });
    edges[1][l] = edge_along(1, { l / 2, 0, l % 2 });
    edges[2][l] = edge_along(2, { l / 2, l % 2, 0 });
  }
  std::array<std::array<FT, 3>, 16> cross_products; // of the edges along both last axes
  for(std::size_t l = 0; l < 16; ++l)
  {
    const std::array<FT, 3>& y = edges[1][l / 4];
    const std::array<FT, 3>& z = edges[2][l % 4];
    cross_products[l] = { y[1] * z[2] - y[2] * z[1], y[2] * z[0] - y[0] * z[2], y[0] * z[1] - y[1] * z[0] };
  }
  Bernstein_coefficients_3<FT> result;
  result.fill(FT(0));
  for(std::size_t l = 0; l < 4; ++l)
    for(std::size_t m = 0; m < 16; ++m)
    {
      const std::array<FT, 3> &x = edges[0][l], &yz = cross_products[m];
      const std::array<std::size_t, 3> index = { m / 8 + m / 2 % 2, l / 2 + m % 2, l % 2 + m / 4 % 2 };
      const int number_of_triples = static_cast<int>((1 + index[0] % 2) * (1 + index[1] % 2) * (1 + index[2] % 2));
      result[9 * index[0] + 3 * index[1] + index[2]] += (x[0] * yz[0] + x[1] * yz[1] + x[2] * yz[2]) / number_of_triples;
    }
  return result;
}

// Returns the step between the indices of neighbors along an axis (9, 3 or 1), for the axis where neighbors differ most.
template <typename FT>
std::size_t steepest_step_3(const Bernstein_coefficients_3<FT>& coefficients)
{
  std::pair<FT, std::size_t> steepest(0, 1);
  for(const std::size_t step : { 9, 3, 1 })
    for(std::size_t i = 0; i < 27; ++i)
      if(i / step % 3 < 2)
        if(const FT difference = CGAL::abs(FT(coefficients[i + step] - coefficients[i])); difference > steepest.first)
          steepest = { difference, step };
  return steepest.second;
}

// Returns the coefficients on both halves of the cube along the axis with this step, by the algorithm of de Casteljau.
template <typename FT>
std::array<Bernstein_coefficients_3<FT>, 2> halves_3(const Bernstein_coefficients_3<FT>& coefficients, const std::size_t step)
{
  std::array<Bernstein_coefficients_3<FT>, 2> result = { coefficients, coefficients };
  for(std::size_t i = 0; i < 27; ++i)
    if(i / step % 3 == 0)
    {
      const FT left = (coefficients[i] + coefficients[i + step]) / 2;
      const FT right = (coefficients[i + step] + coefficients[i + 2 * step]) / 2;
      result[0][i + step] = left;
      result[1][i + step] = right;
      result[0][i + 2 * step] = result[1][i] = (left + right) / 2;
    }
  return result;
}

// Returns whether a polynomial is positive on the closed unit cube, by its Bernstein coefficients. Returns no value if errors of
// the coefficients, up to `error`, leave that open; if `error` is 0, there is a value. Coefficients at the corners are values, and
// all coefficients bound the values between them. If the bounds leave the sign open, the cube is halved. A polynomial may touch
// zero, or nearly so on a whole surface: what many pieces, or a tiny one, leave open counts as not positive.
template <typename FT>
std::optional<bool> is_positive_polynomial_3(const Bernstein_coefficients_3<FT>& coefficients, const FT& error)
{
  constexpr int maximum_number_of_halvings = 60; // a minimum of 1e-12 of the maximum has been found then
  constexpr int maximum_number_of_pieces = 10000; // a guess; usual hexahedra need a few
  std::vector<std::pair<Bernstein_coefficients_3<FT>, int> > pieces = { { coefficients, 0 } }; // with their numbers of halvings
  for(int number = 0; !pieces.empty(); ++number)
  {
    const auto [piece, number_of_halvings] = pieces.back();
    pieces.pop_back();
    for(const std::size_t corner : { 0, 2, 6, 8, 18, 20, 24, 26 })
    {
      if(piece[corner] <= -error)
        return false;
      if(piece[corner] <= error)
        return std::nullopt;
    }
    if(std::all_of(piece.begin(), piece.end(), [&](const FT& x) { return x > error; }))
      continue;
    if(number_of_halvings == maximum_number_of_halvings)
      return error == 0 ? std::optional<bool>(false) : std::nullopt;
    if(number >= maximum_number_of_pieces)
      return false;
    const auto [first, second] = halves_3(piece, steepest_step_3(piece));
    pieces.emplace_back(second, number_of_halvings + 1);
    pieces.emplace_back(first, number_of_halvings + 1);
  }
  return true;
}

// Returns whether the Jacobian determinant of a hexahedron is positive all over it. A filter in double precision decides, or, if
// its errors leave that open, rational numbers.
inline bool is_positive_hexahedron_3(const Hexahedron_points_3<double>& points)
{
  for(const std::array<double, 3>& p : points)
    if(!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      return false;
  double error = 1e-13; // more than 8 determinants and 120 means lose by rounding, relative to the product of the ranges
  for(std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto less = [axis](const std::array<double, 3>& p, const std::array<double, 3>& q) { return p[axis] < q[axis]; };
    const auto range = std::minmax_element(points.begin(), points.end(), less);
    error *= (*range.second)[axis] - (*range.first)[axis];
  }
  if(std::isnormal(error))
    if(const std::optional<bool> result = is_positive_polynomial_3(jacobian_coefficients_3(points), error))
      return *result;
  Hexahedron_points_3<Exact_rational> exact;
  for(std::size_t i = 0; i < 8; ++i)
    std::copy(points[i].begin(), points[i].end(), exact[i].begin());
  return *is_positive_polynomial_3(jacobian_coefficients_3(exact), Exact_rational(0));
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_IS_POSITIVE_HEXAHEDRON_3_H
