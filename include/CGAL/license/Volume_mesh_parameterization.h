// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_LICENSE_VOLUME_MESH_PARAMETERIZATION_H
#define CGAL_LICENSE_VOLUME_MESH_PARAMETERIZATION_H

// CGAL generates the header of this name for its packages; outside of CGAL there is only the GPL to choose.
#include <CGAL/config.h>
#include <CGAL/license.h>

#endif // CGAL_LICENSE_VOLUME_MESH_PARAMETERIZATION_H
