// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_HEXAHEDRON_SOUP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_HEXAHEDRON_SOUP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/// \ingroup PkgVolumeMeshParameterizationHexahedra
///
/// A mesh of hexahedra as arrays.
struct Hexahedron_soup_3
{
  std::vector<std::array<double, 3> > points; ///< the coordinates of the vertices
  /// eight indices of points each, in the order of VTK: around one quadrangle and, in the same order, around the
  /// opposite one, into whose direction the first one turns counterclockwise
  std::vector<std::array<std::size_t, 8> > cells;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_HEXAHEDRON_SOUP_3_H
