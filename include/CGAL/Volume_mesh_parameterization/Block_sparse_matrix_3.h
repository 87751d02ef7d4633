// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BLOCK_SPARSE_MATRIX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BLOCK_SPARSE_MATRIX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationSolvers

A symmetric sparse matrix of 3x3 blocks: the Hessian of an energy, one block row a free vertex and
one block for each pair of vertices that share a cell. Both triangles are stored, in compressed rows;
blocks are stored by columns, and the columns of each row are sorted.

\tparam NT_ the number type, `float` or `double`
*/
template <typename NT_>
class Block_sparse_matrix_3
{
public:
  using NT = NT_;
  using Block = Eigen::Map<Eigen::Matrix<NT, 3, 3> >;
  using Const_block = Eigen::Map<const Eigen::Matrix<NT, 3, 3> >;

  /// sets the sparsity pattern: `row_begin` has one entry more than there are rows. All values become 0.
  void set_pattern(std::vector<int> row_begin, std::vector<int> columns)
  {
    m_row_begin = std::move(row_begin);
    m_columns = std::move(columns);
    // one number more: a product reads its 3-vectors as 4-vectors
    m_values.assign(9 * m_columns.size() + 1, NT(0));
  }

  /// number of block rows
  int size() const { return static_cast<int>(m_row_begin.size()) - 1; }

  int row_begin(const int row) const { return m_row_begin[row]; }
  int row_end(const int row) const { return m_row_begin[row + 1]; }
  int column(const int position) const { return m_columns[position]; }

  Block block(const int position) { return Block(values(position)); }
  Const_block block(const int position) const { return Const_block(values(position)); }
  NT* values(const int position) { return m_values.data() + 9 * std::size_t(position); }
  const NT* values(const int position) const { return m_values.data() + 9 * std::size_t(position); }

  /// position of the block in `row` and `column`, which must be part of the pattern
  int position(const int row, const int column) const
  {
    const auto begin = m_columns.begin();
    return static_cast<int>(std::lower_bound(begin + row_begin(row), begin + row_end(row), column) - begin);
  }

  void set_zero() { std::fill(m_values.begin(), m_values.end(), NT(0)); }

  /// makes the matrix symmetric by copying the upper triangle to the lower one
  void copy_upper_to_lower_triangle()
  {
    // rows are met in the order of the columns of the lower triangle
    std::vector<int> next(m_row_begin.begin(), m_row_begin.end() - 1);
    for(int row = 0; row < size(); ++row)
      for(int k = next[row] + 1; k < row_end(row); ++k)
        block(next[column(k)]++) = block(k).transpose();
  }

  /// adds `factor` times itself to each diagonal block
  void scale_diagonal(const NT factor)
  {
    for(int row = 0; row < size(); ++row)
      block(position(row, row)) *= NT(1) + factor;
  }

  /// computes three entries of the product with the vector `x`, those of `row`
  Eigen::Matrix<NT, 3, 1> multiply_row(const int row, const NT* x) const
  {
    using Four = Eigen::Array<NT, 4, 1>; // the fourth entry belongs to the next column and is dropped
    Four sum = Four::Zero();
    for(int k = row_begin(row); k < row_end(row); ++k)
    {
      const NT* a = values(k);
      const NT* y = x + 3 * std::size_t(column(k));
      sum += Eigen::Map<const Four>(a) * y[0]
           + Eigen::Map<const Four>(a + 3) * y[1]
           + Eigen::Map<const Four>(a + 6) * y[2];
    }
    return sum.template head<3>().matrix();
  }

private:
  std::vector<int> m_row_begin;
  std::vector<int> m_columns;
  std::vector<NT> m_values;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BLOCK_SPARSE_MATRIX_3_H
