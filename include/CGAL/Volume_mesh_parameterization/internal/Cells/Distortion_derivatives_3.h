// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_DISTORTION_DERIVATIVES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_DISTORTION_DERIVATIVES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Cells/Pack.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Positive_semidefinite_projection_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Signed_singular_values_3.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The derivatives of psi(s(J)) with respect to J = R diag(s) Q^T, in the rotated frame: for
// dJ = R dF Q^T,  d psi = sum_i psi_i dF_ii  and
// d2 psi = sum_ij scaling_ij dF_ii dF_jj + sum_{p<q} (symmetric_k (dF_pq + dF_qp)^2 + antisymmetric_k (dF_pq - dF_qp)^2) / 2
// where k is the index opposite to the pair p, q (Smith, de Goes, Kim, Analytic Eigensystems for
// Isotropic Distortion Energies, TOG 2019). Each mode is an eigenvector, so that negative eigenvalues
// can be multiplied by a factor `negative_curvature`: 0 gives the positive semi-definite (PSD)
// Hessian, 1 the full one.
template <typename T>
struct Distortion_derivatives_3
{
  Signed_singular_values_3<T> decomposition;
  Vector_3<T> gradient;
  Matrix_3<T> scaling;
  Vector_3<T> symmetric;
  Vector_3<T> antisymmetric;
};

// The quotient a / b, or its limit where |b| is too small against `size`.
template <typename T>
T quotient_or_limit(const T& a, const T& b, const T& size, const T& limit)
{
  using std::abs;
  const auto is_small = abs(b) <= T(1e-6) * size;
  return select(is_small, limit, a / select(is_small, T(1), b));
}

template <typename T, typename Energy>
Distortion_derivatives_3<T> distortion_derivatives_3(const Energy& energy,
                                                     const Matrix_3<T>& J,
                                                     const double negative_curvature)
{
  using std::abs;
  Distortion_derivatives_3<T> result;
  result.decomposition = signed_singular_values_3(J);
  const Vector_3<T>& s = result.decomposition.s;
  result.gradient = energy.gradient(s);
  const Vector_3<T>& g = result.gradient;
  const Matrix_3<T> H = energy.hessian(s);
  result.scaling = H;

  for(int k = 0; k < 3; ++k)
  {
    const int p = (k + 1) % 3, q = (k + 2) % 3;
    const T size = maximum(abs(s[p]), abs(s[q]));
    result.symmetric[k] = quotient_or_limit<T>(g[p] - g[q], s[p] - s[q], size, H(p, p) - H(p, q));
    result.antisymmetric[k] = quotient_or_limit<T>(g[p] + g[q], s[p] + s[q], size, H(p, p) + H(p, q));
  }

  if(negative_curvature < 1)
  {
    const T kept(negative_curvature);
    const Matrix_3<T> projection = positive_semidefinite_projection_3(H);
    result.scaling = projection + kept * (H - projection);
    for(int k = 0; k < 3; ++k)
    {
      result.symmetric[k] = maximum(result.symmetric[k], kept * result.symmetric[k]);
      result.antisymmetric[k] = maximum(result.antisymmetric[k], kept * result.antisymmetric[k]);
    }
  }
  return result;
}

// The gradient and the Hessian of psi(J) with respect to the images of the four vertices of a cell.
// The vertices 1, 2, 3 belong to the rows b_1, b_2, b_3 of X^{-1}, as J = sum_a u_a b_a^T with
// b_0 = -(b_1 + b_2 + b_3). Only the blocks hessian[a][b] with a, b > 0, a <= b are independent.
template <typename T>
struct Cell_derivatives_3
{
  std::array<Vector_3<T>, 4> gradient;
  std::array<std::array<Matrix_3<T>, 4>, 4> hessian; // [a][b] for a <= b
};

// Eigen's own product of matrices of packs is not inlined, which costs a sixth of the whole assembly.
template <typename T>
EIGEN_ALWAYS_INLINE Matrix_3<T> product(const Matrix_3<T>& A, const Matrix_3<T>& B)
{
  Matrix_3<T> result;
  for(int j = 0; j < 3; ++j)
    for(int i = 0; i < 3; ++i)
      result(i, j) = A(i, 0) * B(0, j) + A(i, 1) * B(1, j) + A(i, 2) * B(2, j);
  return result;
}

template <typename T>
Matrix_3<T> hessian_block(const Distortion_derivatives_3<T>& d, const Vector_3<T>& a, const Vector_3<T>& b)
{
  Matrix_3<T> block;
  for(int p = 0; p < 3; ++p)
    block(p, p) = d.scaling(p, p) * a[p] * b[p];
  for(int k = 0; k < 3; ++k)
  {
    const int p = (k + 1) % 3, q = (k + 2) % 3;
    const T same = T(0.5) * (d.symmetric[k] + d.antisymmetric[k]);
    const T swapped = T(0.5) * (d.symmetric[k] - d.antisymmetric[k]);
    block(p, p) += same * a[q] * b[q];
    block(q, q) += same * a[p] * b[p];
    block(p, q) = d.scaling(p, q) * a[p] * b[q] + swapped * a[q] * b[p];
    block(q, p) = d.scaling(p, q) * a[q] * b[p] + swapped * a[p] * b[q];
  }
  const Matrix_3<T>& R = d.decomposition.R;
  return product<T>(product<T>(R, block), R.transpose());
}

// The gradient alone; row a - 1 of B is Q^T b_a.
template <typename T>
std::array<Vector_3<T>, 4> cell_gradient_3(const Matrix_3<T>& R, const Vector_3<T>& weighted_gradient,
                                           const Matrix_3<T>& B)
{
  std::array<Vector_3<T>, 4> gradient;
  gradient[0].setZero();
  for(int a = 1; a < 4; ++a)
  {
    const Vector_3<T> rotated = weighted_gradient.cwiseProduct(B.row(a - 1).transpose());
    gradient[a] = R * rotated;
    gradient[0] -= gradient[a];
  }
  return gradient;
}

template <typename T>
void cell_derivatives_3(const Distortion_derivatives_3<T>& d,
                        const Matrix_3<T>& inverse_source,
                        const T& weight,
                        Cell_derivatives_3<T>& cell)
{
  const Matrix_3<T> B = inverse_source * d.decomposition.Q;
  cell.gradient = cell_gradient_3<T>(d.decomposition.R, weight * d.gradient, B);

  for(int a = 1; a < 4; ++a)
    for(int b = a; b < 4; ++b)
      cell.hessian[a][b] = hessian_block<T>(d, weight * B.row(a - 1).transpose(), B.row(b - 1).transpose());

  // a translation of the cell changes nothing: rows and columns of blocks sum to zero
  const auto& h = cell.hessian;
  cell.hessian[0][1] = -(h[1][1] + h[1][2].transpose() + h[1][3].transpose());
  cell.hessian[0][2] = -(h[1][2] + h[2][2] + h[2][3].transpose());
  cell.hessian[0][3] = -(h[1][3] + h[2][3] + h[3][3]);
  cell.hessian[0][0] = -(h[0][1] + h[0][2] + h[0][3]);
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_DISTORTION_DERIVATIVES_3_H
