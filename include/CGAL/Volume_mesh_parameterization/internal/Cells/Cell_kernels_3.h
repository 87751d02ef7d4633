// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_CELL_KERNELS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_CELL_KERNELS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_arithmetic_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_pack_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Energy_evaluation.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/positive_until.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Volume_mesh_parameterization::internal {

// The passes over the packs of cells, from the first one to the end of a range; `u` and `d` hold three coordinates a
// vertex, the gradient as many a row. They are described where they are defined, in Kernels/Cell_kernels_3.inc.
struct Cell_kernels_3
{
  using Range = const Cell_pack_3*;

  void (*evaluate)(Range, Range, const double* u, const Cell_energy_3&, Energy_evaluation&);
  void (*add_gradient)(Range, Range, const double* u, const Cell_energy_3&, double* gradient);
  void (*add_derivatives_float)(Range, Range, const double* u, const Cell_energy_3&, double negative_curvature,
                                double* gradient, float* hessian);
  void (*add_derivatives_double)(Range, Range, const double* u, const Cell_energy_3&, double negative_curvature,
                                 double* gradient, double* hessian);
  double (*largest_step)(Range, Range, const double* u, const double* d);
};

} // namespace CGAL::Volume_mesh_parameterization::internal

// The kernels are compiled for the instructions of this unit, and for longer ones that the processor may have.
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Kernels/begin_instructions_of_unit.inc>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Kernels/Cell_kernels_3.inc>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Kernels/end_instructions.inc>

#if defined(__GNUC__) && defined(__x86_64__)
#  if !(defined(__AVX512F__) && defined(__AVX512DQ__))
#    define CGAL_VOLUME_MESH_PARAMETERIZATION_CHOOSES_AVX512
#    if !(defined(__AVX2__) && defined(__FMA__))
#      define CGAL_VOLUME_MESH_PARAMETERIZATION_CHOOSES_AVX2
#    endif
#  endif
#endif

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_CHOOSES_AVX2
#  if defined(__clang__)
#    pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#  else
#    pragma GCC push_options
#    pragma GCC target("avx2,fma")
#  endif
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS avx2
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_REGISTER_WIDTH 4
#  include <CGAL/Volume_mesh_parameterization/internal/Cells/Kernels/Pack.inc>
#  include <CGAL/Volume_mesh_parameterization/internal/Cells/Kernels/cell_arithmetic.inc>
#  include <CGAL/Volume_mesh_parameterization/internal/Cells/Kernels/Cell_kernels_3.inc>
#  include <CGAL/Volume_mesh_parameterization/internal/Cells/Kernels/end_instructions.inc>
#  if defined(__clang__)
#    pragma clang attribute pop
#  else
#    pragma GCC pop_options
#  endif
#endif

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_CHOOSES_AVX512
#  if defined(__clang__)
#    pragma clang attribute push(__attribute__((target("avx512f,avx512dq,avx2,fma"))), apply_to = function)
#  else
#    pragma GCC push_options
#    pragma GCC target("avx512f,avx512dq,avx2,fma")
#  endif
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS avx512
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_REGISTER_WIDTH 8
#  include <CGAL/Volume_mesh_parameterization/internal/Cells/Kernels/Pack.inc>
#  include <CGAL/Volume_mesh_parameterization/internal/Cells/Kernels/cell_arithmetic.inc>
#  include <CGAL/Volume_mesh_parameterization/internal/Cells/Kernels/Cell_kernels_3.inc>
#  include <CGAL/Volume_mesh_parameterization/internal/Cells/Kernels/end_instructions.inc>
#  if defined(__clang__)
#    pragma clang attribute pop
#  else
#    pragma GCC pop_options
#  endif
#endif

namespace CGAL::Volume_mesh_parameterization::internal {

// The kernels with the longest instructions of this processor.
inline const Cell_kernels_3& cell_kernels_3()
{
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_CHOOSES_AVX512
  if(__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    return avx512::cell_kernels;
#endif
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_CHOOSES_AVX2
  if(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return avx2::cell_kernels;
#endif
  return arithmetic_of_unit::cell_kernels;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_CELL_KERNELS_3_H
