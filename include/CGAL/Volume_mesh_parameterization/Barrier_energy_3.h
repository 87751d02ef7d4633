// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BARRIER_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BARRIER_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>
#include <CGAL/Volume_mesh_parameterization/select.h>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

// Function phi(x) = 1 / g(x) - 1 with the spline g(x) = 1 - (1 - x)^3 of Schueller et al., Locally Injective Mappings (CGF
// 2013), and its derivatives. For x -> 0+ phi tends to infinity, and phi(x) = 0 for x >= 1; phi is twice continuously
// differentiable.
template <typename T>
struct Inverse_spline_barrier
{
  T value, first, second;

  explicit Inverse_spline_barrier(const T& argument)
  {
    const T x = minimum(argument, T(1));
    const T y = T(1) - x;
    const T inverse = T(1) / (x * (T(1) + y + y * y)); // 1 / g, without cancellation
    const T slope = T(3) * y * y;                      // g'
    value = y * y * y * inverse;
    first = -slope * inverse * inverse;
    second = T(2) * slope * slope * inverse * inverse * inverse + T(6) * y * inverse * inverse;
  }

  // Returns phi, replaced by the parabola that touches phi at `smallest` below there, which is finite everywhere. For
  // `smallest` = 0 the result is phi itself, which is not finite at 0 and below.
  static Inverse_spline_barrier relaxed(const T& x, const T& smallest)
  {
    Inverse_spline_barrier result(maximum(x, smallest));
    const T distance = minimum(x - smallest, T(0));
    result.value += distance * (result.first + T(0.5) * distance * result.second);
    result.first += distance * result.second;
    return result;
  }
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

Any energy, plus the barrier of Schueller et al.\ \cgalCite{cgal:skps-lim-13} against collapsing cells:
\f$\psi = \psi_0 + \beta\,\varphi(D / \lambda)\f$ with \f$D = \sigma_1 \sigma_2 \sigma_3\f$ and the inverse
spline \f$\varphi(x) = 1 / (1 - (1 - x)^3) - 1\f$ for \f$0 < x < 1\f$, \f$\varphi(x) = 0\f$ for \f$x \ge 1\f$.
It is twice continuously differentiable. For \f$D \to 0\f$ it grows like \f$\beta\lambda / (3 D)\f$; it is
meaningless for \f$D \le 0\f$.

The defaults are the parameters of Jin et al.\ \cgalCite{cgal:jqzctz-smvp-15}, section 5, with \f$\beta = 0.01\f$. Let \f$V_D\f$
and \f$V_M\f$ be the volumes of target and source. The barrier acts on cells with less than \f$V_D / V_M\f$ times their volume in
the source. As both meshes are scaled to one volume before \f$D\f$ is computed, this is \f$\lambda = 1\f$.

If no cell shrinks, the values are those of \f$\psi_0\f$. The sum is not homogeneous.

Use it with energies that have no barrier of their own.

\tparam Energy a model of `DistortionEnergy_3`

\cgalModels{DistortionEnergy_3}
*/
template <typename Energy>
class Barrier_energy_3
{
public:
  /// constructs the sum.
  ///
  /// \param energy the energy \f$\psi_0\f$
  /// \param beta the weight \f$\beta\f$ of the barrier
  /// \param lambda the change of volume \f$\lambda\f$ below which the barrier begins
  /// \pre `beta > 0` and `lambda > 0`
  explicit Barrier_energy_3(const Energy& energy = Energy(), const double beta = 0.01, const double lambda = 1)
    : m_energy(energy), m_beta(beta), m_lambda(lambda)
  { internal::require(beta > 0 && lambda > 0, "beta and lambda must be positive."); }

  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const { return m_energy.value(s) + T(m_beta) * barrier(s).value; }

  /// returns the derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  { return m_energy.gradient(s) + T(m_beta / m_lambda) * barrier(s).first * cofactors(s); }

  /// returns the second derivatives \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const internal::Inverse_spline_barrier<T> phi = barrier(s);
    const T first = T(m_beta / m_lambda) * phi.first;
    const T second = T(m_beta / (m_lambda * m_lambda)) * phi.second;
    const Eigen::Matrix<T, 3, 1> c = cofactors(s);

    Eigen::Matrix<T, 3, 3> H = m_energy.hessian(s);
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        H(i, j) += second * c[i] * c[j] + (i == j ? T(0) : first * s[3 - i - j]);
    return H;
  }

private:
  template <typename T>
  internal::Inverse_spline_barrier<T> barrier(const Eigen::Matrix<T, 3, 1>& s) const
  { return internal::Inverse_spline_barrier<T>(s[0] * s[1] * s[2] * T(1 / m_lambda)); }

  // Returns the derivative of D by the singular values.
  template <typename T>
  static Eigen::Matrix<T, 3, 1> cofactors(const Eigen::Matrix<T, 3, 1>& s)
  { return Eigen::Matrix<T, 3, 1>(s[1] * s[2], s[2] * s[0], s[0] * s[1]); }

  Energy m_energy;
  double m_beta, m_lambda;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BARRIER_ENERGY_3_H
