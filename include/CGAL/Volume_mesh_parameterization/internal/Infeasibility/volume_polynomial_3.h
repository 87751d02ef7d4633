// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors


#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_VOLUME_POLYNOMIAL_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_VOLUME_POLYNOMIAL_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A product of at most three coordinates of free vertices: 3 v + k stands for the coordinate k of vertex v,
// -1 for the factor 1. The factors are in decreasing order.
using Coordinate_monomial = std::array<int, 3>;

constexpr Coordinate_monomial constant_monomial = {-1, -1, -1};

template <typename NT>
using Volume_polynomial_3 = std::map<Coordinate_monomial, NT>;

inline bool is_odd_permutation(const std::array<int, 4>& p)
{
  bool odd = false;
  for(int i = 0; i < 4; ++i)
    for(int j = i + 1; j < 4; ++j)
      odd ^= p[i] > p[j];
  return odd;
}

// Six times the volume of the image of a cell, a polynomial in the coordinates of its free vertices;
// `coordinate(v, k)` is the coordinate k of the prescribed vertex v.
// It is the determinant of the rows (1, x, y, z) of the vertices, summed over all permutations.
template <typename NT, typename Coordinate>
Volume_polynomial_3<NT> volume_polynomial_3(const Numbered_mesh_3& mesh, const std::array<int, 4>& cell,
                                            const Coordinate& coordinate)
{
  Volume_polynomial_3<NT> result;
  std::array<int, 4> column = {0, 1, 2, 3};
  do
  {
    NT coefficient = is_odd_permutation(column) ? -1 : 1;
    Coordinate_monomial monomial = constant_monomial;
    std::size_t degree = 0;
    for(int row = 0; row < 4; ++row)
    {
      const int k = column[row] - 1;
      if(k < 0)
        continue;
      if(mesh.is_free(cell[row]))
        monomial[degree++] = 3 * cell[row] + k;
      else
        coefficient *= coordinate(cell[row], k);
    }
    std::sort(monomial.begin(), monomial.end(), std::greater<int>());
    result[monomial] += coefficient;
  }
  while(std::next_permutation(column.begin(), column.end()));
  return result;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_VOLUME_POLYNOMIAL_3_H
