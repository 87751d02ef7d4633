// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_LINEAR_SOLVER_STATUS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_LINEAR_SOLVER_STATUS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationSolvers

What a model of `NewtonSolverTraits_3` answers.
*/
enum class Linear_solver_status
{
  SUCCESS,               ///< the system is solved to the tolerance asked for
  ITERATION_LIMIT,       ///< the result is a descent direction, but not as exact as asked for
  TRUNCATED,             ///< the matrix is not positive definite, but the result is a descent direction
  NOT_POSITIVE_DEFINITE, ///< the matrix is not positive definite; there is no result
  OUT_OF_MEMORY,         ///< the factorization needs more memory than there is
  FAILED                 ///< any other failure of the solver
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_LINEAR_SOLVER_STATUS_H
