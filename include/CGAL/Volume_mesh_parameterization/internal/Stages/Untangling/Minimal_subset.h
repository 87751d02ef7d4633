// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_MINIMAL_SUBSET_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_MINIMAL_SUBSET_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Finds some of many items that suffice, none of which can be spared, where all of them suffice: leaves out halves, then
// quarters, and so on (delta debugging: Zeller and Hildebrandt, Simplifying and isolating failure-inducing input, IEEE
// Transactions on Software Engineering 28, 2002). Of n items k take O(k log n) questions, if few combinations suffice.
template <typename Item>
class Minimal_subset
{
public:
  explicit Minimal_subset(std::vector<Item> items) : m_items(std::move(items)), m_size(m_items.size())
  {
    begin_pass();
  }

  bool is_running() const { return m_size > 0; }
  const std::vector<Item>& items() const { return m_items; } // that suffice

  // Do these suffice? There is at least one.
  std::vector<Item> question() const
  {
    const auto first = m_items.begin() + m_first;
    std::vector<Item> result(m_items.begin(), first);
    result.insert(result.end(), first + (std::min)(m_size, m_items.size() - m_first), m_items.end());
    return result;
  }

  void answer(const bool suffices)
  {
    if(suffices)
      m_items = question();
    else
      m_first += m_size;
    if(m_first >= m_items.size() || m_size >= m_items.size())
      begin_pass();
  }

private:
  void begin_pass()
  {
    m_first = 0;
    m_size = m_size <= 1 || m_items.size() == 1 ? 0 : ((std::min)(m_size, m_items.size()) + 1) / 2;
  }

  std::vector<Item> m_items;
  std::size_t m_size; // of the part that is left out
  std::size_t m_first = 0;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_MINIMAL_SUBSET_H
