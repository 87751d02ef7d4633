// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INSERTED_VERTEX_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INSERTED_VERTEX_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationRef

A vertex that refinement has inserted into a complex, with the vertices of the edge, facet or cell
it was inserted into. Up to rounding it lies at their centroid, so that the mean of values at these vertices
is the value of the linear interpolation at the new one.

\tparam VertexHandle `C3t3::Vertex_handle`
*/
template <typename VertexHandle>
struct Inserted_vertex_3
{
  VertexHandle vertex;               ///< the new vertex
  std::vector<VertexHandle> simplex; ///< the two, three or four vertices of the edge, facet or cell
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INSERTED_VERTEX_3_H
