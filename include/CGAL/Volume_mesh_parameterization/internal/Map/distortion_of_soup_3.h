// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_DISTORTION_OF_SOUP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_DISTORTION_OF_SOUP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Distortion_3 distortion_of_soup_3(const Tetrahedron_soup_3& soup, const std::vector<std::array<double, 3> >& images);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Map/distortion_of_soup_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_DISTORTION_OF_SOUP_3_H
