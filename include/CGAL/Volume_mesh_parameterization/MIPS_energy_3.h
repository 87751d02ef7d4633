// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MIPS_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MIPS_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

The energy of most isometric parameterizations (MIPS) \cgalCite{cgal:hg-mipsp-00}, in the form for
volumes of Fu et al.\ \cgalCite{cgal:flg-clbmi-15},
\f$\psi = \frac{1}{8}\left(\frac{\sigma_1}{\sigma_2} + \frac{\sigma_2}{\sigma_1}\right)
                     \left(\frac{\sigma_2}{\sigma_3} + \frac{\sigma_3}{\sigma_2}\right)
                     \left(\frac{\sigma_3}{\sigma_1} + \frac{\sigma_1}{\sigma_3}\right)
        = \frac{1}{8}\left(|J|^2\,|J^{-1}|^2 - 1\right)\f$.

Minimum: 1 at a similarity. It is homogeneous of degree 0: it measures angles only, and neither it nor
its minimizer depends on the scale of a cell. It tends to infinity when a cell becomes flat.

It bounds the ratio \f$r = \sigma_1/\sigma_3\f$ of the largest to the smallest singular value of a cell:
with \f$k = r + 1/r\f$, \f$\;k (k + 2) / 8 \le \psi \le k^2 / 4\f$. The lower bound is attained for
\f$\sigma_2^2 = \sigma_1 \sigma_3\f$, the upper one where two singular values are equal.

Use it for maps that preserve angles. Volumes may change by any factor.

\cgalModels{DistortionEnergy_3}
*/
struct MIPS_energy_3
{
  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const
  { return T(0.125) * (s.squaredNorm() * s.cwiseInverse().squaredNorm() - T(1)); }

  /// returns \f$\psi\f$ by \f$|J|^2\f$, \f$|J^{-1}|^2\f$ and \f$\det J\f$, without singular values.
  template <typename T>
  T value_of_norms(const T& squared, const T& inverse, const T&) const { return T(0.125) * (squared * inverse - T(1)); }

  /// returns the derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const Eigen::Matrix<T, 3, 1> inverse = s.cwiseInverse();
    const Eigen::Matrix<T, 3, 1> cube = inverse.cwiseProduct(inverse).cwiseProduct(inverse);
    return T(0.25) * (inverse.squaredNorm() * s - s.squaredNorm() * cube);
  }

  /// returns the second derivatives \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const Eigen::Matrix<T, 3, 1> inverse = s.cwiseInverse();
    const Eigen::Matrix<T, 3, 1> square = inverse.cwiseProduct(inverse);
    const Eigen::Matrix<T, 3, 1> cube = square.cwiseProduct(inverse);
    Eigen::Matrix<T, 3, 3> H = T(-0.5) * (s * cube.transpose() + cube * s.transpose());
    H.diagonal() += T(0.75) * s.squaredNorm() * square.cwiseProduct(square)
                  + T(0.25) * inverse.squaredNorm() * Eigen::Matrix<T, 3, 1>::Ones();
    return H;
  }
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MIPS_ENERGY_3_H
