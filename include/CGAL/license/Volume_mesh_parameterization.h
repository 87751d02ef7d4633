// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_LICENSE_VOLUME_MESH_PARAMETERIZATION_H
#define CGAL_LICENSE_VOLUME_MESH_PARAMETERIZATION_H

// Each header of this package includes this one before all others.
#if !(__cplusplus >= 201703L || (defined(_MSVC_LANG) && _MSVC_LANG >= 201703L))
#  error "The package Volume_mesh_parameterization needs C++17: compile with -std=c++17 or later."
#endif
// Clang defines no macro for -funsafe-math-optimizations: require_operations_as_written() finds it.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0) || defined(_M_FP_FAST)
#  error "The exact check of the map needs NaN and infinity: compile without -ffast-math, -Ofast and -ffinite-math-only."
#endif
#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#  error "The exact check of the map needs each operation as it is written: compile without -funsafe-math-optimizations, \
-fassociative-math and -freciprocal-math."
#endif

// A unit that is header-only has names of its own. Otherwise, the linker could take the functions of this unit, whatever its flags
// are, for all units that link the engine.
#if !defined(CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE) && !defined(DOXYGEN_RUNNING)
#  define Volume_mesh_parameterization Volume_mesh_parameterization_header_only
#endif

// CGAL generates the header of this name for its packages; outside of CGAL there is only the GPL to choose.
#include <CGAL/config.h>
#include <CGAL/license.h>

#endif // CGAL_LICENSE_VOLUME_MESH_PARAMETERIZATION_H
