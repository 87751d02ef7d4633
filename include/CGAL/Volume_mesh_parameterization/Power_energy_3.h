// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_POWER_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_POWER_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

A power of any energy that is not negative: \f$\psi = \psi_0^p\f$ with an integer \f$p \ge 2\f$.

The worst cells dominate the sum over the cells. A larger \f$p\f$ lowers the largest \f$\psi_0\f$, at the price of a higher mean.
For \f$p \to \infty\f$ the largest one is minimized. To lower the maximal distortion of angles, take the power of an energy that
measures angles.

The Hessian is positive semi-definite if that of \f$\psi_0\f$ is. It is homogeneous of degree
\f$d p\f$ if \f$\psi_0\f$ is so of degree \f$d\f$, and has its minima at the same singular values.

The power widens the range of the values and, about as much, the condition number of the linear systems.
Small exponents such as 2 to 5 have most of the effect. Values above
\f$10^{308/p}\f$ overflow; solvers in single precision stand \f$10^{30/p}\f$.

\tparam Energy a model of `DistortionEnergy_3` whose values are not negative

\cgalModels{DistortionEnergy_3}
*/
template <typename Energy>
class Power_energy_3
{
public:
  /// constructs the power.
  ///
  /// \param exponent the number \f$p\f$
  /// \param energy the energy \f$\psi_0\f$
  /// \pre `exponent >= 2`
  explicit Power_energy_3(const int exponent = 2, const Energy& energy = Energy()) : m_energy(energy), m_exponent(exponent)
  { internal::require(exponent >= 2, "exponent must be at least 2."); }

  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const { return power(m_energy.value(s), m_exponent); }

  /// returns the derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  { return T(m_exponent) * power(m_energy.value(s), m_exponent - 1) * m_energy.gradient(s); }

  /// returns the second derivatives \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const T value = m_energy.value(s);
    const Eigen::Matrix<T, 3, 1> g = m_energy.gradient(s);
    const Eigen::Matrix<T, 3, 3> H = value * m_energy.hessian(s) + T(m_exponent - 1) * g * g.transpose();
    return T(m_exponent) * power(value, m_exponent - 2) * H;
  }

private:
  template <typename T>
  static T power(const T& x, const int n)
  {
    T result(1);
    for(int i = 0; i < n; ++i)
      result *= x;
    return result;
  }

  Energy m_energy;
  int m_exponent;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_POWER_ENERGY_3_H
