// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_RIGID_AGGREGATES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_RIGID_AGGREGATES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Solvers/Direct_solver_3.h>

#include <Eigen/Geometry>

namespace CGAL::Volume_mesh_parameterization::internal {

// Corrects residuals of a body that may bend, which block diagonals hardly do: by rigid motions of aggregates of contiguous rows,
// of which the points are known. Their Galerkin matrix, with a row for the translation and one for the rotation of each aggregate,
// is factorized. Aggregates without points, or of small systems, there are none.
class Rigid_aggregates_3
{
public:
  // A copy has none until it analyzes a pattern.
  Rigid_aggregates_3() = default;
  Rigid_aggregates_3(const Rigid_aggregates_3&) {}
  Rigid_aggregates_3& operator=(const Rigid_aggregates_3&)
  {
    m_solver = nullptr;
    return *this;
  }

  bool is_empty() const { return m_solver == nullptr; }

  template <typename NT>
  void analyze_pattern(const Block_sparse_matrix_3<NT>& A)
  {
    constexpr int smallest_number_of_rows = 1000, many_aggregates = 600, largest_size = 1024; // guesses
    m_solver = nullptr;
    if(A.size() < smallest_number_of_rows || A.points().empty())
      return;
    m_size = 64; // a guess; then a power of two, of which ranges of rows are multiples
    while(A.size() / m_size > many_aggregates && m_size < largest_size)
      m_size *= 2;
    const int n = (A.size() + m_size - 1) / m_size;
    std::vector<int> row_begin(1, 0), columns;
    for(int a = 0; a < n; ++a)
    {
      std::vector<int> neighbors;
      for(int k = A.row_begin(a * m_size); k < A.row_begin((std::min)(A.size(), (a + 1) * m_size)); ++k)
        if(const int b = A.column(k) / m_size; neighbors.empty() || neighbors.back() != b)
          neighbors.push_back(b);
      std::sort(neighbors.begin(), neighbors.end());
      neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
      for(int motion = 0; motion < 2; ++motion)
      {
        for(const int b : neighbors)
          columns.insert(columns.end(), { 2 * b, 2 * b + 1 });
        row_begin.push_back(static_cast<int>(columns.size()));
      }
    }
    m_matrix.set_pattern(std::move(row_begin), std::move(columns));
    m_solver = make_direct_solver_3(m_matrix);
    m_residual.resize(6 * n);
    m_correction.resize(6 * n);
  }

  template <typename NT>
  void factorize(const Block_sparse_matrix_3<NT>& A)
  {
    if(is_empty())
      return;
    set_rotations(A);
    for(int row = 0; row < m_matrix.size(); ++row)
      m_matrix.set_zero(row);
    for(int row = 0; row < A.size(); ++row)
    {
      const int a = 2 * (row / m_size);
      int position = m_matrix.row_begin(a);
      for(int k = A.row_begin(row); k < A.row_end(row); ++k)
      {
        const int column = A.column(k), b = 2 * (column / m_size);
        while(m_matrix.column(position) < b)
          ++position;
        const int below = position + m_matrix.row_begin(a + 1) - m_matrix.row_begin(a);
        const Eigen::Matrix3d block = A.block(k).template cast<double>();
        const Eigen::Matrix3d turned = m_rotations[row].transpose() * block;
        m_matrix.block(position) += block;
        m_matrix.block(position + 1) += block * m_rotations[column];
        m_matrix.block(below) += turned;
        m_matrix.block(below + 1) += turned * m_rotations[column];
      }
    }
    for(int row = 0; row < m_matrix.size(); row += 2) // rows on a line determine no rotation about it
    {
      const double stiffness = m_matrix.block(m_matrix.position(row, row)).trace();
      for(const int motion : { row, row + 1 })
        m_matrix.block(m_matrix.position(motion, motion)).diagonal().array() += 1e-6 * stiffness;
    }
    m_is_definite = m_solver->factorize(m_matrix) == Linear_solver_status::SUCCESS;
  }

  // Restricts the residual of the rows from `first` to `last`, which begin and end with an aggregate.
  template <typename Vector>
  void restrict_rows(const Vector& residual, const int first, const int last)
  {
    for(int begin = first; begin < last; begin += m_size)
    {
      Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
      for(int row = begin; row < (std::min)(last, begin + m_size); ++row)
      {
        const Eigen::Vector3d r = residual.template segment<3>(3 * std::size_t(row)).template cast<double>();
        sum.head<3>() += r;
        sum.tail<3>() += m_rotations[row].transpose() * r;
      }
      m_residual.segment<6>(6 * std::size_t(begin / m_size)) = sum;
    }
  }

  // Computes the motions for the restricted residual. A matrix that is not definite gives none.
  void correct()
  {
    if(!m_is_definite || m_solver->solve(m_residual, m_correction) != Linear_solver_status::SUCCESS)
      m_correction.setZero();
  }

  // Returns the correction of a row of the matrix.
  Eigen::Vector3d correction(const int row) const
  {
    const std::size_t first = 6 * std::size_t(row / m_size);
    return m_correction.segment<3>(first) + m_rotations[row] * m_correction.segment<3>(first + 3);
  }

private:
  // The motion of each row by a unit of the three rotations about the center of its aggregate, where lengths are those of that.
  template <typename NT>
  void set_rotations(const Block_sparse_matrix_3<NT>& A)
  {
    m_rotations.resize(A.size());
    for(int first = 0; first < A.size(); first += m_size)
    {
      const int last = (std::min)(A.size(), first + m_size);
      const auto point = [&](const int row) { return Eigen::Vector3d(A.points()[row].data()); };
      Eigen::Vector3d center = Eigen::Vector3d::Zero();
      double squares = 0;
      for(int row = first; row < last; ++row)
        center += point(row) / (last - first);
      for(int row = first; row < last; ++row)
        squares += (point(row) - center).squaredNorm() / (last - first);
      for(int row = first; row < last; ++row)
      {
        const Eigen::Vector3d d = squares > 0 ? Eigen::Vector3d((point(row) - center) / std::sqrt(squares))
                                              : Eigen::Vector3d(Eigen::Vector3d::Zero());
        m_rotations[row] << 0, d[2], -d[1], -d[2], 0, d[0], d[1], -d[0], 0;
      }
    }
  }

  int m_size = 0; // number of rows of an aggregate
  Block_sparse_matrix_3<double> m_matrix;
  std::unique_ptr<Direct_solver_3> m_solver;
  bool m_is_definite = false;
  std::vector<Small_matrix<3, 3> > m_rotations; // of each row
  VectorXd m_residual, m_correction;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_RIGID_AGGREGATES_3_H
