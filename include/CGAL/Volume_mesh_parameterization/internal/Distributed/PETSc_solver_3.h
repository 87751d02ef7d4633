// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_PETSC_SOLVER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_PETSC_SOLVER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Distributed/Distributed_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>

#include <petscksp.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Solves Newton systems of which each process has its own rows, and copies of those of its halo behind them. By default
// conjugate gradients that stop where the curvature is negative, with the inverses of the diagonal blocks, as
// `Conjugate_gradient_solver_traits_3`; the options database may choose others.
class PETSc_solver_3 final : public Linear_solver_3
{
public:
  PETSc_solver_3(const MPI_communicator_3& communicator, const Distributed_mesh_3& mesh)
    : m_communicator(communicator), m_mesh(mesh)
  {
    constexpr int maximum_number_of_iterations = 2000; // a guess; users may pass -ksp_max_it
    communicator.synchronize();
    const PetscInt n = number_of_own_rows();
    const std::vector<PetscInt>& rows = mesh.global_rows();
    check(VecCreateGhostBlock(communicator.get(), 3, 3 * n, PETSC_DETERMINE, static_cast<PetscInt>(rows.size()) - n,
                              rows.data() + n, &m_x));
    check(VecDuplicate(m_x, &m_b));
    check(KSPCreate(communicator.get(), &m_ksp));
    check(KSPSetType(m_ksp, KSPSTCG));
    check(KSPCGSetRadius(m_ksp, 0)); // no trust region
    check(KSPSetNormType(m_ksp, KSP_NORM_NATURAL));
    check(KSPSetTolerances(m_ksp, PETSC_DEFAULT, 0, PETSC_DEFAULT, maximum_number_of_iterations));
    PC preconditioner;
    check(KSPGetPC(m_ksp, &preconditioner));
    check(PCSetType(preconditioner, PCPBJACOBI));
    check(KSPSetFromOptions(m_ksp));
    check(PCGAMGSetUseSAEstEig(preconditioner, PETSC_FALSE)); // the eigenvalues of the first matrix do not fit later ones
    PetscBool has_blocks;
    check(PetscObjectTypeCompareAny(reinterpret_cast<PetscObject>(preconditioner), &has_blocks,
                                    PCPBJACOBI, PCBJACOBI, PCJACOBI, PCNONE, ""));
    check(MatCreate(communicator.get(), &m_matrix));
    check(MatSetSizes(m_matrix, 3 * n, 3 * n, PETSC_DETERMINE, PETSC_DETERMINE));
    check(MatSetBlockSize(m_matrix, 3)); // for algebraic multigrid, the three translations as near-null space
    check(MatSetType(m_matrix, has_blocks ? MATBAIJ : MATAIJ));
    check(KSPSetOperators(m_ksp, m_matrix, m_matrix));
  }

  PETSc_solver_3(const PETSc_solver_3&) = delete;
  PETSc_solver_3& operator=(const PETSc_solver_3&) = delete;

  ~PETSc_solver_3() override
  {
    KSPDestroy(&m_ksp);
    MatDestroy(&m_matrix);
    VecDestroy(&m_x);
    VecDestroy(&m_b);
  }

  std::string name() const override
  {
    KSPType solver;
    PC preconditioner;
    PCType type;
    check(KSPGetType(m_ksp, &solver));
    check(KSPGetPC(m_ksp, &preconditioner));
    check(PCGetType(preconditioner, &type));
    return std::string("PETSc, -ksp_type ") + solver + " -pc_type " + type;
  }

  // Makes a system: one of this process alone for a patch of the mesh.
  std::unique_ptr<Linear_system_3> make_system(Sparsity_pattern_3 pattern, const Communicator_3& communicator) override
  {
    if(&communicator != &m_communicator)
      return m_solver_for_patches.make_system(std::move(pattern), communicator);
    return std::make_unique<System>(*this, std::move(pattern));
  }

  // Returns the number of iterations, including those for patches of all processes.
  std::size_t number_of_iterations() const override
  {
    PetscInt result;
    check(KSPGetTotalIterations(m_ksp, &result));
    return static_cast<std::size_t>(result + m_communicator.sum(static_cast<double>(m_solver_for_patches.number_of_iterations())));
  }

  std::size_t number_of_own_iterations() const override { return m_solver_for_patches.number_of_iterations(); }

  std::size_t number_of_cut_solutions() const override
  {
    const std::size_t of_patches = m_solver_for_patches.number_of_cut_solutions() - number_of_replaced_solutions;
    return m_number_of_cut_solutions + static_cast<std::size_t>(m_communicator.sum(static_cast<double>(of_patches)));
  }

private:
  using Matrix = Block_sparse_matrix_3<float>;
  using Default_solver = Conjugate_gradient_solver_traits_3<Sequential_tag>; // for one process

  class System final : public Linear_system_3
  {
  public:
    System(PETSc_solver_3& solver, Sparsity_pattern_3 pattern) : m_solver(solver), m_matrix(Matrix())
    {
      Matrix& matrix = std::get<Matrix>(m_matrix);
      matrix.set_pattern(std::move(pattern.row_begin), std::move(pattern.columns));
      solver.analyze_pattern(matrix);
    }

