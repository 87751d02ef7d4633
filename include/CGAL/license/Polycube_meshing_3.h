// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_LICENSE_POLYCUBE_MESHING_3_H
#define CGAL_LICENSE_POLYCUBE_MESHING_3_H

// Each header of this package includes this one before all others.
#if !(__cplusplus >= 201703L || (defined(_MSVC_LANG) && _MSVC_LANG >= 201703L))
#  error "The package Polycube_meshing_3 needs C++17: compile with -std=c++17 or later."
#endif

// CGAL generates the header of this name for its packages; outside of CGAL there is only the GPL to choose.
#include <CGAL/config.h>
#include <CGAL/license.h>
#include <CGAL/license/Volume_mesh_parameterization.h>

// A unit that is header-only has names of its own, as those of the other package.
#if !defined(CGAL_POLYCUBE_MESHING_3_COMPILED_ENGINE) && !defined(DOXYGEN_RUNNING)
#  define Polycube_meshing_3 Polycube_meshing_3_header_only
#endif

#endif // CGAL_LICENSE_POLYCUBE_MESHING_3_H
