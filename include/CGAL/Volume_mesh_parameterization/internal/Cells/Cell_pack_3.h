// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_CELL_PACK_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_CELL_PACK_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// Numbers of several cells side by side: as many as the longest vector instructions take in two registers.
constexpr int cells_per_pack = 16;
using Packed_number = double[cells_per_pack];
using Packed_vector_3 = double[3][cells_per_pack];
using Packed_matrix_3 = double[9][cells_per_pack]; // by columns

// Several cells, with all that an evaluation needs of them. A cell that only fills up the last pack repeats another
// one with weight 0, and none of its vertices is unknown. It begins with a line of the cache.
struct alignas(64) Cell_pack_3
{
  using Indices = std::array<int, cells_per_pack>;

  Packed_matrix_3 inverse_source;   // X^{-1}, times the factor that gives both meshes one volume
  Packed_number weight;
  std::array<Indices, 4> vertices;  // sorted by rows, which changes the orientation, but not J
  std::array<Indices, 4> rows;      // of the matrix; -1 if the vertex is not unknown
  std::array<Indices, 10> blocks;   // the positions in the matrix of the pairs a <= b; -1 if a vertex is not unknown

  static constexpr int index_of_block(const int a, const int b) { return a * (7 - a) / 2 + b; }
};

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

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_CELL_PACK_3_H
