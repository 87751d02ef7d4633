// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_LP_STRETCH_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_LP_STRETCH_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>
#include <CGAL/Volume_mesh_parameterization/select.h>

#include <cmath>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

The squared \f$L^p\f$ stretch, of which Jin et al.\ \cgalCite{cgal:jqzctz-smvp-15}, section 3.2, have the case
\f$p = 2\f$,
\f$\psi = \left(|\sigma_1|^{-p} + |\sigma_2|^{-p} + |\sigma_3|^{-p}\right)^{2/p}\f$, \f$p \ge 2\f$.
For \f$p = 2\f$ it is `Stretch_energy_3`; for large \f$p\f$ it approaches the square of the
\f$L^\infty\f$ stretch \f$1/\min_i |\sigma_i|\f$, from above and within a factor \f$3^{2/p}\f$.

It is homogeneous of degree -2 for every \f$p\f$: its minimizer does not depend on the scale of source
and target. Minimum for prescribed volume: \f$3^{2/p}\f$ at an isometry. It tends to infinity when a
cell collapses, and needs no further barrier.

The root keeps the range of the values independent of \f$p\f$: nothing overflows for large \f$p\f$. It
concerns each cell by itself; with `Power_energy_3` the maximum over the cells can be approached, too.

Use it if only the strongest compression in a cell matters. The larger \f$p\f$, the more Newton steps are needed.

\cgalModels{DistortionEnergy_3}
*/
class Lp_stretch_energy_3
{
public:
  /// constructs the energy for this \f$p\f$.
  /// \pre `p >= 2`
  explicit Lp_stretch_energy_3(const double p = 8) : m_p(p)
  { internal::require(p >= 2, "p must be at least 2."); }

  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const
  {
    using std::exp;
    using std::log;
    const Powers<T> powers(s, m_p);
    return powers.largest * exp(T(2 / m_p) * log(powers.sum));
  }

  /// returns the derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  { return T(-2) * value(s) * Powers<T>(s, m_p).shares().cwiseProduct(s.cwiseInverse()); }

  /// returns the second derivatives \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const Eigen::Matrix<T, 3, 1> inverse = s.cwiseInverse();
    const Eigen::Matrix<T, 3, 1> share = Powers<T>(s, m_p).shares();
    const Eigen::Matrix<T, 3, 1> quotient = share.cwiseProduct(inverse);
    Eigen::Matrix<T, 3, 3> H = T(4 - 2 * m_p) * quotient * quotient.transpose();
    H.diagonal() += T(2 + 2 * m_p) * quotient.cwiseProduct(inverse);
    return value(s) * H;
  }

private:
  // Powers |s_i|^{-p}, divided by the largest one, which keeps them between 0 and 1.
  template <typename T>
  struct Powers
  {
    T largest; // largest square s_i^{-2}
    Eigen::Matrix<T, 3, 1> power;
    T sum;

    Powers(const Eigen::Matrix<T, 3, 1>& s, const double p)
    {
      using std::exp;
      using std::log;
      const Eigen::Matrix<T, 3, 1> square = s.cwiseProduct(s);
      const T smallest = minimum(square[0], minimum(square[1], square[2]));
      largest = T(1) / smallest;
      for(int i = 0; i < 3; ++i)
        power[i] = exp(T(p / 2) * log(smallest / square[i]));
      sum = power.sum();
    }

    Eigen::Matrix<T, 3, 1> shares() const { return power / sum; }
  };

  double m_p;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_LP_STRETCH_ENERGY_3_H
