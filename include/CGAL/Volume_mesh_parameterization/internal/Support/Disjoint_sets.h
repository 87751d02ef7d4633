// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_DISJOINT_SETS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_DISJOINT_SETS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Sets of the indices from 0 to n - 1, united by size. Those of CGAL have a node of a list for each index, and those of Boost
// do not compile after some headers of Boost's graphs.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(const std::size_t n) : m_up(n), m_size(n, 1) { std::iota(m_up.begin(), m_up.end(), std::size_t(0)); }

  void unite(std::size_t i, std::size_t j)
  {
    i = find(i);
    j = find(j);
    if(i == j)
      return;
    if(m_size[i] > m_size[j])
      std::swap(i, j);
    m_up[i] = j;
    m_size[j] += m_size[i];
  }

  // The index that stands for the set of i.
  std::size_t find(std::size_t i)
  {
    while(m_up[i] != i)
      i = m_up[i] = m_up[m_up[i]];
    return i;
  }

  // Returns the number of the set of each index, in the order of the first indices.
  std::vector<std::size_t> numbers()
  {
    std::vector<std::size_t> number_of_set(m_up.size(), m_up.size()), result;
    std::size_t n = 0;
    for(std::size_t i = 0; i < m_up.size(); ++i)
    {
      std::size_t& number = number_of_set[find(i)];
      if(number == m_up.size())
        number = n++;
      result.push_back(number);
    }
    return result;
  }

private:
  std::vector<std::size_t> m_up, m_size; // the size is that of the set which an index stands for
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_DISJOINT_SETS_H
