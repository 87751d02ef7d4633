// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_BOUNDED_CELL_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_BOUNDED_CELL_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Bounded_angle_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>

#include <Eigen/Core>

namespace CGAL::Volume_mesh_parameterization::internal {

// An energy that is zero: what an adapter adds to it is the adapter alone.
struct Zero_energy_3
{
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>&) const { return T(0); }
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>&) const { return Eigen::Matrix<T, 3, 1>::Constant(T(0)); }
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>&) const { return Eigen::Matrix<T, 3, 3>::Constant(T(0)); }
};

// `Bounded_angle_energy_3` of an energy whose type is not known any more.
class Bounded_cell_energy_3 final : public Cell_energy_3
{
public:
  Bounded_cell_energy_3(const double bound, const Cell_energy_3& energy, const double relaxation)
    : m_energy(energy), m_barrier(Bounded_angle_energy_3<Zero_energy_3>(bound, Zero_energy_3(), relaxation))
  {}

  void value(const Packed_vector_3& s, Packed_number& psi) const override
  {
    Packed_number barrier;
    m_energy.value(s, psi);
    m_barrier.value(s, barrier);
    add(barrier, psi);
  }

  void gradient(const Packed_vector_3& s, Packed_vector_3& g) const override
  {
    Packed_vector_3 of_barrier;
    m_energy.gradient(s, g);
    m_barrier.gradient(s, of_barrier);
    for(int i = 0; i < 3; ++i)
      add(of_barrier[i], g[i]);
  }

  void derivatives(const Packed_vector_3& s, Packed_vector_3& g, Packed_matrix_3& H) const override
  {
    Packed_vector_3 g_of_barrier;
    Packed_matrix_3 H_of_barrier;
    m_energy.derivatives(s, g, H);
    m_barrier.derivatives(s, g_of_barrier, H_of_barrier);
    for(int i = 0; i < 3; ++i)
      add(g_of_barrier[i], g[i]);
    for(int i = 0; i < 9; ++i)
      add(H_of_barrier[i], H[i]);
  }

private:
  static void add(const Packed_number& from, Packed_number& to)
  {
    for(int cell = 0; cell < cells_per_pack; ++cell)
      to[cell] += from[cell];
  }

  const Cell_energy_3& m_energy;
  Cell_energy_of<Bounded_angle_energy_3<Zero_energy_3> > m_barrier;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELLS_BOUNDED_CELL_ENERGY_3_H
