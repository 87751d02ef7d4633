// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_DISTRIBUTED_DISTRIBUTED_TETRAHEDRON_SOUP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_DISTRIBUTED_DISTRIBUTED_TETRAHEDRON_SOUP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <mpi.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/// \ingroup PkgVolumeMeshParameterizationDistributed
///
/// A tetrahedral mesh of which each process has a slice. Points are numbered from 0 in the order of the ranks. Any process
/// may have a cell, whatever its points.
struct Distributed_tetrahedron_soup_3
{
  MPI_Comm communicator = MPI_COMM_WORLD;        ///< the processes that share the mesh
  std::vector<std::array<double, 3> > points;    ///< the coordinates of the vertices of this slice
  /// four indices of points of the whole mesh each; all cells oriented alike
  std::vector<std::array<std::size_t, 4> > cells;
  std::vector<int> cell_references;              ///< one per cell of this slice
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DISTRIBUTED_DISTRIBUTED_TETRAHEDRON_SOUP_3_H