    Newton_matrix_3& matrix() override { return m_matrix; }
    Linear_solver_status factorize() override { return m_solver.factorize(std::get<Matrix>(m_matrix)); }

    Linear_solver_status solve(const VectorXd& b, VectorXd& x, const double tolerance,
                               const Budget&) override // processes may see different budgets
    { return m_solver.solve(b, x, tolerance); }

  private:
    PETSc_solver_3& m_solver;
    Newton_matrix_3 m_matrix;
  };

  void analyze_pattern(const Matrix& matrix)
  {
    const PetscInt n = number_of_own_rows();
    std::vector<PetscInt> own_columns(n), other_columns(n);
    int longest = 0;
    for(PetscInt row = 0; row < n; ++row)
    {
      for(int k = matrix.row_begin(row); k < matrix.row_end(row); ++k)
        ++(matrix.column(k) < n ? own_columns : other_columns)[row];
      longest = (std::max)(longest, matrix.row_end(row) - matrix.row_begin(row));
    }
    m_columns.resize(longest);
    m_values.resize(9 * longest);
    m_communicator.synchronize();
    check(MatXAIJSetPreallocation(m_matrix, 3, own_columns.data(), other_columns.data(), nullptr, nullptr));
    check(MatSetOption(m_matrix, MAT_ROW_ORIENTED, PETSC_FALSE));
    check(MatSetOption(m_matrix, MAT_NO_OFF_PROC_ENTRIES, PETSC_TRUE)); // each process has all cells around its vertices
  }

  Linear_solver_status factorize(const Matrix& matrix)
  {
    m_communicator.synchronize();
    const std::vector<PetscInt>& rows = m_mesh.global_rows();
    for(PetscInt row = 0; row < number_of_own_rows(); ++row)
    {
      const int begin = matrix.row_begin(row), size = matrix.row_end(row) - begin;
      for(int k = 0; k < size; ++k)
        m_columns[k] = rows[matrix.column(begin + k)];
      std::copy(matrix.values(begin), matrix.values(begin) + 9 * size, m_values.begin());
      check(MatSetValuesBlocked(m_matrix, 1, &rows[row], size, m_columns.data(), m_values.data(), INSERT_VALUES));
    }
    check(MatAssemblyBegin(m_matrix, MAT_FINAL_ASSEMBLY));
    check(MatAssemblyEnd(m_matrix, MAT_FINAL_ASSEMBLY));
    return Linear_solver_status::SUCCESS;
  }

  Linear_solver_status solve(const VectorXd& b, VectorXd& x, const double tolerance)
  {
    x.setZero(b.size(), 1);
    if(m_communicator.all(b.head(3 * number_of_own_rows()).isZero(0))) // KSPSTCG finds no direction for zero
      return Linear_solver_status::SUCCESS;
    check(KSPSetTolerances(m_ksp, tolerance, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT));
    check(VecPlaceArray(m_b, b.data()));
    check(VecPlaceArray(m_x, x.data()));
    check(KSPSolve(m_ksp, m_b, m_x));
    check(VecGhostUpdateBegin(m_x, INSERT_VALUES, SCATTER_FORWARD));
    check(VecGhostUpdateEnd(m_x, INSERT_VALUES, SCATTER_FORWARD));
    check(VecResetArray(m_b));
    check(VecResetArray(m_x));
    const Linear_solver_status result = status();
    m_number_of_cut_solutions += result == Linear_solver_status::ITERATION_LIMIT;
    return result;
  }

  PetscInt number_of_own_rows() const { return m_mesh.number_of_own_rows(); }

  Linear_solver_status status() const
  {
    PetscInt number_of_iterations;
    KSPConvergedReason reason;
    check(KSPGetIterationNumber(m_ksp, &number_of_iterations));
    check(KSPGetConvergedReason(m_ksp, &reason));
    switch(reason)
    {
      case KSP_CONVERGED_CG_NEG_CURVE: // the first iteration counts although it finds no solution then
      case KSP_DIVERGED_INDEFINITE_MAT:
      case KSP_DIVERGED_INDEFINITE_PC:
        return number_of_iterations <= 1 ? Linear_solver_status::NOT_POSITIVE_DEFINITE : Linear_solver_status::TRUNCATED;
      case KSP_DIVERGED_ITS: return Linear_solver_status::ITERATION_LIMIT;
      default: return reason > 0 ? Linear_solver_status::SUCCESS : Linear_solver_status::FAILED;
    }
  }

  // Ends all processes after an error of PETSc in one, as others may wait for it.
  void check(const PetscErrorCode error) const { PetscCallAbort(m_communicator.get(), error); }

  const MPI_communicator_3& m_communicator;
  const Distributed_mesh_3& m_mesh;
  Vec m_x, m_b;
  Mat m_matrix;
  KSP m_ksp;
  std::vector<PetscInt> m_columns;   // columns of one row
  std::vector<PetscScalar> m_values; // values of one row
  std::size_t m_number_of_cut_solutions = 0;
  Default_solver m_default_solver;
  Linear_solver_of<Default_solver> m_solver_for_patches{ m_default_solver };
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISTRIBUTED_PETSC_SOLVER_3_H
