// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_AGGREGATE_HIERARCHY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_AGGREGATE_HIERARCHY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Corrects smooth residuals, which a block diagonal hardly does, on nested aggregates of contiguous rows, over which
// corrections are constant. Eight neighboring aggregates share a dense inverse of their part of the Galerkin matrix, and are
// an aggregate of the next level. The inverses and the next level together precondition two Chebyshev steps, as in algebraic
// multilevel iterations (Axelsson and Vassilevski, Algebraic multilevel preconditioning methods II, SIAM Journal on Numerical
// Analysis 27, 1990); the matrices of all levels together have a twentieth of the blocks. Iterations then hardly grow with
// the number of rows. Small systems get no levels. Single precision suffices, whatever the precision of the system.
class Aggregate_hierarchy_3
{
  using Vector_of_floats = Dynamic_matrix<float, Eigen::Dynamic>;
  using Square_matrix = Dynamic_matrix<double, Eigen::Dynamic, Eigen::Dynamic>;

  static auto at(Vector_of_floats& v, const int i) { return v.segment<3>(3 * std::size_t(i)); }

public:
  static constexpr int rows_per_aggregate = 32; // a guess; rows of the matrix, on the first level

  explicit Aggregate_hierarchy_3(const bool is_parallel) : m_is_parallel(is_parallel) {}

  bool is_empty() const { return m_levels.empty(); }

  template <typename Matrix>
  void analyze_pattern(const Matrix& A)
  {
    constexpr int smallest_number_of_rows = 30000; // below, block diagonals do as well
    constexpr int largest_last_level = 64;         // a guess; rows of the last matrix, which is inverted
    m_levels.clear();
    if(A.size() < smallest_number_of_rows)
      return;
    m_levels.push_back(level_of(A, rows_per_aggregate));
    while(m_levels.back().matrix.size() > largest_last_level)
      m_levels.push_back(level_of(m_levels.back().matrix, aggregates_per_group));
    Level& last = m_levels.back();
    last.aggregates_per_group = last.matrix.size();
  }

  template <typename Matrix>
  void factorize(const Matrix& A)
  {
    for(std::size_t l = 0; l < m_levels.size(); ++l)
    {
      if(l == 0)
        sum_blocks(A, rows_per_aggregate, m_levels[l].matrix);
      else
        sum_blocks(m_levels[l - 1].matrix, aggregates_per_group, m_levels[l].matrix);
      invert_groups(m_levels[l]);
    }
  }

  // Restricts the residual of the rows from `first` to `last`, which begin and end with an aggregate.
  template <typename Vector>
  void restrict_rows(const Vector& residual, const int first, const int last)
  {
    sum_rows(residual, rows_per_aggregate, first / rows_per_aggregate,
             (last + rows_per_aggregate - 1) / rows_per_aggregate, m_levels.front().residual);
  }

  // Computes the corrections for the restricted residual.
  void correct() { correct(0); }

  // Returns the correction of a row of the matrix.
  auto correction(const int row) const
  { return m_levels.front().correction.segment<3>(3 * std::size_t(row / rows_per_aggregate)); }

private:
  static constexpr int aggregates_per_group = 8; // a guess; a group is an aggregate of the next level

  struct Level
  {
    Block_sparse_matrix_3<float> matrix;
    int aggregates_per_group;
    std::vector<Dynamic_matrix<float, Eigen::Dynamic, Eigen::Dynamic> > inverses; // inverses of groups
    Vector_of_floats residual, step, correction;
  };

  // Makes a level, whose matrix has a block for each pair of aggregates between which A has one.
  template <typename Matrix>
  Level level_of(const Matrix& A, const int size) const
  {
    std::vector<std::vector<int> > columns((A.size() + size - 1) / size);
    for_each_range(m_is_parallel, A.size(), size, [&](const std::size_t aggregate, const int first, const int last)
    {
      std::vector<int>& result = columns[aggregate];
      for(int k = A.row_begin(first); k < A.row_begin(last); ++k)
        if(const int column = A.column(k) / size; result.empty() || result.back() != column)
          result.push_back(column);
      std::sort(result.begin(), result.end());
      result.erase(std::unique(result.begin(), result.end()), result.end());
    });
    std::vector<int> row_begin(1, 0), all_columns;
    for(const std::vector<int>& columns_of_row : columns)
    {
      all_columns.insert(all_columns.end(), columns_of_row.begin(), columns_of_row.end());
      row_begin.push_back(static_cast<int>(all_columns.size()));
    }
    Level level;
    level.matrix.set_pattern(std::move(row_begin), std::move(all_columns));
    level.aggregates_per_group = aggregates_per_group;
    for(Vector_of_floats* v : { &level.residual, &level.step, &level.correction })
      *v = Vector_of_floats::Zero(3 * columns.size());
    return level;
  }

  // Computes the Galerkin matrix: each block is the sum of the blocks between two aggregates.
  template <typename Matrix>
  void sum_blocks(const Matrix& A, const int size, Block_sparse_matrix_3<float>& sums) const
  {
    for_each_range(m_is_parallel, A.size(), size, [&](const std::size_t aggregate, const int first, const int last)
    {
      const int begin = sums.row_begin(static_cast<int>(aggregate)), end = sums.row_end(static_cast<int>(aggregate));
      std::vector<Eigen::Matrix3d> blocks(end - begin, Eigen::Matrix3d::Zero()); // in double precision: much of the sums cancels
      for(int row = first; row < last; ++row)
        for(int k = A.row_begin(row), position = begin; k < A.row_end(row); ++k)
        {
          while(sums.column(position) < A.column(k) / size)
            ++position;
          blocks[position - begin] += A.block(k).template cast<double>();
        }
      for(int position = begin; position < end; ++position)
        sums.block(position) = blocks[position - begin].cast<float>();
    });
  }

