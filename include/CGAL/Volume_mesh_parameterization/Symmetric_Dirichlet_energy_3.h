// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_SYMMETRIC_DIRICHLET_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_SYMMETRIC_DIRICHLET_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

The symmetric Dirichlet energy
\f$\psi = \sum_i (\sigma_i^2 + \sigma_i^{-2}) = |J|^2 + |J^{-1}|^2\f$
of Smith and Schaefer \cgalCite{cgal:ss-bpfb-15}, the sum of `Dirichlet_energy_3` and `Stretch_energy_3`.
It treats a map and its inverse alike.

Minimum: 6 at an isometry. It is not homogeneous: it compares lengths, with the volume of the source scaled
to that of the target. It tends to infinity when a cell collapses, and needs no further barrier.

Use it for maps that are as isometric as possible in both directions.

\cgalModels{DistortionEnergy_3}
*/
struct Symmetric_Dirichlet_energy_3
{
  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const { return s.squaredNorm() + s.cwiseInverse().squaredNorm(); }

  /// returns \f$\psi\f$ by \f$|J|^2\f$, \f$|J^{-1}|^2\f$ and \f$\det J\f$, without singular values.
  template <typename T>
  T value_of_norms(const T& squared, const T& inverse, const T&) const { return squared + inverse; }

  /// returns the derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const Eigen::Matrix<T, 3, 1> inverse = s.cwiseInverse();
    return T(2) * (s - inverse.cwiseProduct(inverse).cwiseProduct(inverse));
  }

  /// returns the second derivatives \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const Eigen::Matrix<T, 3, 1> inverse = s.cwiseInverse();
    const Eigen::Matrix<T, 3, 1> square = inverse.cwiseProduct(inverse);
    return (T(2) * Eigen::Matrix<T, 3, 1>::Ones() + T(6) * square.cwiseProduct(square)).asDiagonal();
  }
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_SYMMETRIC_DIRICHLET_ENERGY_3_H
