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

#include <CGAL/exceptions.h>

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

inline std::string describe(const Eigen::Vector3d& point)
{ return sentence("(", point[0], ", ", point[1], ", ", point[2], ")"); }

// Throws unless a precondition holds, in programs compiled with NDEBUG, too, as it is cheap. The exception names the line of
// the call; nothing is printed.
inline void require(const bool condition, const char* const message, const char* const file = __builtin_FILE(),
                    const int line = __builtin_LINE())
{
  if(!condition)
    throw Precondition_exception("CGAL::Volume_mesh_parameterization", "", file, line, message);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_SENTENCE_H
