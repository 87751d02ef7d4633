// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_CONJUGATE_GRADIENT_SOLVER_TRAITS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_CONJUGATE_GRADIENT_SOLVER_TRAITS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Solvers/Conjugate_gradient_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationSolvers

Conjugate gradients with a preconditioner: the inverses of the 3x3 diagonal blocks, and for large matrices also those of
aggregates of rows. If the matrix shows negative curvature, the iteration is truncated \cgalCite{cgal:s-cgmtr-83}. Memory: five
vectors and the diagonal blocks, and a twentieth of the matrix for aggregates. One iteration costs one product with the matrix,
and a tenth more for large matrices, in time linear in the number of cells. The number of iterations grows with the distortion of
the map. It grows slowly with the number of cells along a diameter of the mesh.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; results do not depend on it, nor
        on the number of threads
\tparam NT_ the number type of matrix and vectors, `float` or `double`. A Newton direction needs a few digits only. Therefore,
        `float` suffices, and halves the memory traffic

\cgalModels{NewtonSolverTraits_3}
*/
template <typename ConcurrencyTag = Sequential_tag, typename NT_ = float>
class Conjugate_gradient_solver_traits_3
{
public:
  using NT = NT_;                           ///< the number type
  using Matrix = Block_sparse_matrix_3<NT>; ///< the type of the matrix

  /// limits the number of iterations of each call of `solve()`, by default to 2,000; at the limit, it returns the last iterate.
  /// If a factorization takes no more multiplications, a map then factorizes the matrix, as `Eigen_solver_traits_3` does. The
  /// following matrices are factorized as long as iterations take longer.
  /// \pre The limit is not negative; otherwise `CGAL::Precondition_exception` is thrown, in every build.
  explicit Conjugate_gradient_solver_traits_3(const int maximum_number_of_iterations = internal::default_limit_of_iterations)
    : m_solver(internal::make_conjugate_gradient_3<NT>(internal::is_parallel<ConcurrencyTag>(), maximum_number_of_iterations))
  { internal::require(maximum_number_of_iterations >= 0, "maximum_number_of_iterations must not be negative."); }

  /// copies a solver, which keeps its pattern and preconditioner.
  Conjugate_gradient_solver_traits_3(const Conjugate_gradient_solver_traits_3& other) : m_solver(other.m_solver->copy()) {}
  /// copies a solver likewise.
  Conjugate_gradient_solver_traits_3& operator=(const Conjugate_gradient_solver_traits_3& other)
  {
    m_solver = other.m_solver->copy();
    return *this;
  }

  /// reserves memory for vectors.
  void analyze_pattern(const Matrix& A) { m_solver->analyze_pattern(A); }

  /// computes the preconditioner, the inverses of the diagonal blocks. From 30,000 rows on, it also inverts sums of blocks over
  /// aggregates of 32, 256, ... contiguous rows. These rows should be near each other. It does not notice whether `A` is
  /// positive definite.
  ///
  /// \return `SUCCESS`
  Linear_solver_status factorize(const Matrix& A)
  {
    m_solver->factorize(A);
    return Linear_solver_status::SUCCESS;
  }

  /// solves \f$A x = b\f$ from \f$x = 0\f$ on until the residual \f$r\f$, in the norm \f$\sqrt{r^T M^{-1} r}\f$ of the
  /// preconditioner \f$M\f$, has fallen by the factor `tolerance`. The function `may_continue`, if there is one, is called every
  /// few iterations. If it returns `false`, the iteration ends as at its limit.
  ///
  /// \return `SUCCESS`; `ITERATION_LIMIT` if the limit of iterations was reached before; `FAILED` if a number is not finite. If
  ///         a direction \f$p\f$ with \f$p^T A p \le 0\f$ was met, `NOT_POSITIVE_DEFINITE` for the first direction, and
  ///         `TRUNCATED` for a later one
  template <typename Vector>
  Linear_solver_status solve(const std::decay_t<Vector>& b, Vector& x, const double tolerance,
                             const std::function<bool()>& may_continue = nullptr)
  {
    x.resize(b.size());
    return m_solver->solve(b.data(), x.data(), tolerance, may_continue);
  }

  /// returns the number of iterations of the last call of `solve()`.
  int number_of_iterations() const { return m_solver->number_of_iterations(); }

private:
  std::unique_ptr<internal::Conjugate_gradient_3<NT> > m_solver;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_CONJUGATE_GRADIENT_SOLVER_TRAITS_3_H