  // Inverts the parts of the matrix of groups. A group whose part is not positive definite gets no correction.
  void invert_groups(Level& level) const
  {
    constexpr double shift = 1e-6; // a guess; relative to the diagonal, above rounding in single precision
    const Block_sparse_matrix_3<float>& A = level.matrix;
    level.inverses.resize((A.size() + level.aggregates_per_group - 1) / level.aggregates_per_group);
    for_each_range(m_is_parallel, A.size(), level.aggregates_per_group,
                   [&](const std::size_t group, const int first, const int last)
    {
      const int n = 3 * (last - first);
      Square_matrix B = Square_matrix::Zero(n, n);
      for(int row = first; row < last; ++row)
        for(int k = A.row_begin(row); k < A.row_end(row); ++k)
          if(A.column(k) >= first && A.column(k) < last)
            B.block<3, 3>(3 * (row - first), 3 * (A.column(k) - first)) = A.block(k).cast<double>();
      B.diagonal() *= 1 + shift;
      if(!invert_positive_definite(B))
        B.setZero();
      level.inverses[group] = B.cast<float>();
    });
  }

  // Inverts a small matrix by sweeps of one row after the other, and returns whether all pivots are positive. A factorization
  // by Eigen would add some 50 kB of machine code to each header-only unit.
  static bool invert_positive_definite(Square_matrix& B)
  {
    for(Eigen::Index k = 0; k < B.rows(); ++k)
    {
      const double pivot = B(k, k);
      if(!(pivot > 0))
        return false;
      const VectorXd column = B.col(k), scaled = column / pivot;
      B.noalias() -= scaled * column.transpose();
      B.col(k) = scaled;
      B.row(k) = scaled.transpose();
      B(k, k) = -1 / pivot;
    }
    B = -B;
    return true;
  }

  // Makes two Chebyshev steps starting at 0; the last level is solved. A cell has its vertices in four groups at most, so the
  // inverses of groups have eigenvalues up to 4 if all cells are convex, and the next level adds 1.5: the polynomial is
  // positive below `highest + lowest`. (On meshes, the largest eigenvalue is about 3.)
  void correct(const std::size_t l)
  {
    constexpr float lowest = 0.5f, highest = 5, mean = (highest + lowest) / 2, radius = (highest - lowest) / 2;
    constexpr float ratio = mean / radius, factor = 1 / (2 * ratio - 1 / ratio);
    Level& level = m_levels[l];
    set_step(l);
    if(l + 1 == m_levels.size())
    {
      level.correction = level.step;
      return;
    }
    level.correction = level.step / mean;
    for_each_group(level, [&](std::size_t, const int first, const int last)
    {
      for(int i = first; i < last; ++i)
        at(level.residual, i) -= level.matrix.multiply_row(i, level.correction.data());
    });
    set_step(l);
    level.correction = (1 + factor / ratio) * level.correction + (2 * factor / radius) * level.step;
  }

  // Sets the step by the inverses of groups and the next level.
  void set_step(const std::size_t l)
  {
    Level& level = m_levels[l];
    const bool is_last = l + 1 == m_levels.size();
    if(!is_last)
    {
      sum_rows(level.residual, aggregates_per_group, 0, m_levels[l + 1].matrix.size(), m_levels[l + 1].residual);
      correct(l + 1);
    }
    for_each_group(level, [&](const std::size_t group, const int first, const int last)
    {
      const std::size_t n = 3 * std::size_t(last - first);
      level.step.segment(3 * std::size_t(first), n).noalias()
        = level.inverses[group] * level.residual.segment(3 * std::size_t(first), n);
      for(int i = first; i < last && !is_last; ++i)
        at(level.step, i) += at(m_levels[l + 1].correction, static_cast<int>(group));
    });
  }

  template <typename Function>
  void for_each_group(const Level& level, const Function& f) const
  {
    constexpr int smallest_size = 1000; // threads gain nothing with fewer rows
    for_each_range(m_is_parallel && level.matrix.size() >= smallest_size, level.matrix.size(), level.aggregates_per_group, f);
  }

  template <typename Vector>
  static void sum_rows(const Vector& fine, const int size, const int first, const int last, Vector_of_floats& coarse)
  {
    const int n = static_cast<int>(fine.size() / 3);
    for(int i = first; i < last; ++i)
    {
      Eigen::Matrix<typename Vector::Scalar, 3, 1> sum = Eigen::Matrix<typename Vector::Scalar, 3, 1>::Zero();
      for(int row = i * size; row < (std::min)(n, (i + 1) * size); ++row)
        sum += fine.template segment<3>(3 * std::size_t(row));
      at(coarse, i) = sum.template cast<float>();
    }
  }

  bool m_is_parallel;
  std::vector<Level> m_levels; // in the order from fine to coarse
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_AGGREGATE_HIERARCHY_3_H
