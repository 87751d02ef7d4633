// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_CONJUGATE_GRADIENT_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_CONJUGATE_GRADIENT_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Solvers/Aggregate_hierarchy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Solvers/Conjugate_gradient_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Solvers/Rigid_aggregates_3.h>

#include <Eigen/LU>

#include <cmath>

namespace CGAL::Volume_mesh_parameterization::internal {

// One code for one thread and many, hence the same bits, however a compiler contracts products and sums.
template <typename NT>
class Preconditioned_conjugate_gradient_3 final : public Conjugate_gradient_3<NT>
{
public:
  using Matrix = Block_sparse_matrix_3<NT>;

  Preconditioned_conjugate_gradient_3(const bool is_parallel, const int maximum_number_of_iterations)
    : m_is_parallel(is_parallel), m_maximum_number_of_iterations(maximum_number_of_iterations), m_hierarchy(is_parallel)
  {}

  std::unique_ptr<Conjugate_gradient_3<NT> > copy() const override
  { return std::make_unique<Preconditioned_conjugate_gradient_3>(*this); }

  void analyze_pattern(const Matrix& A) override
  {
    const std::size_t n = 3 * std::size_t(A.size());
    for(Vector* v : { &m_solution, &m_residual, &m_preconditioned, &m_direction, &m_product })
      v->resize(n);
    m_inverse_diagonal.resize(9 * std::size_t(A.size()));
    m_partial_sums.resize(number_of_row_ranges());
    m_rigid.analyze_pattern(A);
    m_hierarchy = Aggregate_hierarchy_3(m_is_parallel);
    if(m_rigid.is_empty())
      m_hierarchy.analyze_pattern(A);
  }

  void factorize(const Matrix& A) override
  {
    for_each_in_ranges(m_is_parallel, A.size(), rows_per_range, [&](const int row)
    {
      const Eigen::Matrix3d D = A.block(A.position(row, row)).template cast<double>();
      Eigen::Matrix<NT, 3, 3> inverse = D.inverse().template cast<NT>();
      // the iteration must meet the negative curvature of a block, also of one that is positive but for rounding
      if(!is_positive_definite(D) || !is_positive_definite(inverse.template cast<double>()))
        inverse = Eigen::Matrix<NT, 3, 3>::Identity() * static_cast<NT>(D.norm() > 0 ? 1 / D.norm() : 0);
      inverse_diagonal(row) = inverse;
    });
    m_hierarchy.factorize(A);
    m_rigid.factorize(A);
    m_matrix = &A;
  }

  Linear_solver_status solve(const double* const b, double* const x, const double tolerance,
                             const std::function<bool()>& may_continue) override
  {
    const Eigen::Map<const Eigen::VectorXd> right(b, m_residual.size());
    const double unit = unit_of(right);
    m_number_of_iterations = 0;
    m_solution.setZero();
    m_residual = (right / unit).template cast<NT>();
    double rz = precondition_after([](int, int) {});
    m_direction = m_preconditioned;
    const double target = tolerance * tolerance * rz;
    Linear_solver_status status = rz < 0 ? Linear_solver_status::NOT_POSITIVE_DEFINITE : Linear_solver_status::SUCCESS;

    while(rz > target && m_number_of_iterations < m_maximum_number_of_iterations)
    {
      if(m_number_of_iterations % 16 == 15 && may_continue && !may_continue())
        break;
      const double curvature = multiply();
      if(!(curvature > 0))
      {
        status = (m_number_of_iterations == 0) ? Linear_solver_status::NOT_POSITIVE_DEFINITE
                                               : Linear_solver_status::TRUNCATED;
        break;
      }
      ++m_number_of_iterations;
      const double previous = rz;
      rz = advance(static_cast<NT>(rz / curvature));
      turn(static_cast<NT>(rz / previous));
    }
    Eigen::Map<Eigen::VectorXd>(x, m_solution.size()) = unit * m_solution.template cast<double>();
    if(!std::isfinite(rz))
      return Linear_solver_status::FAILED;
    if(rz < 0 && status == Linear_solver_status::SUCCESS) // the preconditioner has met negative curvature
      return Linear_solver_status::TRUNCATED;
    return status == Linear_solver_status::SUCCESS && rz > target ? Linear_solver_status::ITERATION_LIMIT : status;
  }

  int number_of_iterations() const override { return m_number_of_iterations; }

private:
  using Vector = Dynamic_matrix<NT, Eigen::Dynamic>;

  // Length of ranges of rows, a guess. The length is fixed, and each range has its own partial sum, so that sums have the same
  // bits for any number of threads.
  static constexpr int rows_per_range = 1024; // a guess
  static_assert(rows_per_range % Aggregate_hierarchy_3::rows_per_aggregate == 0);

  // Returns a power of two that is 1 unless squares of the right side, one of displacements by rounding only, would underflow.
  static double unit_of(const Eigen::Map<const Eigen::VectorXd>& right)
  {
    constexpr double small = 1e-10; // a guess
    const double largest = right.size() == 0 ? 0 : right.lpNorm<Eigen::Infinity>();
    return largest > 0 && largest < small ? std::ldexp(1., std::ilogb(largest)) : 1;
  }

