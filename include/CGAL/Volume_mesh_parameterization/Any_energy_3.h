// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_ANY_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_ANY_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_energy_3.h>

#include <memory>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

An energy whose type is chosen when the program runs. It holds a copy of a model of `DistortionEnergy_3`. One virtual call
evaluates the energy of several cells. Map and running time do not change. The functions that take an energy are compiled once
for all energies. Copies share the energy that they hold.

Use it if the energy is read from a file or a command line, or to shorten compilation.

\cgalModels{DistortionEnergy_3}
*/
class Any_energy_3
{
public:
  /// holds a copy of `energy`.
  ///
  /// \tparam Energy a model of `DistortionEnergy_3`
  template <typename Energy>
  Any_energy_3(const Energy& energy) : m_energy(std::make_shared<internal::Cell_energy_of<Energy> >(energy)) {}

  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const Cells<T> cells(s);
    internal::Packed_number psi;
    m_energy->value(cells.s, psi);
    return load<T>(psi);
  }

  /// returns the derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const Cells<T> cells(s);
    internal::Packed_vector_3 g;
    m_energy->gradient(cells.s, g);
    return Eigen::Matrix<T, 3, 1>(load<T>(g[0]), load<T>(g[1]), load<T>(g[2]));
  }

  /// returns the second derivatives \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const Cells<T> cells(s);
    internal::Packed_vector_3 g;
    internal::Packed_matrix_3 H;
    m_energy->derivatives(cells.s, g, H);
    Eigen::Matrix<T, 3, 3> result;
    for(int i = 0; i < 9; ++i)
      result(i) = load<T>(H[i]);
    return result;
  }

#ifndef DOXYGEN_RUNNING
  explicit Any_energy_3(std::shared_ptr<const internal::Cell_energy_3> energy) : m_energy(std::move(energy)) {}

  friend const internal::Cell_energy_3& cell_energy_3(const Any_energy_3& energy) { return *energy.m_energy; }
#endif

private:
  // Singular values, repeated for all cells of a pack.
  template <typename T>
  struct Cells
  {
    internal::Packed_vector_3 s;

    explicit Cells(const Eigen::Matrix<T, 3, 1>& values)
    {
      for(int i = 0; i < 3; ++i)
        if constexpr(std::is_same_v<T, double>)
          std::fill_n(s[i], internal::cells_per_pack, values[i]);
        else
          for(int first = 0; first < internal::cells_per_pack; first += T::size)
            values[i].store(s[i] + first);
    }
  };

  template <typename T>
  static T load(const internal::Packed_number& numbers)
  {
    if constexpr(std::is_same_v<T, double>)
      return numbers[0];
    else
      return T::load(numbers);
  }

  std::shared_ptr<const internal::Cell_energy_3> m_energy;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_ANY_ENERGY_3_H
