// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_DIRECT_SOLVER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_DIRECT_SOLVER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#include <memory>

namespace CGAL::Volume_mesh_parameterization::internal {

// Cholesky factorization of matrices of one pattern, by a sparse solver of Eigen: nothing of it passes this seam, as its
// memory depends on the flags of a unit.
class Direct_solver_3
{
public:
  virtual ~Direct_solver_3() = default;
  virtual double cost() const = 0; // of a factorization, in multiplications
  virtual Linear_solver_status factorize(const Block_sparse_matrix_3<double>& A) = 0;
  virtual Linear_solver_status solve(const VectorXd& b, VectorXd& x) = 0;
};

// Analyzes the pattern of a matrix; its values are not read.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
std::unique_ptr<Direct_solver_3> make_direct_solver_3(const Block_sparse_matrix_3<double>& pattern);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Solvers/Direct_solver_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_DIRECT_SOLVER_3_H
