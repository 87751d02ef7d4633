// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_SUMS_OVER_CELLS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_SUMS_OVER_CELLS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_kernels_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Cell_packs_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The sum of an energy over the cells as a function of the positions `u` of all vertices, and what else takes a pass over
// the cells: those that this process owns.
inline Energy_evaluation evaluate_energy(const Cell_packs_3& packs, const Cell_energy_3& energy, const Matrix3Xd& u)
{
  const Cell_kernels_3& kernels = cell_kernels_3();
  std::vector<Energy_evaluation> parts(packs.number_of_own_chunks());
  for_each_index(packs.is_parallel(), 0, parts.size(), [&](const std::size_t chunk)
  { kernels.evaluate(packs.chunk_begin(chunk), packs.chunk_end(chunk), u.data(), energy, parts[chunk]); });
  Energy_evaluation result;
  for(const Energy_evaluation& part : parts)
    result.add(part);
  return result;
}

// Calls f for each chunk of packs, such that its calls may add to the rows of the chunk.
template <typename Function>
void for_each_chunk_in_rounds(const Cell_packs_3& packs, const Function& f)
{
  for(std::size_t round = 0; round < packs.number_of_rounds(); ++round)
    for_each_index(packs.is_parallel(), packs.round_begin(round), packs.round_begin(round + 1),
                   [&](const std::size_t i) { f(packs.chunk_of_round(i)); });
}

// Adds the gradient by the unknown vertices, one column a row.
inline void add_energy_gradient(const Cell_packs_3& packs, const Cell_energy_3& energy, const Matrix3Xd& u,
                                Matrix3Xd& gradient)
{
  const Cell_kernels_3& kernels = cell_kernels_3();
  for_each_chunk_in_rounds(packs, [&](const std::size_t chunk)
  { kernels.add_gradient(packs.chunk_begin(chunk), packs.chunk_end(chunk), u.data(), energy, gradient.data()); });
}

// The gradient and the Hessian, of which the part `negative_curvature` of negative eigenvalues in each cell is kept.
template <typename NT>
void assemble_energy(const Cell_packs_3& packs, const Cell_energy_3& energy, const Matrix3Xd& u,
                     const double negative_curvature, Matrix3Xd& gradient, Block_sparse_matrix_3<NT>& hessian)
{
  const auto add_derivatives = std::get<Cell_kernels_3::Add_derivatives<NT> >(cell_kernels_3().add_derivatives);
  gradient.setZero(3, hessian.size());
  constexpr int rows_per_range = 1024; // a guess: a range takes some ten microseconds
  for_each_in_ranges(packs.is_parallel(), hessian.size(), rows_per_range, [&](const int row) { hessian.set_zero(row); });
  for_each_chunk_in_rounds(packs, [&](const std::size_t chunk)
  {
    add_derivatives(packs.chunk_begin(chunk), packs.chunk_end(chunk), u.data(), energy, negative_curvature,
                    gradient.data(), hessian.values(0));
  });
  for_each_in_ranges(packs.is_parallel(), hessian.size(), rows_per_range,
                     [&](const int row) { hessian.complete_row(row); });
}

// The largest t in [0, 1] for which u + t d inverts no cell, if u inverts none.
inline double largest_step_3(const Cell_packs_3& packs, const Matrix3Xd& u, const Matrix3Xd& d)
{
  const Cell_kernels_3& kernels = cell_kernels_3();
  std::vector<double> parts(packs.number_of_own_chunks(), 1.);
  for_each_index(packs.is_parallel(), 0, parts.size(), [&](const std::size_t chunk)
  { parts[chunk] = kernels.largest_step(packs.chunk_begin(chunk), packs.chunk_end(chunk), u.data(), d.data()); });
  return std::accumulate(parts.begin(), parts.end(), 1., [](double a, double b) { return (std::min)(a, b); });
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_SUMS_OVER_CELLS_3_H