  std::size_t number_of_row_ranges() const { return (m_inverse_diagonal.size() / 9 + rows_per_range - 1) / rows_per_range; }

  // Calls f(first_row, last_row), and returns the sum of its results.
  template <typename Function>
  double sum_over_row_ranges(const Function& f)
  {
    for_each_range(m_is_parallel, static_cast<int>(m_inverse_diagonal.size() / 9), rows_per_range,
                   [&](const std::size_t i, const int first, const int last) { m_partial_sums[i] = f(first, last); });
    double sum = 0;
    for(const double s : m_partial_sums)
      sum += s;
    return sum;
  }

  // Returns by Sylvester's criterion whether D is positive definite.
  static bool is_positive_definite(const Eigen::Matrix3d& D)
  { return D(0, 0) > 0 && D(0, 0) * D(1, 1) > D(0, 1) * D(1, 0) && D.determinant() > 0; }

  auto inverse_diagonal(const int row)
  { return Eigen::Map<Eigen::Matrix<NT, 3, 3> >(m_inverse_diagonal.data() + 9 * std::size_t(row)); }

  static auto range(Vector& v, const int first, const int last)
  { return v.segment(3 * std::size_t(first), 3 * std::size_t(last - first)); }

  static double dot(Vector& a, Vector& b, const int first, const int last)
  { return static_cast<double>(range(a, first, last).dot(range(b, first, last))); }

  // Sets z = M^{-1} r on a range, and returns its part of r.z.
  double precondition(const int first, const int last)
  {
    for(int row = first; row < last; ++row)
    {
      auto z = m_preconditioned.template segment<3>(3 * std::size_t(row));
      z.noalias() = inverse_diagonal(row) * m_residual.template segment<3>(3 * std::size_t(row));
      if(!m_hierarchy.is_empty())
        z += m_hierarchy.correction(row).template cast<NT>();
      else if(!m_rigid.is_empty())
        z += m_rigid.correction(row).template cast<NT>();
    }
    return dot(m_residual, m_preconditioned, first, last);
  }

  // Calls f(first_row, last_row), which may change r, sets z = M^{-1} r, and returns r.z.
  template <typename Function>
  double precondition_after(const Function& f)
  {
    if(m_hierarchy.is_empty() && m_rigid.is_empty())
      return sum_over_row_ranges([&](const int first, const int last)
      {
        f(first, last);
        return precondition(first, last);
      });
    sum_over_row_ranges([&](const int first, const int last)
    {
      f(first, last);
      m_rigid.is_empty() ? m_hierarchy.restrict_rows(m_residual, first, last) : m_rigid.restrict_rows(m_residual, first, last);
      return 0.;
    });
    m_rigid.is_empty() ? m_hierarchy.correct() : m_rigid.correct();
    return sum_over_row_ranges([&](const int first, const int last) { return precondition(first, last); });
  }

  // Sets q = A p, and returns p.q.
  double multiply()
  {
    return sum_over_row_ranges([&](const int first, const int last)
    {
      for(int row = first; row < last; ++row)
        m_product.template segment<3>(3 * std::size_t(row)) = m_matrix->multiply_row(row, m_direction.data());
      return dot(m_direction, m_product, first, last);
    });
  }

  // Sets x += step p, r -= step q, z = M^{-1} r, and returns r.z.
  double advance(const NT step)
  {
    return precondition_after([&](const int first, const int last)
    {
      range(m_solution, first, last) += step * range(m_direction, first, last);
      range(m_residual, first, last) -= step * range(m_product, first, last);
    });
  }

  // Sets p = z + ratio p.
  void turn(const NT ratio)
  {
    sum_over_row_ranges([&](const int first, const int last)
    {
      range(m_direction, first, last) = range(m_preconditioned, first, last) + ratio * range(m_direction, first, last);
      return 0.;
    });
  }

  bool m_is_parallel;
  int m_maximum_number_of_iterations;
  int m_number_of_iterations = 0;
  const Matrix* m_matrix = nullptr;
  std::vector<NT> m_inverse_diagonal;
  Vector m_solution, m_residual, m_preconditioned, m_direction, m_product;
  std::vector<double> m_partial_sums;
  Aggregate_hierarchy_3 m_hierarchy; // without levels and aggregates, the preconditioner is block Jacobi
  Rigid_aggregates_3 m_rigid;        // in place of these, of a body that may bend
};

template <typename NT>
std::unique_ptr<Conjugate_gradient_3<NT> > make_conjugate_gradient_3(const bool is_parallel,
                                                                     const int maximum_number_of_iterations)
{ return std::make_unique<Preconditioned_conjugate_gradient_3<NT> >(is_parallel, maximum_number_of_iterations); }

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_CONJUGATE_GRADIENT_3_IMPL_H
