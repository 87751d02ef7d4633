// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_DIRECT_SYSTEM_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_DIRECT_SYSTEM_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Solvers/Direct_solver_3.h>

#include <optional>

namespace CGAL::Volume_mesh_parameterization::internal {

// Systems that are factorized because iterations converge too slowly.
class Direct_system_3 final : public Linear_system_3
{
public:
  template <typename NT>
  explicit Direct_system_3(const Block_sparse_matrix_3<NT>& pattern)
    : m_matrix(with_pattern_of(pattern)), m_solver(make_direct_solver_3(doubles()))
  {}

  double cost() const { return m_solver->cost(); }
  Newton_matrix_3& matrix() override { return m_matrix; }
  Linear_solver_status factorize() override { return m_solver->factorize(doubles()); }
  Linear_solver_status solve(const VectorXd& b, VectorXd& x, double, const Budget&) override { return m_solver->solve(b, x); }

private:
  using Matrix = Block_sparse_matrix_3<double>;

  const Matrix& doubles() const { return std::get<Matrix>(m_matrix); }

  template <typename NT>
  static Matrix with_pattern_of(const Block_sparse_matrix_3<NT>& other)
  {
    std::vector<int> row_begin(1, 0), columns;
    for(int row = 0; row < other.size(); ++row)
    {
      for(int k = other.row_begin(row); k < other.row_end(row); ++k)
        columns.push_back(other.column(k));
      row_begin.push_back(other.row_end(row));
    }
    Matrix result;
    result.set_pattern(std::move(row_begin), std::move(columns));
    return result;
  }

  Newton_matrix_3 m_matrix;
  std::unique_ptr<Direct_solver_3> m_solver;
};

// Decides which systems of one pattern are factorized. After an inexact solution, the system is factorized if this takes no more
// multiplications than the iterations. So are the next systems, twice as many as the last time; then the solver has its turn.
class Direct_turns_3
{
public:
  bool is_direct() const { return m_turns > 0; }

  Linear_system_3& begin_turn()
  {
    --m_turns;
    return *m_system;
  }

  // Counts a turn of the solver, and returns whether its system is to be factorized, too.
  bool takes_over(const Newton_matrix_3& matrix, const bool is_inexact, const std::size_t number_of_iterations)
  {
    constexpr double cost_of_entries = 3; // in multiplications of an iteration, which takes contiguous ones; measured
    constexpr int many_rows = 100000;     // a guess: with more, even the analysis is dear
    const double number_of_entries = std::visit([&](const auto& A)
    {
      if(is_inexact && !m_system && A.size() <= many_rows)
        m_system.emplace(A);
      return 9. * A.row_end(A.size() - 1);
    }, matrix);
    if(!m_system)
      return false;
    const bool is_slow
      = m_system->cost() * (is_inexact ? 1 : cost_of_entries) <= number_of_entries * static_cast<double>(number_of_iterations);
    m_turns = m_last_turns = is_slow ? 2 * m_last_turns + 1 : 0;
    return is_inexact && is_slow;
  }

private:
  std::optional<Direct_system_3> m_system;
  int m_turns = 0, m_last_turns = 0;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_DIRECT_SYSTEM_3_H
