// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_STRETCH_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_STRETCH_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

The \f$L^2\f$ stretch energy \f$\psi = \sigma_1^{-2} + \sigma_2^{-2} + \sigma_3^{-2} = |J^{-1}|^2\f$
of Jin et al.\ \cgalCite{cgal:jqzctz-smvp-15}, equation (4).

Minimum for prescribed volume: 3 at an isometry. It is homogeneous of degree -2: its minimizer does not depend on
the scale of source and target. It tends to infinity when a cell becomes flat, and needs no further barrier.

Use it if no direction may be compressed too much. It is the default, and a compromise between angles and volumes.

\cgalModels{DistortionEnergy_3}
*/
struct Stretch_energy_3
{
  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const { return s.cwiseInverse().squaredNorm(); }

  /// returns \f$\psi\f$ by \f$|J|^2\f$, \f$|J^{-1}|^2\f$ and \f$\det J\f$, without singular values.
  template <typename T>
  T value_of_norms(const T&, const T& inverse, const T&) const { return inverse; }

  /// returns the derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const Eigen::Matrix<T, 3, 1> inverse = s.cwiseInverse();
    return T(-2) * inverse.cwiseProduct(inverse).cwiseProduct(inverse);
  }

  /// returns the second derivatives \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const Eigen::Matrix<T, 3, 1> inverse = s.cwiseInverse();
    const Eigen::Matrix<T, 3, 1> square = inverse.cwiseProduct(inverse);
    return (T(6) * square.cwiseProduct(square)).asDiagonal();
  }
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_STRETCH_ENERGY_3_H
