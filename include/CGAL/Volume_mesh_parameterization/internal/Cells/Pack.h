// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_PACK_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_PACK_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/select.h>

#include <Eigen/Core>

#include <boost/config.hpp>

#if defined(__x86_64__)
#  include <immintrin.h>
#elif defined(__aarch64__)
#  include <arm_neon.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

// Vectors are an extension of GNU's compilers. Without it, a register is a double; so one can ask for elsewhere, too.
#if defined(__GNUC__) && !defined(CGAL_VOLUME_MESH_PARAMETERIZATION_NO_EXTENSIONS)
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_EXTENSIONS
#endif

// The instructions for which this unit is compiled, and the doubles in a register of theirs. The namespace of the
// arithmetic is named after them, so that units for different processors do not share functions.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
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

#include <CGAL/Volume_mesh_parameterization/internal/Cells/Kernels/Pack.inc>

namespace CGAL::Volume_mesh_parameterization::internal {
namespace CGAL_VOLUME_MESH_PARAMETERIZATION_INSTRUCTIONS {

// By Eigen's vectorized functions.
inline Pack exp(const Pack& a)
{
  Eigen::Array<double, Pack::size, 1> values;
  a.store(values.data());
  values = values.exp();
  return Pack::load(values.data());
}

inline Pack log(const Pack& a)
{
  Eigen::Array<double, Pack::size, 1> values;
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
  using Pack = CGAL::Volume_mesh_parameterization::internal::Pack;
  using Real = Pack;
  using NonInteger = Pack;
  using Nested = Pack;
  using Literal = Pack;

  enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 0,
         ReadCost = 1, AddCost = 1, MulCost = 1 };
};

} // namespace Eigen

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_PACK_H
