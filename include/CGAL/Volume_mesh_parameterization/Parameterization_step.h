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
  BOUNDARY,    ///< a boundary parameterizer finds the images of the boundary
  UNTANGLING,  ///< cells are inverted, and an energy that is finite for them is minimized
  MINIMIZATION, ///< no cell is inverted, and the energy is minimized
  HEXAHEDRA    ///< `make_hexahedral_mesh_3()` improves hexahedra
};

/// \ingroup PkgVolumeMeshParameterizationResults
/// The kinds of steps.
enum class Step_kind
{
  NEWTON, ///< a Newton step over all vertices that move
  PATCH,  ///< inverted cells with the cells around them are untangled, as a problem of their own
  ROUND,  ///< a round of a loop over the boundary or over hexahedra begins, of which only name, number and time are told
  /// an attempt to untangle a patch with edges split, to find the necessary splits
  SPLIT
};

/*!
\ingroup PkgVolumeMeshParameterizationResults

The report of a step to a visitor: see the named parameter `visitor` of
`CGAL::stretch_minimizing_volume_parameterization()`.
*/
struct Parameterization_step
{
  std::size_t iteration = 0;                ///< number of steps so far, in all stages; rounds have numbers of their own
  Phase phase = Phase::START;               ///< the phase that the step belonged to
  Step_kind kind = Step_kind::NEWTON;       ///< the kind of the step; only `NEWTON` has energy, gradient, decrement and length
  std::string attempt;                      ///< the name of the stage or of the attempt to untangle, for a progress bar
  /// mean over the cells of the energy that the step lowered, with a penalty if the boundary is soft. While cells are untangled,
  /// it is the mean over the cells with a free vertex. Values of different phases and stages are not comparable
  double energy = 0;
  std::size_t number_of_inverted_cells = 0; ///< inverted or flat cells after the step, by floating-point determinants
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
  /// returns `true`: the computation continues.
  bool after_step(const Parameterization_step&) { return true; }

  /// returns `true`: the computation continues.
  bool goes_on() { return true; }
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_STEP_H
