// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_DEFAULT_VISITOR_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_DEFAULT_VISITOR_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>

namespace CGAL::Volume_mesh_parameterization {

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

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DEFAULT_VISITOR_H
