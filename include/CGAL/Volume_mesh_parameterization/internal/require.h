// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REQUIRE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REQUIRE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/exceptions.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// A precondition that is cheap, so that it holds in programs compiled with NDEBUG, too. Nothing is printed.
inline void require(const bool condition, const char* const message)
{
  if(!condition)
    throw Precondition_exception("CGAL::Volume_mesh_parameterization", "", "", 0, message);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REQUIRE_H
