// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_LPM_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_LPM_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

The energy of length preserving maps,
\f$\psi = (\sigma_1^2 - 1)^2 + (\sigma_2^2 - 1)^2 + (\sigma_3^2 - 1)^2 = |J^T J|^2 - 2\,|J|^2 + 3\f$
in the form of Jin et al.\ \cgalCite{cgal:jqzctz-smvp-15}, equation (6).

Minimum: 0 at an isometry. It is not homogeneous: it compares lengths, with the volume of the source scaled
to that of the target. It has no barrier, and a collapsed cell has an energy of at most 3. Therefore, cells may collapse or
invert, unless the step length or `Barrier_energy_3` forbids it.

Use it if lengths must not grow: unlike `ARAP_energy_3`, it grows with the fourth power.

\cgalModels{DistortionEnergy_3}
*/
struct LPM_energy_3
{
  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const
  { return (s.cwiseProduct(s) - Eigen::Matrix<T, 3, 1>::Ones()).squaredNorm(); }

  /// returns the derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  { return T(4) * s.cwiseProduct(s.cwiseProduct(s) - Eigen::Matrix<T, 3, 1>::Ones()); }

  /// returns the second derivatives \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  { return (T(12) * s.cwiseProduct(s) - T(4) * Eigen::Matrix<T, 3, 1>::Ones()).asDiagonal(); }
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_LPM_ENERGY_3_H
