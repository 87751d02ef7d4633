// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_CONJUGATE_GRADIENT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_CONJUGATE_GRADIENT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#include <functional>
#include <memory>

namespace CGAL::Volume_mesh_parameterization::internal {

constexpr int default_limit_of_iterations = 2000; // a guess

// Work of `Conjugate_gradient_solver_traits_3`, which is compiled once for each number type.
template <typename NT>
class Conjugate_gradient_3
{
public:
  virtual ~Conjugate_gradient_3() = default;
  virtual std::unique_ptr<Conjugate_gradient_3> copy() const = 0;
  virtual void analyze_pattern(const Block_sparse_matrix_3<NT>& A) = 0;
  virtual void factorize(const Block_sparse_matrix_3<NT>& A) = 0;
  // Solves the system. Asks `may_continue()` every 16 iterations, and ends as at the limit of iterations if the answer is no.
  virtual Linear_solver_status solve(const double* b, double* x, double tolerance,
                                     const std::function<bool()>& may_continue) = 0;
  virtual int number_of_iterations() const = 0;
};

template <typename NT>
std::unique_ptr<Conjugate_gradient_3<NT> > make_conjugate_gradient_3(bool is_parallel, int maximum_number_of_iterations);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Solvers/Conjugate_gradient_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVERS_CONJUGATE_GRADIENT_3_H
