// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_CHOLMOD_SOLVER_TRAITS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_CHOLMOD_SOLVER_TRAITS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>

#include <Eigen/Dense>

#include <cholmod.h>

#include <limits>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

// Returns the number of entries of the lower triangle of a symmetric matrix of 3x3 blocks with one in each diagonal position.
constexpr std::size_t number_of_entries_of_lower_triangle(const std::size_t number_of_rows, const std::size_t number_of_blocks)
{ return 9 * ((number_of_blocks - number_of_rows) / 2) + 6 * number_of_rows; }

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationSolvers

Supernodal Cholesky factorization by CHOLMOD \cgalCite{cgal:cdhr-cholmod-08} (SuiteSparse), in double precision. The
unknowns are ordered and the pattern analyzed once; each Newton step refactorizes. The solution is exact to rounding.
For \f$n\f$ vertices of the mesh of a volume, a factorization takes time in \f$O(n^2)\f$ and memory in \f$O(n^{4/3})\f$ with
nested dissection, which needs METIS.

Other headers of this package do not include this header. If CHOLMOD is available, the target
`CGAL::Volume_mesh_parameterization` defines the macro `CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD`.

Small supernodes want a single BLAS thread: with OpenBLAS, set `OPENBLAS_NUM_THREADS=1`.

\cgalModels{NewtonSolverTraits_3}
*/
// Eigen's wrapper of CHOLMOD would be slower by nothing, but ends the program if memory does not suffice to analyze the pattern.
class CHOLMOD_solver_traits_3
{
public:
  using NT = double;                        ///< the number type
  using Matrix = Block_sparse_matrix_3<NT>; ///< the type of the matrix

  /// starts CHOLMOD, with its messages switched off.
  CHOLMOD_solver_traits_3()
  {
    cholmod_start(&m_common);
    m_common.print = 0;
    m_common.supernodal = CHOLMOD_SUPERNODAL;
    m_common.quick_return_if_not_posdef = 1;
  }

  /// makes a solver that shares nothing with the other one: it has to analyze and factorize by itself.
  CHOLMOD_solver_traits_3(const CHOLMOD_solver_traits_3&) : CHOLMOD_solver_traits_3() {}
  CHOLMOD_solver_traits_3& operator=(const CHOLMOD_solver_traits_3&) = delete;

  ~CHOLMOD_solver_traits_3()
  {
    cholmod_free_factor(&m_factor, &m_common);
    cholmod_finish(&m_common);
  }

  /// orders the unknowns and analyzes the pattern of `A`. If memory does not suffice, `factorize()` will fail. It also fails if
  /// the lower triangle of `A` has \f$2^{31}\f$ entries or more, because CHOLMOD counts them in `int`.
  void analyze_pattern(const Matrix& A)
  {
    cholmod_free_factor(&m_factor, &m_common);
    const std::size_t n = static_cast<std::size_t>(A.size()), blocks = n == 0 ? 0 : A.row_end(A.size() - 1);
    if(internal::number_of_entries_of_lower_triangle(n, blocks) > (std::numeric_limits<int>::max)())
      return;
    set_matrix(A);
    cholmod_sparse view = matrix_view();
    m_factor = cholmod_analyze(&view, &m_common);
  }

  /// factorizes `A`.
  ///
  /// \return `SUCCESS`, `NOT_POSITIVE_DEFINITE`, `OUT_OF_MEMORY` or `FAILED`
  Linear_solver_status factorize(const Matrix& A)
  {
    if(A.size() == 0) // CHOLMOD fails for empty matrices
      return Linear_solver_status::SUCCESS;
    if(m_factor == nullptr)
      return Linear_solver_status::OUT_OF_MEMORY;
    set_matrix(A);
    cholmod_sparse view = matrix_view();
    cholmod_factorize(&view, m_factor, &m_common);
    switch(m_common.status)
    {
      case CHOLMOD_OK: return Linear_solver_status::SUCCESS;
      case CHOLMOD_NOT_POSDEF: return Linear_solver_status::NOT_POSITIVE_DEFINITE;
      case CHOLMOD_OUT_OF_MEMORY:
      case CHOLMOD_TOO_LARGE: return Linear_solver_status::OUT_OF_MEMORY;
      default: return Linear_solver_status::FAILED;
    }
  }

  /// solves \f$A x = b\f$ with the last factorization; the tolerance is not needed.
  ///
  /// \return `SUCCESS`, `OUT_OF_MEMORY`, or `FAILED` if the solution is not finite
  template <typename Vector>
  Linear_solver_status solve(const std::decay_t<Vector>& b, Vector& x, const double /* tolerance */)
  {
    if(b.size() == 0)
    {
      x = b;
      return Linear_solver_status::SUCCESS;
    }
    cholmod_dense right = {};
    right.nrow = right.nzmax = right.d = static_cast<std::size_t>(b.size());
    right.ncol = 1;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, m_factor, &right, &m_common);
    if(solution == nullptr)
      return Linear_solver_status::OUT_OF_MEMORY;
    x = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(solution->x), b.size());
    cholmod_free_dense(&solution, &m_common);
    return x.allFinite() ? Linear_solver_status::SUCCESS : Linear_solver_status::FAILED;
  }

private:
  // Copies the lower triangle by scalar columns; the matrix is symmetric.
  void set_matrix(const Matrix& A)
  {
    m_column_begin.assign(1, 0);
    m_rows.clear();
    m_values.clear();
    for(int v = 0; v < A.size(); ++v)
      for(int component = 0; component < 3; ++component)
      {
        for(int k = A.row_begin(v); k < A.row_end(v); ++k)
          for(int i = 0; i < 3; ++i)
            if(const int row = 3 * A.column(k) + i; row >= 3 * v + component)
            {
              m_rows.push_back(row);
              m_values.push_back(A.block(k)(component, i));
            }
        m_column_begin.push_back(static_cast<int>(m_rows.size()));
      }
  }

  cholmod_sparse matrix_view()
  {
    cholmod_sparse result = {};
    result.nrow = result.ncol = m_column_begin.size() - 1;
    result.nzmax = m_rows.size();
    result.p = m_column_begin.data();
    result.i = m_rows.data();
    result.x = m_values.data();
    result.stype = -1; // the lower triangle
    result.itype = CHOLMOD_INT;
    result.xtype = CHOLMOD_REAL;
    result.dtype = CHOLMOD_DOUBLE;
    result.sorted = 1;
    result.packed = 1;
    return result;
  }

  cholmod_common m_common;
  cholmod_factor* m_factor = nullptr;
  std::vector<int> m_column_begin, m_rows;
  std::vector<double> m_values;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_CHOLMOD_SOLVER_TRAITS_3_H
