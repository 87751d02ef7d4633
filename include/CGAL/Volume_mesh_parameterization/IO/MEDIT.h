// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

// The old name of MEDIT_format.h, for one release: CGAL 6.3 has a header CGAL/IO/MEDIT.h.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_MEDIT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_MEDIT_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_MEDIT_H
