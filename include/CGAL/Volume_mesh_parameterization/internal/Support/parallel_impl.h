// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_PARALLEL_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_PARALLEL_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/parallel_for.h>
#endif

namespace CGAL::Volume_mesh_parameterization::internal {

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE const Communicator_3& single_process()
{
  static const Communicator_3 communicator;
  return communicator;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
void call_for_each_index(const bool is_parallel, const std::size_t first, const std::size_t last, const Index_function f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(is_parallel)
  {
    tbb::parallel_for(first, last, f);
    return;
  }
#endif
  static_cast<void>(is_parallel);
  for(std::size_t i = first; i < last; ++i)
    f(i);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_PARALLEL_IMPL_H
