// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_LINEAR_SOLVER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_LINEAR_SOLVER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/Linear_solver_status.h>

#include <Eigen/Core>

#include <boost/type_index.hpp>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL::Volume_mesh_parameterization::internal {

// The matrix of a Newton system, with the numbers that the solver wants.
using Newton_matrix_3 = std::variant<Block_sparse_matrix_3<float>, Block_sparse_matrix_3<double> >;

// A linear solver as the engine knows it: the seam between solvers of any type and an engine that is compiled once.
class Linear_solver_3
{
public:
  virtual ~Linear_solver_3() = default;
  virtual std::string name() const = 0;
  virtual Newton_matrix_3 make_matrix() const = 0;
  virtual void analyze_pattern(const Newton_matrix_3& A) = 0;
  virtual Linear_solver_status factorize(const Newton_matrix_3& A) = 0;
  virtual Linear_solver_status solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, double tolerance) = 0;
  virtual Linear_solver_3& for_patches() { return *this; } // for systems of a single process
  virtual std::size_t number_of_iterations() const { return 0; } // in all calls of `solve()`; 0 if it does not iterate
};

template <typename Solver, typename = void>
struct Counts_iterations : std::false_type {};

template <typename Solver>
struct Counts_iterations<Solver, std::void_t<decltype(std::declval<const Solver&>().number_of_iterations())> >
  : std::true_type {};

// A model of `NewtonSolverTraits_3`, as such a solver.
template <typename Solver>
class Linear_solver_of final : public Linear_solver_3
{
public:
  explicit Linear_solver_of(Solver& solver) : m_solver(solver) {}

  std::string name() const override { return boost::typeindex::type_id<Solver>().pretty_name(); }
  Newton_matrix_3 make_matrix() const override { return Matrix(); }
  void analyze_pattern(const Newton_matrix_3& A) override { m_solver.analyze_pattern(std::get<Matrix>(A)); }
  Linear_solver_status factorize(const Newton_matrix_3& A) override { return m_solver.factorize(std::get<Matrix>(A)); }

  Linear_solver_status solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, const double tolerance) override
  {
    const Linear_solver_status status = m_solver.solve(b, x, tolerance);
    if constexpr(Counts_iterations<Solver>::value)
      m_number_of_iterations += m_solver.number_of_iterations();
    return status;
  }

  std::size_t number_of_iterations() const override { return m_number_of_iterations; }

private:
  using Matrix = Block_sparse_matrix_3<typename Solver::NT>;

  Solver& m_solver;
  std::size_t m_number_of_iterations = 0;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SYSTEM_LINEAR_SOLVER_3_H
