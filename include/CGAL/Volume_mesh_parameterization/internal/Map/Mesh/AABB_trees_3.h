// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_AABB_TREES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_AABB_TREES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

// The names without _3 are deprecated since CGAL 6.0, and those with _3 are new there.
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#  include <CGAL/AABB_segment_primitive_3.h>
#  include <CGAL/AABB_traits_3.h>
#  include <CGAL/AABB_triangle_primitive_3.h>
#else
#  include <CGAL/AABB_segment_primitive.h>
#  include <CGAL/AABB_traits.h>
#  include <CGAL/AABB_triangle_primitive.h>
#endif

#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Kernel of the trees, with the vectors that they are built of.
struct AABB_trees_3
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Segments = std::vector<Kernel::Segment_3>;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  using Of_triangles = AABB_tree<AABB_traits_3<Kernel, AABB_triangle_primitive_3<Kernel, Triangles::const_iterator> > >;
  using Of_segments = AABB_tree<AABB_traits_3<Kernel, AABB_segment_primitive_3<Kernel, Segments::const_iterator> > >;
#else
  using Of_triangles = AABB_tree<AABB_traits<Kernel, AABB_triangle_primitive<Kernel, Triangles::const_iterator> > >;
  using Of_segments = AABB_tree<AABB_traits<Kernel, AABB_segment_primitive<Kernel, Segments::const_iterator> > >;
#endif
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_AABB_TREES_3_H
