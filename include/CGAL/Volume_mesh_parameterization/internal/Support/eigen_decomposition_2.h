// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_EIGEN_DECOMPOSITION_2_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_EIGEN_DECOMPOSITION_2_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Dynamic_matrix.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// The eigenvalues of a symmetric matrix in ascending order, and orthonormal eigenvectors as columns.
struct Eigen_decomposition_2
{
  Small_matrix<2, 1> values;
  Small_matrix<2, 2> vectors;
};

// Computes both from the matrix without its trace, scaled to entries up to 1, so that no square overflows. Operations have the
// order of those of Eigen, which rounds alike.
inline Eigen_decomposition_2 eigen_decomposition_2(const Small_matrix<2, 2>& A)
{
  const double shift = A.trace() / 2;
  double a = A(0, 0) - shift, b = A(1, 0), c = A(1, 1) - shift;
  const double scale = (std::max)({ std::abs(a), std::abs(b), std::abs(c) });
  if(scale > 0)
  {
    a /= scale;
    b /= scale;
    c /= scale;
  }
  const double radius = std::sqrt((a - c) * (a - c) + 4 * (b * b)) / 2, mean = (a + c) / 2;
  const double smaller = mean - radius, larger = mean + radius;

  Eigen_decomposition_2 result;
  result.values << smaller, larger;
  result.values *= scale;
  result.values.array() += shift;
  result.vectors.setIdentity();
  if(larger - smaller > std::abs(larger) * std::numeric_limits<double>::epsilon())
  {
    a -= larger;
    c -= larger;
    const double aa = a * a, bb = b * b, cc = c * c;
    if(aa > cc)
      result.vectors.col(1) << -b / std::sqrt(aa + bb), a / std::sqrt(aa + bb);
    else
      result.vectors.col(1) << -c / std::sqrt(cc + bb), b / std::sqrt(cc + bb);
    result.vectors.col(0) << result.vectors.col(1).unitOrthogonal();
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_EIGEN_DECOMPOSITION_2_H
