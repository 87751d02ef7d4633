// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_SIGNED_SINGULAR_VALUES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_SIGNED_SINGULAR_VALUES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Cells/Pack.h>

#include <cmath>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The decomposition J = R diag(s) Q^T with rotations R and Q and s_0 >= s_1 >= |s_2|:
// the smallest singular value carries the sign of det J.
template <typename T>
struct Signed_singular_values_3
{
  Matrix_3<T> R, Q;
  Vector_3<T> s;
};

// Rotates the columns p and q of A (and of Q), by at most 45 degrees, so that they become orthogonal.
// Returns a positive number if the cosine of the angle between them was above 1e-8.
template <typename T>
T orthogonalize_columns(Matrix_3<T>& A, Matrix_3<T>& Q, const int p, const int q)
{
  using std::abs;
  using std::sqrt;
  const T tiny(1e-150);

  const T pp = A.col(p).squaredNorm();
  const T qq = A.col(q).squaredNorm();
  const T pq = A.col(p).dot(A.col(q));

  // half of the angle whose tangent is 2 pq / (pp - qq), without cancellation
  const T difference = pp - qq;
  const T opposite = T(2) * pq;
  const T adjacent = abs(difference) + sqrt(difference * difference + opposite * opposite) + tiny;
  const T scale = T(1) / sqrt(adjacent * adjacent + opposite * opposite);
  const T cosine = adjacent * scale;
  const T sine = select(difference < T(0), -opposite, opposite) * scale;

  for(Matrix_3<T>* M : {&A, &Q})
  {
    const Vector_3<T> column = M->col(p);
    M->col(p) = cosine * column + sine * M->col(q);
    M->col(q) = cosine * M->col(q) - sine * column;
  }
  return pq * pq - T(1e-16) * pp * qq;
}

// Puts the longer one of the columns p and q of A first, by a rotation by 90 degrees (of Q as well).
template <typename T>
void sort_columns(Matrix_3<T>& A, Matrix_3<T>& Q, const int p, const int q)
{
  const auto is_sorted = A.col(p).squaredNorm() >= A.col(q).squaredNorm();
  for(Matrix_3<T>* M : {&A, &Q})
    for(int i = 0; i < 3; ++i)
    {
      const T x = (*M)(i, p);
      (*M)(i, p) = select(is_sorted, x, (*M)(i, q));
      (*M)(i, q) = select(is_sorted, (*M)(i, q), -x);
    }
}

// v / length, or the fallback where the length is at most `smallest`.
template <typename T>
Vector_3<T> normalized_or(const Vector_3<T>& v, const T& length, const T& smallest, const Vector_3<T>& fallback)
{
  const auto is_long = length > smallest;
  const T inverse = T(1) / select(is_long, length, T(1));
  return Vector_3<T>(select(is_long, v[0] * inverse, fallback[0]),
                     select(is_long, v[1] * inverse, fallback[1]),
                     select(is_long, v[2] * inverse, fallback[2]));
}

// A unit vector orthogonal to the unit vector v.
template <typename T>
Vector_3<T> unit_orthogonal(const Vector_3<T>& v)
{
  using std::sqrt;
  const auto is_along_z = v[0] * v[0] + v[1] * v[1] < T(0.5);
  const T length = sqrt(T(1) - select(is_along_z, v[0] * v[0], v[2] * v[2]));
  return Vector_3<T>(select(is_along_z, T(0), -v[1]),
                     select(is_along_z, v[2], v[0]),
                     select(is_along_z, -v[1], T(0))) / length;
}

// One-sided Jacobi iteration: accurate for tiny singular values, and the same instructions for
// every cell. It converges quadratically, so the sweep that starts with angles below 1e-8 is the last.
// Columns are sorted after it: a swap within a sweep would hide a pair of columns from its test.
template <typename T>
Signed_singular_values_3<T> signed_singular_values_3(const Matrix_3<T>& J)
{
  using std::sqrt;
  constexpr int maximal_number_of_sweeps = 12;
  const T tiny(1e-300);

  Signed_singular_values_3<T> result;
  Matrix_3<T>& R = result.R;
  Matrix_3<T>& Q = result.Q;
  Matrix_3<T> A = J;
  Q.setIdentity();
  for(int sweep = 0; sweep < maximal_number_of_sweeps; ++sweep)
  {
    const T r01 = orthogonalize_columns(A, Q, 0, 1);
    const T r02 = orthogonalize_columns(A, Q, 0, 2);
    const T r12 = orthogonalize_columns(A, Q, 1, 2);
    if(!any(maximum(r01, maximum(r02, r12)) > T(0)))
      break;
  }
  sort_columns(A, Q, 0, 1);
  sort_columns(A, Q, 1, 2);
  sort_columns(A, Q, 0, 1);

  // the third column of R follows from the first two, which belong to the larger singular values
  result.s[0] = sqrt(A.col(0).squaredNorm());
  R.col(0) = normalized_or<T>(A.col(0), result.s[0], tiny, Vector_3<T>::UnitX());
  const Vector_3<T> second = A.col(1) - R.col(0) * R.col(0).dot(A.col(1));
  result.s[1] = sqrt(second.squaredNorm());
  R.col(1) = normalized_or<T>(second, result.s[1], T(1e-15) * result.s[0] + tiny, unit_orthogonal<T>(R.col(0)));
  R.col(2) = R.col(0).cross(R.col(1));
  result.s[2] = R.col(2).dot(A.col(2));
  return result;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_SIGNED_SINGULAR_VALUES_3_H
