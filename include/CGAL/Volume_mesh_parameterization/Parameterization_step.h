// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_STEP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_STEP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <cstddef>
#include <string>

namespace CGAL::Volume_mesh_parameterization {

/// \ingroup PkgVolumeMeshParameterizationResults
/// The phases of a parameterization. With soft boundary, all steps are minimization.
enum class Phase
{
  START,       ///< before the first step
  UNTANGLING,  ///< cells are inverted, and an energy that is finite for them is minimized
  MINIMIZATION ///< no cell is inverted, and the energy is minimized
};

/// \ingroup PkgVolumeMeshParameterizationResults
/// What a step is.
enum class Step_kind
{
  NEWTON, ///< a Newton step over all vertices that move
  PATCH,  ///< some inverted cells with those around them are untangled, as a problem of their own
  SPLIT   ///< an attempt to untangle a patch with some of its edges split, to find out which ones need be
};

/*!
\ingroup PkgVolumeMeshParameterizationResults

What a visitor is told after each step: see the named parameter `visitor` of
`CGAL::stretch_minimizing_volume_parameterization()`.
*/
struct Parameterization_step
{
  std::size_t iteration = 0;                ///< number of steps so far, in all stages
  Phase phase = Phase::START;               ///< what the step was for
  Step_kind kind = Step_kind::NEWTON;       ///< what it was; energy, gradient, decrement and length are of Newton steps only
  std::string attempt;                      ///< the name of the stage or of the attempt to untangle, for a progress bar
  /// mean over the cells of the energy that the step lowered, with a penalty if the boundary is soft; while cells are
  /// untangled, over those with a free vertex only. Values of different phases and stages are not comparable
  double energy = 0;
  std::size_t number_of_inverted_cells = 0; ///< or flat, after the step, by floating-point determinants
  /// the Newton decrement at the beginning of the step: half of its square is about what there is to gain
  double decrement = 0;
  double gradient_norm = 0;                 ///< Euclidean norm of the gradient at the beginning of the step
  double step_length = 0;                   ///< 1 is a full Newton step, 0 means that no step was acceptable
  double seconds = 0;                       ///< wall-clock time since the beginning
};

/*!
\ingroup PkgVolumeMeshParameterizationResults

The default visitor, which does nothing.

\cgalModels{ParameterizationVisitor_3}
*/
struct Default_visitor
{
  /// returns `true`: the computation goes on.
  bool after_step(const Parameterization_step&) { return true; }

  /// returns `true`: the computation goes on.
  bool goes_on() { return true; }
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_STEP_H
