// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDED_ANGLE_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDED_ANGLE_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Inverse_spline_barrier.h>

#include <CGAL/assertions.h>

#include <Eigen/Dense>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

Any energy, plus a barrier that keeps the distortion of angles bounded: \f$r = \sigma_1/\sigma_3\f$, the
ratio of the largest to the smallest singular value, stays below \f$K\f$ in every cell.

The ratio itself has kinks where singular values are equal. The barrier acts on a smooth and symmetric
measure instead, the energy \f$m = (|J|^2\,|J^{-1}|^2 - 1)/8\f$ of `MIPS_energy_3`. With
\f$k(r) = r + 1/r\f$, the distortion of angles of `Distortion_3`, it satisfies
\f$k (k + 2)/8 \le m \le k^2/4\f$. So
\f[ m < M = \tfrac{1}{8}\, k(K)\,(k(K) + 2) \quad\Rightarrow\quad r < K, \f]
and every cell with \f$k(r) < k(K)/\sqrt{2}\f$ satisfies \f$m < M\f$: what is asked for is stricter than
the bound by at most the factor \f$\sqrt{2}\f$, and not at all where \f$\sigma_2^2 = \sigma_1 \sigma_3\f$.

The energy is \f$\psi = \psi_0 + w\,\varphi\left(\frac{M - m}{M - M/4}\right)\f$ with the inverse spline
\f$\varphi\f$ of `Barrier_energy_3`. It is twice continuously differentiable, and equal to \f$\psi_0\f$ where
\f$m \le M/4\f$, for instance where \f$k(r) \le k(K)/\sqrt{8}\f$. Where less than 1/20 of the way from
there to \f$M\f$ is left, \f$\varphi\f$ is continued by the parabola that touches it there. So the energy is finite, the
minimization may start from a map that exceeds the bound, and leads below it if it can. If it
cannot, \f$m\f$ exceeds \f$M\f$ by little. Whether the bound is met is told by the result: then its maximal
distortion of angles is below \f$k(K)\f$.

A facet with three prescribed vertices limits what can be asked for: the ratio in its cell is not
below the one of the singular values of the map of the facet. Cells whose four vertices are prescribed
are not influenced at all.

It tends to infinity when a cell becomes flat, and when it collapses if \f$\psi_0\f$ does.

To be used where angles matter more than the mean of \f$\psi_0\f$. The closer \f$K\f$ is to what is
possible, the more Newton steps are needed.

\tparam Energy a model of `DistortionEnergy_3`

\cgalModels{DistortionEnergy_3}
*/
template <typename Energy>
class Bounded_angle_energy_3
{
public:
  static constexpr bool has_barrier = true; ///< true: the energy of a flat cell is infinite

  /// constructs the sum.
  ///
  /// \param bound the number \f$K\f$
  /// \param energy the energy \f$\psi_0\f$
  /// \param weight the number \f$w\f$; a larger one keeps cells farther away from the bound
  /// \pre `bound > 1` and `weight > 0`
  explicit Bounded_angle_energy_3(const double bound, const Energy& energy = Energy(),
                                  const double weight = 1)
    : m_energy(energy), m_limit(limit(bound)), m_weight(weight)
  {
    CGAL_precondition(bound > 1 && weight > 0);
  }

  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const
  {
    return m_energy.value(s) + T(m_weight) * barrier(s).value;
  }

  /// returns the derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  {
    return m_energy.gradient(s) + T(m_weight * slope()) * barrier(s).first * MIPS_energy_3().gradient(s);
  }

  /// returns the second derivatives \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const internal::Inverse_spline_barrier<T> phi = barrier(s);
    const T first = T(m_weight * slope()) * phi.first;
    const T second = T(m_weight * slope() * slope()) * phi.second;
    const Eigen::Matrix<T, 3, 1> g = MIPS_energy_3().gradient(s);
    return m_energy.hessian(s) + first * MIPS_energy_3().hessian(s) + second * g * g.transpose();
  }

private:
  static constexpr double onset = 0.25;      // part of the limit from which on the barrier acts
  static constexpr double relaxation = 0.05; // argument of phi below which its parabola is taken

  // M, the value of the MIPS energy that the ratio K implies
  static double limit(const double bound)
  {
    const double k = bound + 1 / bound;
    return k * (k + 2) / 8;
  }

  // the derivative of the argument of phi by m
  double slope() const { return -1 / ((1 - onset) * m_limit); }

  template <typename T>
  internal::Inverse_spline_barrier<T> barrier(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const T argument = T(slope()) * (MIPS_energy_3().value(s) - T(m_limit));
    return internal::Inverse_spline_barrier<T>::relaxed(argument, T(relaxation));
  }

  Energy m_energy;
  double m_limit, m_weight;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDED_ANGLE_ENERGY_3_H
