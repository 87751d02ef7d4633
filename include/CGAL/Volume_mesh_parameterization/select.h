// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_SELECT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_SELECT_H

#include <CGAL/license/Volume_mesh_parameterization.h>

namespace CGAL::Volume_mesh_parameterization {

/// \ingroup PkgVolumeMeshParameterizationEnergies
/// @{

/// returns `b < a ? b : a`. For packs of cells, there are functions of the same name, which act in each cell. Argument-dependent
/// lookup finds them. An energy with `using CGAL::Volume_mesh_parameterization::minimum;` can call `minimum(a, b)` for all
/// number types of the concept `DistortionEnergy_3`. A branch would not compile for packs.
inline double minimum(const double a, const double b) { return b < a ? b : a; }

/// returns `a < b ? b : a`; see `minimum()`.
inline double maximum(const double a, const double b) { return a < b ? b : a; }

/// returns `condition ? a : b`, where the condition is the result of a comparison; see `minimum()`.
inline double select(const bool condition, const double a, const double b) { return condition ? a : b; }

/// @}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_SELECT_H
