// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_ENERGY_EVALUATION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_ENERGY_EVALUATION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// What one pass over the cells tells.
struct Energy_evaluation
{
  double energy = 0;                                                  // sum of weight times psi
  double smallest_determinant = std::numeric_limits<double>::infinity();
  std::size_t number_of_inverted_cells = 0;                           // det J <= 0, or not a number

  bool is_flip_free() const { return number_of_inverted_cells == 0; }

  void add(const Energy_evaluation& other)
  {
    energy += other.energy;
    smallest_determinant = (std::min)(smallest_determinant, other.smallest_determinant);
    number_of_inverted_cells += other.number_of_inverted_cells;
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_ENERGY_EVALUATION_H
