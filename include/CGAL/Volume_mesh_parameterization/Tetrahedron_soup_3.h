// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// A tetrahedral mesh as a file holds it: arrays in the order of the file, indices that start at 0. References are the
/// numbers by which a file tells materials or patches apart, 0 if there is none.
struct Tetrahedron_soup_3
{
  std::vector<std::array<double, 3> > points;        ///< the coordinates of the vertices
  std::vector<std::array<std::size_t, 4> > cells;    ///< four indices of points each; all cells oriented alike
  std::vector<int> cell_references;                  ///< one per cell
  std::vector<std::array<std::size_t, 3> > facets;   ///< marked facets, of the boundary or inside, in any orientation
  std::vector<int> facet_references;                 ///< one per facet
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_3_H
