// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_FOR_EACH_INDEX_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_FOR_EACH_INDEX_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/parallel_for.h>
#endif

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Calls f(first), ..., f(last - 1), in parallel if asked for. The calls must be independent; callers
// that sum keep one partial sum an index and add them in order, so results do not depend on threads.
template <typename ConcurrencyTag, typename Function>
void for_each_index(const std::size_t first, const std::size_t last, const Function& f)
{
  if constexpr(std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::parallel_for(first, last, f);
#else
    static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                  "Parallel_tag requires TBB: link with CGAL::TBB_support.");
#endif
  }
  else
  {
    for(std::size_t i = first; i < last; ++i)
      f(i);
  }
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_FOR_EACH_INDEX_H
