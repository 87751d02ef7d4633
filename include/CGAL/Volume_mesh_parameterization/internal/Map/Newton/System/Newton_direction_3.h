// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_NEWTON_DIRECTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_NEWTON_DIRECTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>

#include <cmath>

namespace CGAL::Volume_mesh_parameterization::internal {

// Solution of a Newton system, and the uses that it has.
struct Newton_direction_3
{
  Linear_solver_status status = Linear_solver_status::FAILED;
  bool is_of_semidefinite_matrix = false;
  Matrix3Xd vectors;  // one column a vertex; zero where the vertex is not unknown
  double gradient_norm = 0;
  double slope = 0;          // the derivative of the energy along the direction; minus the squared Newton decrement
  VectorXd slopes;    // the part of each row of this process
  // about the gain if each unknown moves alone; known if the matrix is not positive definite
  double gain_of_single_vertices = std::numeric_limits<double>::infinity();

  double decrement() const { return std::sqrt((std::max)(0., -slope)); }

  // If negative curvature has truncated the solution, it is usable only of a semi-definite matrix: no matrix with less negative
  // curvature is left to try.
  bool is_usable() const
  {
    return status == Linear_solver_status::SUCCESS || status == Linear_solver_status::ITERATION_LIMIT
        || (status == Linear_solver_status::TRUNCATED && is_of_semidefinite_matrix);
  }

  // Returns whether the slope measures the gain that is left.
  bool is_exact() const { return status == Linear_solver_status::SUCCESS || status == Linear_solver_status::TRUNCATED; }

  // Has the solver failed for another reason than an indefinite matrix?
  bool has_solver_failed() const
  { return status == Linear_solver_status::OUT_OF_MEMORY || status == Linear_solver_status::FAILED; }
};

// A sentence for the user about a direction that ended a computation.
inline const char* describe_failure(const Newton_direction_3& direction)
{
  switch(direction.status)
  {
    case Linear_solver_status::OUT_OF_MEMORY:
      return "There is not enough memory for the factorization. Conjugate_gradient_solver_traits_3 needs far less memory.";
    case Linear_solver_status::NOT_POSITIVE_DEFINITE:
      return "The matrix is not positive definite, because cells are too flat for the precision of the solver.";
    default: return "A number is not finite, or the solver gave up, because cells are too flat for its precision.";
  }
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_NEWTON_DIRECTION_3_H
