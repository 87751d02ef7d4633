// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDED_ANGLE_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDED_ANGLE_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

Any energy, plus a barrier that bounds the distortion of angles \f$k = \sigma_1/\sigma_3 + \sigma_3/\sigma_1\f$ (see
`Distortion_3`) of each cell by \f$K\f$:
\f[ \psi = \psi_0 + \sum_{i<j} \varphi\left(2 - 2\,\frac{k_{ij}}{K}\right), \qquad
    k_{ij} = \frac{\sigma_i}{\sigma_j} + \frac{\sigma_j}{\sigma_i}, \f]
with the inverse spline \f$\varphi\f$ of `Barrier_energy_3`. The largest \f$k_{ij}\f$ is \f$k\f$, which has kinks at equal
singular values. The sum over all pairs has no kinks: it is twice continuously differentiable. It is equal to \f$\psi_0\f$ if
\f$k \le K/2\f$, finite if \f$k < K\f$, and infinite otherwise. The minimization accepts only steps that lower the energy.
Therefore, it never exceeds the bound if it starts below it.

For a start above the bound, \f$\varphi\f$ can be relaxed: below an argument \f$\varepsilon > 0\f$, the function is
continued by the parabola that touches it there. Then the energy is finite, and the minimization leads from a map above the bound
to a map below or slightly above the bound. The excess decreases with \f$\varepsilon\f$. The result reports whether the bound is
met. If no argument is below \f$\varepsilon\f$, the relaxation has made no difference.

A facet with three prescribed vertices limits the bound: the distortion in its cell is not below the distortion of the facet.
Cells whose four vertices are prescribed are not influenced at all.

The energy tends to infinity when a cell becomes flat, and when a cell collapses if \f$\psi_0\f$ does.

Use it if angles matter more than the mean of \f$\psi_0\f$. The closer \f$K\f$ is to what is
possible, the more Newton steps are needed. The named parameter `maximum_angle_distortion` relaxes the
barrier as long as it has to, and not at all in the end.

\tparam Energy a model of `DistortionEnergy_3`

\cgalModels{DistortionEnergy_3}
*/
template <typename Energy>
class Bounded_angle_energy_3
{
public:
  /// constructs the sum.
  ///
  /// \param bound the number \f$K\f$
  /// \param energy the energy \f$\psi_0\f$
  /// \param relaxation the number \f$\varepsilon\f$; 0 for the barrier as it is
  /// \pre `bound > 2` and `0 <= relaxation && relaxation < 1`
  explicit Bounded_angle_energy_3(const double bound, const Energy& energy = Energy(), const double relaxation = 0.05)
    : m_energy(energy), m_slope(-2 / bound), m_relaxation(relaxation)
  {
    internal::require(bound > 2 && 0 <= relaxation && relaxation < 1,
                      "bound must be larger than 2, and relaxation in [0, 1).");
  }

  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const
  {
    T result = m_energy.value(s);
    for(int i = 0; i < 3; ++i)
      result += barrier(s[i], s[(i + 1) % 3]).value;
    return result;
  }

  /// returns the derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  {
    Eigen::Matrix<T, 3, 1> result = m_energy.gradient(s);
    for(int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const T first = T(m_slope) * barrier(s[i], s[j]).first;
      result[i] += first * derivative(s[i], s[j]);
      result[j] += first * derivative(s[j], s[i]);
    }
    return result;
  }

  /// returns the second derivatives \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  {
    Eigen::Matrix<T, 3, 3> H = m_energy.hessian(s);
    for(int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const internal::Inverse_spline_barrier<T> phi = barrier(s[i], s[j]);
      const T first = T(m_slope) * phi.first;
      const T second = T(m_slope * m_slope) * phi.second;
      const T by_i = derivative(s[i], s[j]), by_j = derivative(s[j], s[i]);
      const T mixed = second * by_i * by_j - first * (T(1) / (s[i] * s[i]) + T(1) / (s[j] * s[j]));
      H(i, i) += second * by_i * by_i + first * T(2) * s[j] / (s[i] * s[i] * s[i]);
      H(j, j) += second * by_j * by_j + first * T(2) * s[i] / (s[j] * s[j] * s[j]);
      H(i, j) += mixed;
      H(j, i) += mixed;
    }
    return H;
  }

private:
  template <typename T>
  internal::Inverse_spline_barrier<T> barrier(const T& a, const T& b) const
  {
    const T argument = T(2) + T(m_slope) * (a / b + b / a);
    return internal::Inverse_spline_barrier<T>::relaxed(argument, T(m_relaxation));
  }

  // Returns the derivative of a / b + b / a by a.
  template <typename T>
  static T derivative(const T& a, const T& b) { return (a - b) * (a + b) / (a * a * b); }

  Energy m_energy;
  double m_slope; // derivative of the argument of phi by k
  double m_relaxation;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDED_ANGLE_ENERGY_3_H
