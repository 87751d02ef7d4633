// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LARGEST_STEP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LARGEST_STEP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Newton/Cell_packs_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Energy_sum_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/for_each_index.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The Bernstein coefficients on [0, 1] of the cubic polynomial t -> det(J + t dJ). If all are
// positive, so is the polynomial.
template <typename T>
Eigen::Matrix<T, 4, 1> determinant_polynomial(const Matrix_3<T>& J, const Matrix_3<T>& dJ)
{
  const auto mixed = [](const Matrix_3<T>& A, const Matrix_3<T>& B) // derivative of det at A in direction B
  {
    return B.col(0).dot(A.col(1).cross(A.col(2))) + B.col(1).dot(A.col(2).cross(A.col(0)))
         + B.col(2).dot(A.col(0).cross(A.col(1)));
  };
  const T third(1. / 3.);
  const T c0 = J.determinant();
  const T c1 = mixed(J, dJ);
  const T c2 = mixed(dJ, J);
  const T c3 = dJ.determinant();
  Eigen::Matrix<T, 4, 1> b;
  b << c0, c0 + third * c1, c0 + third * (T(2) * c1 + c2), c0 + c1 + c2 + c3;
  return b;
}

// A number in [0, 1] up to which the polynomial with Bernstein coefficients b is positive: its
// first root, less at most the resolution times that root, however small it is. Bisects by de
// Casteljau's algorithm.
inline double positive_until(const Eigen::Vector4d& b, const double resolution = 1. / 1024)
{
  if(b.minCoeff() > 0)
    return 1;
  if(resolution >= 1 || !(b[0] > 0) || !b.allFinite())
    return 0;
  const double b01 = (b[0] + b[1]) / 2, b12 = (b[1] + b[2]) / 2, b23 = (b[2] + b[3]) / 2;
  const double b012 = (b01 + b12) / 2, b123 = (b12 + b23) / 2;
  const double middle = (b012 + b123) / 2;
  const double left = positive_until(Eigen::Vector4d(b[0], b01, b012, middle), resolution);
  if(left < 1)
    return left / 2;
  return (1 + positive_until(Eigen::Vector4d(middle, b123, b23, b[3]), 2 * resolution)) / 2;
}

// The largest t in [0, 1] for which u + t d inverts no cell, if u inverts none.
template <typename ConcurrencyTag>
double largest_step_3(const Cell_packs_3& packs, const Eigen::Matrix3Xd& u, const Eigen::Matrix3Xd& d)
{
  std::vector<double> parts(packs.number_of_chunks(), 1.);
  for_each_index<ConcurrencyTag>(0, parts.size(), [&](const std::size_t chunk)
  {
    for(std::size_t p = packs.chunk_begin(chunk); p < packs.chunk_end(chunk); ++p)
    {
      const Eigen::Matrix<Pack, 4, 1> b
        = determinant_polynomial<Pack>(edge_matrix(u, packs[p]) * packs[p].inverse_source,
                                       edge_matrix(d, packs[p]) * packs[p].inverse_source);
      if(smallest(minimum(minimum(b[0], b[1]), minimum(b[2], b[3]))) > 0)
        continue;
      double coefficients[4][Pack::size];
      for(int i = 0; i < 4; ++i)
        b[i].store(coefficients[i]);
      for(int lane = 0; lane < Pack::size; ++lane)
        parts[chunk] = (std::min)(parts[chunk],
          positive_until(Eigen::Vector4d(coefficients[0][lane], coefficients[1][lane],
                                         coefficients[2][lane], coefficients[3][lane])));
    }
  });
  return std::accumulate(parts.begin(), parts.end(), 1., [](double a, double b) { return (std::min)(a, b); });
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LARGEST_STEP_3_H
