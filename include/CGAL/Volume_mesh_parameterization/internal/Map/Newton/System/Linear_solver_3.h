// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_LINEAR_SOLVER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_LINEAR_SOLVER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <boost/type_index.hpp>

#include <variant>

namespace CGAL::Volume_mesh_parameterization::internal {

// Which blocks the Hessian has, in compressed rows as in `Block_sparse_matrix_3`.
struct Sparsity_pattern_3
{
  std::vector<int> row_begin, columns;

  int position(const int row, const int column) const
  {
    const auto begin = columns.begin();
    return static_cast<int>(std::lower_bound(begin + row_begin[row], begin + row_begin[row + 1], column) - begin);
  }
};

// The matrix of a Newton system, with the numbers that the solver wants.
using Newton_matrix_3 = std::variant<Block_sparse_matrix_3<float>, Block_sparse_matrix_3<double> >;

// The linear systems of one pattern: owns the matrix, and what its solver has made of the pattern.
class Linear_system_3
{
public:
  virtual ~Linear_system_3() = default;
  virtual Newton_matrix_3& matrix() = 0;
  virtual Linear_solver_status factorize() = 0; // the matrix as it is now
  virtual Linear_solver_status solve(const VectorXd& b, VectorXd& x, double tolerance,
                                     const Budget& budget) = 0;
};

// A linear solver as the engine knows it: the seam between solvers of any type and an engine that is compiled once.
class Linear_solver_3
{
public:
  virtual ~Linear_solver_3() = default;
  virtual std::string name() const = 0;
  // The pattern is that of the rows of this process, if it is not alone.
  virtual std::unique_ptr<Linear_system_3> make_system(Sparsity_pattern_3 pattern, const Communicator_3& communicator) = 0;
  virtual bool does_iterate() const { return false; } // otherwise it factorizes
  virtual std::size_t number_of_iterations() const { return 0; }      // in all systems; 0 if it does not iterate
  virtual std::size_t number_of_own_iterations() const { return number_of_iterations(); } // asks no other process
  virtual std::size_t number_of_cut_solutions() const { return 0; }   // those not as exact as asked for, and not replaced

  std::size_t number_of_replaced_solutions = 0; // cut ones, by those of another solver
};

template <typename Solver, typename Vector>
using Solution_of
  = decltype(std::declval<Solver&>().solve(std::declval<const Vector&>(), std::declval<Vector&>(), 0.));

template <typename Solver, typename Vector>
using Solution_that_asks = decltype(std::declval<Solver&>().solve(
  std::declval<const Vector&>(), std::declval<Vector&>(), 0., std::declval<std::function<bool()> >()));

template <typename Solver>
using Number_of_iterations = decltype(std::declval<const Solver&>().number_of_iterations());

template <typename Solver, typename = void>
struct Is_newton_solver : std::false_type {};

template <typename Solver>
struct Is_newton_solver<Solver, std::enable_if_t<std::is_same<
  decltype(std::declval<Solver&>().analyze_pattern(std::declval<const Block_sparse_matrix_3<typename Solver::NT>&>()),
           std::declval<Solver&>().factorize(std::declval<const Block_sparse_matrix_3<typename Solver::NT>&>())),
  Linear_solver_status>::value> >
  : std::true_type
{};

// A model of `NewtonSolverTraits_3`, as such a solver. It knows one pattern at a time: a system analyzes its own when
// another one has been at work in between.
template <typename Solver>
class Linear_solver_of final : public Linear_solver_3
{
  static_assert(Is_newton_solver<Solver>::value,
                "solver_traits must be a model of NewtonSolverTraits_3, as neither solvers of Eigen nor traits of them are.");

public:
  explicit Linear_solver_of(Solver& solver) : m_solver(solver) {}

  std::string name() const override { return boost::typeindex::type_id<Solver>().pretty_name(); }
  bool does_iterate() const override { return boost::is_detected<Number_of_iterations, Solver>::value; }
  std::size_t number_of_iterations() const override { return m_number_of_iterations; }
  std::size_t number_of_cut_solutions() const override { return m_number_of_cut_solutions - number_of_replaced_solutions; }

  std::unique_ptr<Linear_system_3> make_system(Sparsity_pattern_3 pattern, const Communicator_3&) override
  { return std::make_unique<System>(*this, std::move(pattern)); }

private:
  using Matrix = Block_sparse_matrix_3<typename Solver::NT>;

  class System final : public Linear_system_3
  {
  public:
    System(Linear_solver_of& owner, Sparsity_pattern_3 pattern)
      : m_owner(owner), m_number(++owner.m_number_of_systems), m_matrix(Matrix())
    { std::get<Matrix>(m_matrix).set_pattern(std::move(pattern.row_begin), std::move(pattern.columns)); }

    Newton_matrix_3& matrix() override { return m_matrix; }

    Linear_solver_status factorize() override
    {
      const Matrix& A = std::get<Matrix>(m_matrix);
      if(m_owner.m_analyzed_system != m_number)
        m_owner.m_solver.analyze_pattern(A);
      m_owner.m_analyzed_system = m_number;
      return m_owner.m_solver.factorize(A);
    }

    Linear_solver_status solve(const VectorXd& b, VectorXd& x, const double tolerance,
                               const Budget& budget) override
    {
      const auto solve = [&](const auto& right, auto& solution)
      {
        if constexpr(boost::is_detected<Solution_that_asks, Solver, std::decay_t<decltype(solution)> >::value)
          return m_owner.m_solver.solve(right, solution, tolerance, [&] { return !budget.is_exhausted(); });
        else
          return m_owner.m_solver.solve(right, solution, tolerance);
      };
      Linear_solver_status status;
      if constexpr(boost::is_detected<Solution_of, Solver, VectorXd>::value)
        status = solve(b, x);
      else // of a user, who knows the vectors of Eigen
      {
        Eigen::VectorXd solution;
        status = solve(Eigen::VectorXd(b), solution);
        x = solution;
      }
      if constexpr(boost::is_detected<Number_of_iterations, Solver>::value)
        m_owner.m_number_of_iterations += m_owner.m_solver.number_of_iterations();
      m_owner.m_number_of_cut_solutions += status == Linear_solver_status::ITERATION_LIMIT && !budget.is_exhausted();
      return status;
    }

  private:
    Linear_solver_of& m_owner;
    std::size_t m_number;
    Newton_matrix_3 m_matrix;
  };

  Solver& m_solver;
  std::size_t m_number_of_iterations = 0, m_number_of_cut_solutions = 0;
  std::size_t m_number_of_systems = 0, m_analyzed_system = 0; // systems count from 1
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
// The default solvers are compiled with the engine.
namespace CGAL::Volume_mesh_parameterization {
extern template class internal::Linear_solver_of<Conjugate_gradient_solver_traits_3<Sequential_tag> >;
#  ifdef CGAL_LINKED_WITH_TBB
extern template class internal::Linear_solver_of<Conjugate_gradient_solver_traits_3<Parallel_tag> >;
#  endif
}
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_LINEAR_SOLVER_3_H
