// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENERGIES_CELL_KERNELS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENERGIES_CELL_KERNELS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_energy_3.h>

#if defined(__x86_64__)
#  include <immintrin.h>
#endif

namespace CGAL::Volume_mesh_parameterization::internal {

// Passes over the packs of cells, from the first one to the end of a range; `u` and `d` hold three coordinates a vertex, the
// gradient three a row. Kernels/Cell_kernels_3.inc defines and describes the passes.
struct Cell_kernels_3
{
  using Range = const Cell_pack_3*;
  template <typename NT>
  using Add_derivatives = void (*)(Range, Range, const double* u, const Cell_energy_3&, double negative_curvature,
                                   double* gradient, NT* hessian);

  void (*evaluate)(Range, Range, const double* u, const Cell_energy_3&, Energy_evaluation&);
  void (*add_gradient)(Range, Range, const double* u, const Cell_energy_3&, double* gradient);
  std::pair<Add_derivatives<float>, Add_derivatives<double> > add_derivatives;
  double (*largest_step)(Range, Range, const double* u, const double* d);
};

// Returns a number in [0, 1] up to which the polynomial with Bernstein coefficients b is positive: its first root, less at most
// the resolution times the root, however small it is. Bisects by de Casteljau's algorithm.
inline double positive_until(const std::array<double, 4>& b, const double resolution = 1. / 1024)
{
  if((std::min)((std::min)(b[0], b[1]), (std::min)(b[2], b[3])) > 0)
    return 1;
  const bool are_finite = std::isfinite(b[0]) && std::isfinite(b[1]) && std::isfinite(b[2]) && std::isfinite(b[3]);
  if(resolution >= 1 || !(b[0] > 0) || !are_finite)
    return 0;
  const double b01 = (b[0] + b[1]) / 2, b12 = (b[1] + b[2]) / 2, b23 = (b[2] + b[3]) / 2;
  const double b012 = (b01 + b12) / 2, b123 = (b12 + b23) / 2;
  const double middle = (b012 + b123) / 2;
  const double left = positive_until({ b[0], b01, b012, middle }, resolution);
  if(left < 1)
    return left / 2;
  return (1 + positive_until({ middle, b123, b23, b[3] }, 2 * resolution)) / 2;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

// Kernels are compiled for the instructions of this unit, and, if the unit is for any processor, for longer instructions that
// the processor may have.
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Kernels/Cell_kernels_3.inc>

#if defined(CGAL_VOLUME_MESH_PARAMETERIZATION_EXTENSIONS) && defined(__x86_64__) && !(defined(__AVX2__) && defined(__FMA__))
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_CHOOSES_INSTRUCTIONS
#  if defined(__clang__)
#    pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#  else
#    pragma GCC push_options
#    pragma GCC target("avx2,fma")
#  endif
#  undef CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS
#  undef CGAL_VOLUME_MESH_PARAMETERIZATION_REGISTER_WIDTH
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS avx2
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_REGISTER_WIDTH 4
#  include <CGAL/Volume_mesh_parameterization/internal/Energies/Kernels/Pack.inc>
#  include <CGAL/Volume_mesh_parameterization/internal/Energies/Kernels/Distortion_derivatives_3.inc>
#  include <CGAL/Volume_mesh_parameterization/internal/Energies/Kernels/Cell_kernels_3.inc>
#  if defined(__clang__)
#    pragma clang attribute pop
#  else
#    pragma GCC pop_options
#  endif

#  if defined(__clang__)
#    pragma clang attribute push(__attribute__((target("avx512f,avx512dq,avx2,fma"))), apply_to = function)
#  else
#    pragma GCC push_options
#    pragma GCC target("avx512f,avx512dq,avx2,fma")
#  endif
#  undef CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS
#  undef CGAL_VOLUME_MESH_PARAMETERIZATION_REGISTER_WIDTH
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS avx512
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_REGISTER_WIDTH 8
#  include <CGAL/Volume_mesh_parameterization/internal/Energies/Kernels/Pack.inc>
#  include <CGAL/Volume_mesh_parameterization/internal/Energies/Kernels/Distortion_derivatives_3.inc>
#  include <CGAL/Volume_mesh_parameterization/internal/Energies/Kernels/Cell_kernels_3.inc>
#  if defined(__clang__)
#    pragma clang attribute pop
#  else
#    pragma GCC pop_options
#  endif
#endif

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the kernels for this processor.
inline const Cell_kernels_3& cell_kernels_3()
{
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_CHOOSES_INSTRUCTIONS
  if(__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    return avx512::cell_kernels;
  if(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return avx2::cell_kernels;
#endif
  return arithmetic_of_unit::cell_kernels;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENERGIES_CELL_KERNELS_3_H
