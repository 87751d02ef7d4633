// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_ENERGY_SUM_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_ENERGY_SUM_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Distortion_derivatives_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Signed_singular_values_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Cell_packs_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/for_each_index.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// What one pass over the cells tells.
struct Energy_evaluation
{
  double energy = 0;                                                  // sum of weight times psi
  double smallest_determinant = std::numeric_limits<double>::infinity();
  std::size_t number_of_inverted_cells = 0;                           // det J <= 0, or not a number

  bool is_flip_free() const { return number_of_inverted_cells == 0; }
};

// The edge matrices U of the cells of a pack.
template <typename Positions>
Matrix_3<Pack> edge_matrix(const Positions& positions, const Cell_pack_3& pack)
{
  double edges[9][Pack::size];
  for(int lane = 0; lane < Pack::size; ++lane)
  {
    const double* const origin = positions.data() + 3 * std::size_t(pack.vertices[0][lane]);
    for(int k = 0; k < 3; ++k)
    {
      const double* const end = positions.data() + 3 * std::size_t(pack.vertices[k + 1][lane]);
      for(int i = 0; i < 3; ++i)
        edges[3 * k + i][lane] = end[i] - origin[i];
    }
  }
  Matrix_3<Pack> U;
  for(int i = 0; i < 9; ++i)
    U(i) = Pack::load(edges[i]);
  return U;
}

// The sum of psi over the cells as a function of the positions of all vertices.
template <typename ConcurrencyTag>
class Energy_sum_3
{
public:
  using Positions = Eigen::Matrix3Xd;

  explicit Energy_sum_3(const Cell_packs_3& packs) : m_packs(packs) {}

  template <typename Energy>
  Energy_evaluation evaluate(const Energy& energy, const Positions& u) const
  {
    std::vector<Energy_evaluation> parts(m_packs.number_of_chunks());
    for_each_index<ConcurrencyTag>(0, parts.size(), [&](const std::size_t chunk)
    {
      for(std::size_t p = m_packs.chunk_begin(chunk); p < m_packs.chunk_end(chunk); ++p)
        add_value(energy, u, m_packs[p], parts[chunk]);
    });

    Energy_evaluation result;
    for(const Energy_evaluation& part : parts)
    {
      result.energy += part.energy;
      result.smallest_determinant = (std::min)(result.smallest_determinant, part.smallest_determinant);
      result.number_of_inverted_cells += part.number_of_inverted_cells;
    }
    return result;
  }

  // The gradient by the free vertices, one column each.
  template <typename Energy>
  void compute_gradient(const Energy& energy, const Positions& u, Positions& gradient) const
  {
    gradient.setZero();
    for_each_pack_in_rounds([&](const Cell_pack_3& pack)
    {
      const Signed_singular_values_3<Pack> J = signed_singular_values_3<Pack>(edge_matrix(u, pack) * pack.inverse_source);
      scatter(pack, cell_gradient_3<Pack>(J.R, pack.weight * energy.gradient(J.s), pack.inverse_source * J.Q), gradient);
    });
  }

  // The gradient and the Hessian.
  template <typename Energy, typename NT>
  void assemble(const Energy& energy, const Positions& u, const double negative_curvature,
                Positions& gradient, Block_sparse_matrix_3<NT>& hessian) const
  {
    gradient.setZero(3, hessian.size());
    hessian.set_zero();
    for_each_pack_in_rounds([&](const Cell_pack_3& pack)
    {
      const Matrix_3<Pack> J = edge_matrix(u, pack) * pack.inverse_source;
      Cell_derivatives_3<Pack> cells;
      cell_derivatives_3(distortion_derivatives_3<Pack>(energy, J, negative_curvature),
                         pack.inverse_source, pack.weight, cells);
      scatter(pack, cells.gradient, gradient);
      scatter(pack, cells, hessian);
    });
    hessian.copy_upper_to_lower_triangle();
  }

private:
  // Calls f for each pack, such that its calls may add to the vertices of the pack.
  template <typename Function>
  void for_each_pack_in_rounds(const Function& f) const
  {
    for(std::size_t round = 0; round < m_packs.number_of_rounds(); ++round)
      for_each_index<ConcurrencyTag>(m_packs.round_begin(round), m_packs.round_begin(round + 1),
                                     [&](const std::size_t i)
      {
        const std::size_t chunk = m_packs.chunk_of_round(i);
        for(std::size_t p = m_packs.chunk_begin(chunk); p < m_packs.chunk_end(chunk); ++p)
          f(m_packs[p]);
      });
  }

  template <typename Energy>
  static void add_value(const Energy& energy, const Positions& u, const Cell_pack_3& pack,
                        Energy_evaluation& part)
  {
    const Matrix_3<Pack> J = edge_matrix(u, pack) * pack.inverse_source;
    const Vector_3<Pack> s = signed_singular_values_3<Pack>(J).s;
    const Pack determinant = s[0] * s[1] * s[2];
    part.energy += sum(pack.weight * energy.value(s));
    part.smallest_determinant = (std::min)(part.smallest_determinant, smallest(determinant));
    const Pack is_cell = select(pack.weight > Pack(0), Pack(1), Pack(0));
    part.number_of_inverted_cells
      += static_cast<std::size_t>(sum(select(determinant > Pack(0), Pack(0), is_cell)));
  }

  static void scatter(const Cell_pack_3& pack, const std::array<Vector_3<Pack>, 4>& cells, Positions& gradient)
  {
    for(int a = 0; a < 4; ++a)
    {
      double g[Pack::size][3];
      Pack::store_by_cells(cells[a].data(), g);
      for(int lane = 0; lane < Pack::size; ++lane)
        if(pack.blocks[a][a][lane] >= 0)
          for(int i = 0; i < 3; ++i)
            gradient(i, pack.vertices[a][lane]) += g[lane][i];
    }
  }

  // Fills the upper triangle only: the vertices of a cell are sorted.
  template <typename NT>
  static void scatter(const Cell_pack_3& pack, const Cell_derivatives_3<Pack>& cells,
                      Block_sparse_matrix_3<NT>& hessian)
  {
    for(int a = 0; a < 4; ++a)
      for(int b = a; b < 4; ++b)
      {
        double h[Pack::size][9];
        Pack::store_by_cells(cells.hessian[a][b].data(), h);
        for(int lane = 0; lane < Pack::size; ++lane)
          if(pack.blocks[a][b][lane] >= 0)
          {
            NT* const block = hessian.values(pack.blocks[a][b][lane]);
            for(int i = 0; i < 8; ++i) // a number that compilers vectorize
              block[i] += static_cast<NT>(h[lane][i]);
            block[8] += static_cast<NT>(h[lane][8]);
          }
      }
  }

  const Cell_packs_3& m_packs;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_ENERGY_SUM_3_H
