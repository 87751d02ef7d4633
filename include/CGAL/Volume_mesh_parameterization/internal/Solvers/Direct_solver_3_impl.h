// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_DIRECT_SOLVER_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_DIRECT_SOLVER_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Eigen_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Solvers/Direct_solver_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Eigen's solver, which knows where each column of the factor begins before it computes the factor.
class Simplicial_solver : public Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> >
{
public:
  double cost() const
  {
    const Eigen::Index n = m_matrix.cols();
    const Eigen::VectorXd begins = Eigen::Map<const Eigen::VectorXi>(m_matrix.outerIndexPtr(), n + 1).cast<double>();
    return (begins.tail(n) - begins.head(n)).squaredNorm() / 2;
  }
};

// The type of the solver keeps the functions apart from those of units with another Eigen.
template <typename Solver>
class Direct_solver_of final : public Direct_solver_3
{
public:
  explicit Direct_solver_of(const Block_sparse_matrix_3<double>& pattern)
  {
    m_traits.analyze_pattern(pattern);
    m_cost = m_traits.solver().cost();
  }

  double cost() const override { return m_cost; }
  Linear_solver_status factorize(const Block_sparse_matrix_3<double>& A) override { return m_traits.factorize(A); }

  Linear_solver_status solve(const VectorXd& b, VectorXd& x) override
  {
    Eigen::VectorXd solution;
    const Linear_solver_status status = m_traits.solve(Eigen::VectorXd(b), solution, 0.);
    x = solution;
    return status;
  }

private:
  Eigen_solver_traits_3<Solver> m_traits;
  double m_cost;
};

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
std::unique_ptr<Direct_solver_3> make_direct_solver_3(const Block_sparse_matrix_3<double>& pattern)
{ return std::make_unique<Direct_solver_of<Simplicial_solver> >(pattern); }

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_DIRECT_SOLVER_3_IMPL_H
