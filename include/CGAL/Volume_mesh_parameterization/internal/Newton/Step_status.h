// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STEP_STATUS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STEP_STATUS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// What one step of the untangler or of the minimizer tells.
enum class Step_status
{
  CONTINUE,      // further steps make sense
  DONE,          // the goal is reached
  STUCK,         // no progress
  SOLVER_FAILED
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STEP_STATUS_H
