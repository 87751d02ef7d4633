// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_DISJOINT_SETS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_DISJOINT_SETS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Union_find.h>

#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Union_find for the indices from 0 to n - 1. Those of Boost do not compile after some headers of Boost's graphs.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(const std::size_t n)
  {
    m_handles.reserve(n);
    for(std::size_t i = 0; i < n; ++i)
      m_handles.push_back(m_sets.make_set(i));
  }

  void unite(const std::size_t i, const std::size_t j) { m_sets.unify_sets(m_handles[i], m_handles[j]); }

  // The index that stands for the set of i.
  std::size_t find(const std::size_t i) { return *m_sets.find(m_handles[i]); }

private:
  Union_find<std::size_t> m_sets;
  std::vector<Union_find<std::size_t>::handle> m_handles;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_DISJOINT_SETS_H
