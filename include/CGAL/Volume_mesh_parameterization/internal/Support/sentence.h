// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_SENTENCE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_SENTENCE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <locale>
#include <sstream>
#include <string>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns words and numbers in a row. Digits are not grouped and the decimal sign is a point, whatever the global locale is.
template <typename... Parts>
std::string sentence(const Parts&... parts)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  (out << ... << parts);
  return out.str();
}

// Returns a number with the singular or the plural of the words behind it, for instance "cell is" and "cells are".
template <typename Number>
std::string counted(const Number number, const char* const singular, const char* const plural)
{ return sentence(number, " ", number == 1 ? singular : plural); }

// Returns the names of some things with commas and "and".
template <typename Range, typename NameOf>
std::string listed(const Range& range, const NameOf& name)
{
  std::string result;
  std::size_t number_left = range.size();
  for(const auto& element : range)
    result += name(element) + (--number_left == 0 ? "" : number_left == 1 ? " and " : ", ");
  return result;
}

inline std::string describe(const Eigen::Vector3d& point)
{ return sentence("(", point[0], ", ", point[1], ", ", point[2], ")"); }

// CGAL defines CGAL_NO_PRECONDITIONS in programs compiled with NDEBUG, too, where these checks stay, as they are cheap.
#if defined(CGAL_NO_PRECONDITIONS) && !defined(CGAL_NDEBUG)
constexpr bool checks_preconditions = false;
#else
constexpr bool checks_preconditions = true;
#endif

// Calls CGAL's failure function: its handlers are called, and by default an exception is thrown that names the line of the call.
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
void fail_precondition(const char* message, const char* file, int line);
#else
inline void fail_precondition(const char* const message, const char* const file, const int line)
{ precondition_fail("", file, line, message); }
#endif

inline void require(const bool condition, const char* const message, const char* const file = __builtin_FILE(),
                    const int line = __builtin_LINE())
{
  if(checks_preconditions && !condition)
    fail_precondition(message, file, line);
}

// Fails if the flags of this unit permit other operations than those that are written. Not all compilers have macros for them.
inline void require_operations_as_written()
{
  const volatile double x = 1, tiny = 1e-30; // which the compiler does not know
  const double one = x, sum = one + tiny;
  require(sum - one == 0, "The exact check of the map needs each operation as it is written: compile without "
                          "-funsafe-math-optimizations and -fassociative-math.");
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_SENTENCE_H
