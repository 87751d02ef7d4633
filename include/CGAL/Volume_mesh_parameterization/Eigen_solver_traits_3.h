// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EIGEN_SOLVER_TRAITS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EIGEN_SOLVER_TRAITS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>

#include <Eigen/Sparse>

#include <type_traits>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationSolvers

makes a solver for Newton's method of a sparse solver of Eigen. Examples are `Eigen::SimplicialLLT`,
`Eigen::CholmodDecomposition`, `Eigen::PardisoLLT` and `Eigen::ConjugateGradient`. The solver needs `analyzePattern()`,
`factorize()` and `solve()`. Both triangles of the matrix are copied for it. An iterative solver gets the tolerance of each step.

The pivots of `Eigen::SimplicialLDLT` must be positive. Other solvers that do not notice indefinite matrices, such as
`Eigen::SparseLU` and `Eigen::ConjugateGradient`, must find a direction of descent. The time and memory are those of the solver; a
copy of the matrix takes 12 bytes a number in addition.

\tparam EigenSolver a sparse solver of Eigen for column-major or symmetric row-major matrices of `float` or `double`

\cgalModels{NewtonSolverTraits_3}

\sa `Conjugate_gradient_solver_traits_3`
\sa `CHOLMOD_solver_traits_3`
*/
template <typename EigenSolver = Eigen::SimplicialLLT<Eigen::SparseMatrix<double> > >
class Eigen_solver_traits_3
{
public:
  using NT = typename EigenSolver::Scalar;  ///< the number type
  using Matrix = Block_sparse_matrix_3<NT>; ///< the type of the matrix

  /// makes a solver with its default parameters.
  Eigen_solver_traits_3() = default;

  /// makes a solver that shares nothing with the other one, with default parameters: those of Eigen cannot be copied.
  Eigen_solver_traits_3(const Eigen_solver_traits_3&) {}
  Eigen_solver_traits_3& operator=(const Eigen_solver_traits_3&) = delete;

  /// returns the solver of Eigen, to set its parameters. Pass this object by `std::ref()` then.
  EigenSolver& solver() { return m_solver; }

  /// analyzes the pattern of `A`.
  void analyze_pattern(const Matrix& A)
  {
    copy(A);
    if(A.size() > 0)
      m_solver.analyzePattern(m_matrix);
  }

  /// factorizes `A`, or prepares for iterations.
  ///
  /// \return `SUCCESS`, `NOT_POSITIVE_DEFINITE` if Eigen reports a numerical issue or a pivot is not positive, or `FAILED`
  Linear_solver_status factorize(const Matrix& A)
  {
    if(A.size() == 0)
      return Linear_solver_status::SUCCESS;
    copy(A);
    m_solver.factorize(m_matrix);
    return has_positive_pivots(m_solver, 0) ? status() : Linear_solver_status::NOT_POSITIVE_DEFINITE;
  }

  /// solves \f$A x = b\f$.
  ///
  /// \return `SUCCESS`, `ITERATION_LIMIT`, `NOT_POSITIVE_DEFINITE` if \f$b^T x\f$ is not positive although \f$b\f$ is not 0,
  ///         or `FAILED`
  Linear_solver_status solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, const double tolerance)
  {
    if(b.size() == 0)
    {
      x = b;
      return Linear_solver_status::SUCCESS;
    }
    if constexpr(std::is_base_of<Eigen::IterativeSolverBase<EigenSolver>, EigenSolver>::value)
      m_solver.setTolerance(static_cast<NT>(tolerance));
    const Eigen::Matrix<NT, Eigen::Dynamic, 1> right = b.template cast<NT>(), solution = m_solver.solve(right);
    x = solution.template cast<double>();
    if(!x.allFinite())
      return Linear_solver_status::FAILED;
    if(!b.isZero(0) && !(b.dot(x) > 0))
      return Linear_solver_status::NOT_POSITIVE_DEFINITE;
    return status();
  }

private:
  using Sparse_matrix = Eigen::SparseMatrix<NT, EigenSolver::MatrixType::Options, typename EigenSolver::MatrixType::StorageIndex>;

  template <typename Solver>
  static auto has_positive_pivots(const Solver& solver, int) -> decltype(solver.vectorD().minCoeff() > 0)
  { return solver.info() != Eigen::Success || solver.vectorD().minCoeff() > 0; }

  template <typename Solver>
  static bool has_positive_pivots(const Solver&, long) { return true; } // solvers that have no pivots, or do not show them

  Linear_solver_status status() const
  {
    switch(m_solver.info())
    {
      case Eigen::Success: return Linear_solver_status::SUCCESS;
      case Eigen::NumericalIssue: return Linear_solver_status::NOT_POSITIVE_DEFINITE;
      case Eigen::NoConvergence: return Linear_solver_status::ITERATION_LIMIT;
      default: return Linear_solver_status::FAILED;
    }
  }

  // Copies the blocks by scalar rows, which are the columns of a symmetric matrix, too.
  void copy(const Matrix& A)
  {
    const int n = 3 * A.size();
    m_matrix.resize(n, n);
    m_matrix.resizeNonZeros(A.size() == 0 ? 0 : 9 * Eigen::Index(A.row_end(A.size() - 1)));
    Eigen::Index next = 0;
    for(int row = 0; row < n; ++row)
    {
      for(int k = A.row_begin(row / 3); k < A.row_end(row / 3); ++k)
        for(int i = 0; i < 3; ++i, ++next)
        {
          m_matrix.innerIndexPtr()[next] = 3 * A.column(k) + i;
          m_matrix.valuePtr()[next] = A.block(k)(row % 3, i);
        }
      m_matrix.outerIndexPtr()[row + 1] = static_cast<typename Sparse_matrix::StorageIndex>(next);
    }
  }

  Sparse_matrix m_matrix; // before the solver, which may refer to it
  EigenSolver m_solver;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EIGEN_SOLVER_TRAITS_3_H
