// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_ARAP_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_ARAP_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

The as-rigid-as-possible energy
\f$\psi = (\sigma_1 - 1)^2 + (\sigma_2 - 1)^2 + (\sigma_3 - 1)^2\f$ of
Chao et al.\ \cgalCite{cgal:cpss-sgmed-10}, the squared distance of the differential to the nearest rotation.

Minimum: 0 at an isometry. It is not homogeneous: it compares lengths, with the volume of the source scaled
to that of the target. It has no barrier: cells may collapse or invert, unless the step length or
`Barrier_energy_3` forbids it. It is smooth if \f$\sigma_2 + \sigma_3 > 0\f$, as in all cells
that are not inverted.

Use it for deformations that are close to rigid.

\cgalModels{DistortionEnergy_3}
*/
struct ARAP_energy_3
{
  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const { return (s - Eigen::Matrix<T, 3, 1>::Ones()).squaredNorm(); }

  /// returns the derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  { return T(2) * (s - Eigen::Matrix<T, 3, 1>::Ones()); }

  /// returns the second derivatives \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>&) const { return T(2) * Eigen::Matrix<T, 3, 3>::Identity(); }
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_ARAP_ENERGY_3_H
