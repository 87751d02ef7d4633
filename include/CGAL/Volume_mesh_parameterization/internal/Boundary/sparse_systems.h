// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPARSE_SYSTEMS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPARSE_SYSTEMS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Dynamic_matrix.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#include <memory>

namespace CGAL::Volume_mesh_parameterization::internal {

// The seam to the sparse solvers of Eigen, whose memory depends on the flags of a unit: nothing of them passes it.

// An entry of a sparse matrix. Entries with one row and one column are added.
struct Sparse_entry
{
  int r, c;
  double x;

  int row() const { return r; }
  int col() const { return c; }
  double value() const { return x; }
};

// Solves systems with symmetric matrices of one pattern.
class Symmetric_sparse_solver
{
public:
  virtual ~Symmetric_sparse_solver() = default;
  virtual void factorize(int size, const std::vector<Sparse_entry>& A) = 0;
  virtual VectorXd solve(const VectorXd& b) const = 0;
};

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::unique_ptr<Symmetric_sparse_solver> make_symmetric_sparse_solver();

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/sparse_systems_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPARSE_SYSTEMS_H
