// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_STEP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_STEP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <cstddef>

namespace CGAL {
namespace Volume_mesh_parameterization {

/// \ingroup PkgVolumeMeshParameterizationRef
/// The phases of a parameterization.
enum class Phase { START, UNTANGLING, MINIMIZATION };

/*!
\ingroup PkgVolumeMeshParameterizationRef

What a visitor is told after each Newton step: see the named parameter `visitor` of
`CGAL::stretch_minimizing_volume_parameterization()`.
*/
struct Parameterization_step
{
  std::size_t iteration = 0;               ///< number of Newton steps so far
  Phase phase = Phase::START;
  double energy = 0;                       ///< mean of the energy of the phase over the cells
  std::size_t number_of_inverted_cells = 0;
  double gradient_norm = 0;                ///< of the energy at the beginning of the step
  double step_length = 0;                  ///< 1 is a full Newton step
  double seconds = 0;                      ///< since the beginning
};

/*!
\ingroup PkgVolumeMeshParameterizationRef

The default visitor, which does nothing.
*/
struct Default_visitor
{
  /// is called after each Newton step; the computation ends if it returns `false`
  bool after_step(const Parameterization_step&) { return true; }
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_STEP_H
