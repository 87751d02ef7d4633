// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPARSE_SYSTEMS_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPARSE_SYSTEMS_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/sparse_systems.h>

#include <Eigen/SparseCholesky>

namespace CGAL::Volume_mesh_parameterization::internal {

// The type of the solver keeps the functions apart from those of units with another Eigen.
template <typename Solver>
class Symmetric_sparse_solver_of final : public Symmetric_sparse_solver
{
  using Matrix = Eigen::SparseMatrix<double>;

public:
  void factorize(const int size, const std::vector<Sparse_entry>& A) override
  {
    Matrix matrix(size, size);
    matrix.setFromTriplets(A.begin(), A.end());
    if(m_solver.rows() == 0)
      m_solver.analyzePattern(matrix);
    m_solver.factorize(matrix);
  }

  VectorXd solve(const VectorXd& b) const override { return Eigen::VectorXd(m_solver.solve(b)); }

private:
  Solver m_solver;
};

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::unique_ptr<Symmetric_sparse_solver> make_symmetric_sparse_solver()
{ return std::make_unique<Symmetric_sparse_solver_of<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> > > >(); }

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPARSE_SYSTEMS_IMPL_H
