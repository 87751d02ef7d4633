// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_BASIC_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_BASIC_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Vector_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

// CGAL_POLYCUBE_MESHING_3_COMPILED_ENGINE, a macro that the target CGAL::Polycube_meshing_3_engine defines, means the same for
// this package as CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE for the other one.
#if defined(CGAL_POLYCUBE_MESHING_3_COMPILED_ENGINE) != defined(CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE)
#  error "A unit links the engines of both packages, or none: link CGAL::Polycube_meshing_3_engine."
#endif
#ifdef CGAL_POLYCUBE_MESHING_3_COMPILED_ENGINE
#  define CGAL_POLYCUBE_MESHING_3_INLINE
#else
#  define CGAL_POLYCUBE_MESHING_3_INLINE inline
#endif

namespace CGAL::Polycube_meshing_3 {

// The codes that functions of this package return. They are those of the other package, whose call for a map returns the code of a
// boundary parameterizer.
using Volume_mesh_parameterization::Error_code;
using Volume_mesh_parameterization::OK;
using Volume_mesh_parameterization::ERROR_INTERRUPTED;
using Volume_mesh_parameterization::ERROR_EMPTY_COMPLEX;
using Volume_mesh_parameterization::ERROR_NON_FINITE_COORDINATE;
using Volume_mesh_parameterization::ERROR_SIZE_OUT_OF_RANGE;
using Volume_mesh_parameterization::ERROR_INVERTED_SOURCE_CELL;
using Volume_mesh_parameterization::ERROR_INVERTED_TARGET_BOUNDARY;
using Volume_mesh_parameterization::ERROR_NON_MANIFOLD_BOUNDARY;
using Volume_mesh_parameterization::ERROR_SEVERAL_BOUNDARY_COMPONENTS;
using Volume_mesh_parameterization::ERROR_BOUNDARY_TOO_COARSE;
using Volume_mesh_parameterization::ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
using Volume_mesh_parameterization::ERROR_NO_POLYCUBE;
using Volume_mesh_parameterization::ERROR_SPACING_TOO_COARSE;
using Volume_mesh_parameterization::ERROR_DOMAIN_NOT_AXIS_PARALLEL;
using Volume_mesh_parameterization::ERROR_INVERTED_HEXAHEDRON;
using Volume_mesh_parameterization::ERROR_POOR_HEXAHEDRON;
using Volume_mesh_parameterization::ERROR_INCOMPLETE_HEXAHEDRA;

} // namespace CGAL::Polycube_meshing_3

namespace CGAL::Polycube_meshing_3::internal {

// The inside of this package uses that of the other one.
using namespace Volume_mesh_parameterization;
using namespace Volume_mesh_parameterization::internal;
using Volume_mesh_parameterization::internal::Vector_3; // not CGAL's

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_BASIC_H
