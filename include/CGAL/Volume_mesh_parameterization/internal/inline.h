// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INLINE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INLINE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

// With the macro CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE, the functions of the engine are compiled once, by the
// target CGAL::Volume_mesh_parameterization_engine that defines it; otherwise they are inline.
// CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE tells whether a unit has their definitions, which that of the library
// says by itself.
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
#else
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE inline
#  define CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INLINE_H
