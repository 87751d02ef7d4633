// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STAGNATION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STAGNATION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <algorithm>
#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// Notices that a minimization goes on and on far from its end: in ten steps, the energy falls by less than 0.1 %, and
// the squared Newton decrement, which falls fast near a minimum, hardly at all.
class Stagnation
{
public:
  static constexpr int number_of_steps = 10; // after which it may be noticed

  void add(const double energy, const double squared_decrement)
  {
    m_smallest_decrement = (std::min)(m_smallest_decrement, squared_decrement);
    m_is_noticed = false;
    if(++m_number_of_steps % number_of_steps != 0)
      return;
    m_is_noticed = m_energy - energy < 1e-3 * energy && m_smallest_decrement > 0.1 * m_previous_decrement;
    m_energy = energy;
    m_previous_decrement = m_smallest_decrement;
    m_smallest_decrement = std::numeric_limits<double>::infinity();
  }

  bool is_noticed() const { return m_is_noticed; } // by the last step

private:
  int m_number_of_steps = 0;
  double m_energy = std::numeric_limits<double>::infinity(); // ten steps ago
  double m_smallest_decrement = std::numeric_limits<double>::infinity();
  double m_previous_decrement = std::numeric_limits<double>::infinity();
  bool m_is_noticed = false;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STAGNATION_H
