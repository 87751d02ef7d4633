// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENERGIES_CELL_ARITHMETIC_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENERGIES_CELL_ARITHMETIC_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Vector_3.h>
#include <CGAL/Volume_mesh_parameterization/select.h>

#include <Eigen/Core>

#include <boost/config.hpp>

#if defined(__AVX2__)
#  include <immintrin.h>
#elif defined(__x86_64__)
#  include <emmintrin.h>
#elif defined(__aarch64__)
#  include <arm_neon.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

// Vectors are an extension of GNU's compilers. Without vectors a register is a double, which a macro can ask for, too.
#if defined(__GNUC__) && !defined(CGAL_VOLUME_MESH_PARAMETERIZATION_NO_EXTENSIONS)
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_EXTENSIONS
#endif

// Instructions for which this unit is compiled, and the number of doubles in their registers. The namespace of the
// arithmetic is named after the instructions, so that units for different processors do not share functions.
#if !defined(CGAL_VOLUME_MESH_PARAMETERIZATION_EXTENSIONS)
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS without_extensions
#elif defined(__AVX512F__) && defined(__AVX512DQ__)
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS avx512
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_REGISTER_WIDTH 8
#elif defined(__AVX2__) && defined(__FMA__)
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS avx2
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_REGISTER_WIDTH 4
#else
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS baseline
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_REGISTER_WIDTH 2
#endif

namespace CGAL::Volume_mesh_parameterization::internal {

inline bool any(const bool condition) { return condition; }

} // namespace CGAL::Volume_mesh_parameterization::internal

#include <CGAL/Volume_mesh_parameterization/internal/Energies/Kernels/Pack.inc>

namespace CGAL::Volume_mesh_parameterization::internal {
namespace CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS {

// Computes exponentials (and below logarithms) by Eigen's vectorized functions.
inline Pack exp(const Pack& a)
{
  Eigen::Array<double, Pack::size, 1, Eigen::DontAlign> values;
  a.store(values.data());
  values = values.exp();
  return Pack::load(values.data());
}

inline Pack log(const Pack& a)
{
  Eigen::Array<double, Pack::size, 1, Eigen::DontAlign> values;
  a.store(values.data());
  values = values.log();
  return Pack::load(values.data());
}

} // namespace CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS

using CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS::Pack;

} // namespace CGAL::Volume_mesh_parameterization::internal

namespace Eigen {

template <>
struct NumTraits<CGAL::Volume_mesh_parameterization::internal::Pack>
  : GenericNumTraits<CGAL::Volume_mesh_parameterization::internal::Pack>
{
  enum { IsSigned = 1, RequireInitialization = 0 };
};

} // namespace Eigen

// Arithmetic with the instructions of this unit, for packs and for single cells.
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Kernels/Distortion_derivatives_3.inc>

namespace CGAL::Volume_mesh_parameterization::internal {

namespace arithmetic_of_unit = CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS;

inline arithmetic_of_unit::Signed_singular_values_3<double> decomposed(const Matrix_3& J)
{
  arithmetic_of_unit::Matrix_3<double> matrix;
  for(int j = 0; j < 3; ++j)
    for(int i = 0; i < 3; ++i)
      matrix(i, j) = J(i, j);
  arithmetic_of_unit::Signed_singular_values_3<double> result;
  decompose(matrix, result);
  return result;
}

// Returns the signed singular values of a matrix, the smallest of which has the sign of its determinant.
inline Vector_3 signed_singular_values_3(const Matrix_3& J)
{
  const auto s = decomposed(J).s;
  return Vector_3(s[0], s[1], s[2]);
}

// Rotation R Q^T nearest to a matrix R diag(s) Q^T, and the sum of s.
struct Rotation_and_stretch_3
{
  Matrix_3 rotation;
  double stretch;
};

inline Rotation_and_stretch_3 rotation_and_stretch_3(const Matrix_3& J)
{
  const auto d = decomposed(J);
  const auto R = product(d.R, transposed(d.Q));
  Rotation_and_stretch_3 result;
  for(int j = 0; j < 3; ++j)
    for(int i = 0; i < 3; ++i)
      result.rotation(i, j) = R(i, j);
  result.stretch = d.s[0] + d.s[1] + d.s[2];
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENERGIES_CELL_ARITHMETIC_3_H
