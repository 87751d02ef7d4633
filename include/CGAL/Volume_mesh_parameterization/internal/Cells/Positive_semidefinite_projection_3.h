// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_POSITIVE_SEMIDEFINITE_PROJECTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_POSITIVE_SEMIDEFINITE_PROJECTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Cells/Pack.h>

#include <cmath>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Is the symmetric matrix H positive definite in every cell? (Sylvester's criterion)
template <typename T>
bool is_positive_definite(const Matrix_3<T>& H)
{
  const T second = H(0, 0) * H(1, 1) - H(0, 1) * H(0, 1);
  const T third = H.determinant();
  return !any(minimum(H(0, 0), minimum(second, third)) <= T(0));
}

// One Jacobi rotation, which makes H(p, q) zero; V collects the rotations.
template <typename T>
void annihilate(Matrix_3<T>& H, Matrix_3<T>& V, const int p, const int q)
{
  using std::abs;
  using std::sqrt;
  const T difference = H(p, p) - H(q, q);
  const T opposite = T(2) * H(p, q);
  const T adjacent = abs(difference) + sqrt(difference * difference + opposite * opposite) + T(1e-150);
  const T scale = T(1) / sqrt(adjacent * adjacent + opposite * opposite);
  const T cosine = adjacent * scale;
  const T sine = select(difference < T(0), -opposite, opposite) * scale;

  for(int i = 0; i < 3; ++i) // H R
  {
    const T h = H(i, p);
    H(i, p) = cosine * h + sine * H(i, q);
    H(i, q) = cosine * H(i, q) - sine * h;
    const T v = V(i, p);
    V(i, p) = cosine * v + sine * V(i, q);
    V(i, q) = cosine * V(i, q) - sine * v;
  }
  for(int i = 0; i < 3; ++i) // R^T H
  {
    const T h = H(p, i);
    H(p, i) = cosine * h + sine * H(q, i);
    H(q, i) = cosine * H(q, i) - sine * h;
  }
}

// The nearest positive semi-definite matrix: negative eigenvalues become zero.
template <typename T>
Matrix_3<T> positive_semidefinite_projection_3(const Matrix_3<T>& H)
{
  if(is_positive_definite(H))
    return H;

  Matrix_3<T> diagonal = H;
  Matrix_3<T> V = Matrix_3<T>::Identity();
  constexpr int number_of_sweeps = 5; // converges quadratically: the off-diagonal part is at rounding level
  for(int sweep = 0; sweep < number_of_sweeps; ++sweep)
  {
    annihilate(diagonal, V, 0, 1);
    annihilate(diagonal, V, 0, 2);
    annihilate(diagonal, V, 1, 2);
  }
  Vector_3<T> eigenvalues;
  for(int i = 0; i < 3; ++i)
    eigenvalues[i] = maximum(diagonal(i, i), T(0));
  const Matrix_3<T> scaled = V * eigenvalues.asDiagonal();
  return scaled * V.transpose();
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_POSITIVE_SEMIDEFINITE_PROJECTION_3_H
