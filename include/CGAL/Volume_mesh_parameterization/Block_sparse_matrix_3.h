// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BLOCK_SPARSE_MATRIX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BLOCK_SPARSE_MATRIX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Dynamic_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationSolvers

Answer of a model of `NewtonSolverTraits_3`.
*/
enum class Linear_solver_status
{
  SUCCESS,               ///< the system is solved to the tolerance asked for
  ITERATION_LIMIT,       ///< the result is a descent direction, but not as exact as asked for
  TRUNCATED,             ///< the matrix is not positive definite, but the result is a descent direction
  NOT_POSITIVE_DEFINITE, ///< the matrix is not positive definite; there is no result
  OUT_OF_MEMORY,         ///< the factorization needs more memory than there is
  FAILED                 ///< any other failure of the solver
};

/*!
\ingroup PkgVolumeMeshParameterizationSolvers

A symmetric sparse matrix of 3x3 blocks, such as the Hessian of an energy. It has one block row for each free vertex, and one
block for each pair of vertices in a cell or a linear constraint. Both triangles are stored, in compressed rows; blocks are
stored by columns, and the columns of each row are sorted.

Rows and columns count blocks, from 0. A position is the index of a block in the order of storage, also from 0. The blocks of a
row have the positions from `row_begin(row)` to `row_end(row) - 1`. Memory: nine numbers and an index a block.

\tparam NT_ the number type, `float` or `double`

\sa `NewtonSolverTraits_3`
*/
template <typename NT_>
class Block_sparse_matrix_3
{
public:
  using NT = NT_; ///< the number type
  /// a block that can be changed
  using Block = Eigen::Map<Eigen::Matrix<NT, 3, 3> >;
  /// a block that cannot be changed
  using Const_block = Eigen::Map<const Eigen::Matrix<NT, 3, 3> >;

  /// sets the sparsity pattern. The values are yet to be set, row by row.
  ///
  /// \param row_begin the position of the first block of each row, and the number of blocks: one entry more than
  ///        there are rows
  /// \param columns the column of each block, in increasing order in each row, and each row with its diagonal block
  void set_pattern(std::vector<int> row_begin, std::vector<int> columns)
  {
    m_row_begin = std::move(row_begin);
    m_columns = std::move(columns);
    // values are not written here, so that threads which share the rows share the system's work of clearing pages, too;
    // one number more: a product reads its 3-vectors as 4-vectors
    m_values.resize(9 * m_columns.size() + 1);
    m_values[m_values.size() - 1] = NT(0);
  }

  /// sets a point of each row: the image of its vertex. A preconditioner may use it, for a body that may bend.
  void set_points(std::vector<std::array<double, 3> > points) { m_points = std::move(points); }

  /// returns the points of the rows; none if the boundary is not free.
  const std::vector<std::array<double, 3> >& points() const { return m_points; }

  /// returns the number of rows of blocks, a third of the number of unknowns.
  int size() const { return static_cast<int>(m_row_begin.size()) - 1; }

  /// returns the position of the first block of a row.
  int row_begin(const int row) const { return m_row_begin[row]; }
  /// returns the position after the last block of a row.
  int row_end(const int row) const { return m_row_begin[row + 1]; }
  /// returns the column of a block.
  int column(const int position) const { return m_columns[position]; }

  /// returns a block.
  Block block(const int position) { return Block(values(position)); }
  /// returns a block.
  Const_block block(const int position) const { return Const_block(values(position)); }
  /// returns the nine numbers of a block, by columns.
  NT* values(const int position) { return m_values.data() + 9 * std::size_t(position); }
  /// returns the nine numbers of a block, by columns.
  const NT* values(const int position) const { return m_values.data() + 9 * std::size_t(position); }

  /// returns the position of the block in `row` and `column`, by binary search.
  /// \pre The block is part of the pattern.
  int position(const int row, const int column) const
  {
    const auto begin = m_columns.begin();
    return static_cast<int>(std::lower_bound(begin + row_begin(row), begin + row_end(row), column) - begin);
  }

  /// sets the values of a row to 0.
  void set_zero(const int row) { std::fill(values(row_begin(row)), values(row_end(row)), NT(0)); }

  /// copies the upper triangle to the part of a row in the lower triangle. Then the matrix is symmetric.
  void complete_row(const int row)
  {
    for(int k = row_begin(row); column(k) < row; ++k)
      block(k) = block(position(column(k), row)).transpose();
  }

  /// adds `factor` times itself to each diagonal block.
  void scale_diagonal(const NT factor)
  {
    for(int row = 0; row < size(); ++row)
      block(position(row, row)) *= NT(1) + factor;
  }

  /// returns the three entries of the product with the vector `x` that belong to `row`. The vector has three entries
  /// a row of blocks.
  Eigen::Matrix<NT, 3, 1> multiply_row(const int row, const NT* x) const
  {
    using Four = Eigen::Array<NT, 4, 1, Eigen::DontAlign>; // the fourth entry belongs to the next column and is dropped
    Four sum = Four::Zero();
    for(int k = row_begin(row); k < row_end(row); ++k)
    {
      const NT* a = values(k);
      const NT* y = x + 3 * std::size_t(column(k));
      sum += Eigen::Map<const Four>(a) * y[0] + Eigen::Map<const Four>(a + 3) * y[1] + Eigen::Map<const Four>(a + 6) * y[2];
    }
    return sum.template head<3>().matrix();
  }

private:
  std::vector<int> m_row_begin;
  std::vector<int> m_columns;
  std::vector<std::array<double, 3> > m_points;
  internal::Dynamic_matrix<NT, Eigen::Dynamic> m_values;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BLOCK_SPARSE_MATRIX_3_H
