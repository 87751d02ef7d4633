// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_DIRICHLET_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_DIRICHLET_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

The Dirichlet energy \f$\psi = \sigma_1^2 + \sigma_2^2 + \sigma_3^2 = |J|^2\f$, for volumes used by
Wang et al.\ \cgalCite{cgal:wgy-vhm-04}. Its minimizers are the harmonic maps.

Minimum: 0 at a collapsed cell. It is homogeneous of degree 2: its minimizer does not depend on the scale of source
and target. It has no barrier: cells may collapse or invert, unless the step length or `Barrier_energy_3` forbids it.

Use it for smooth maps if the distortion does not matter much, and as a part of other energies.

\cgalModels{DistortionEnergy_3}
*/
struct Dirichlet_energy_3
{
  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const { return s.squaredNorm(); }

  /// returns \f$\psi\f$ by \f$|J|^2\f$, \f$|J^{-1}|^2\f$ and \f$\det J\f$, without singular values.
  template <typename T>
  T value_of_norms(const T& squared, const T&, const T&) const { return squared; }

  /// returns the derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const { return T(2) * s; }

  /// returns the second derivatives \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>&) const { return T(2) * Eigen::Matrix<T, 3, 3>::Identity(); }
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DIRICHLET_ENERGY_3_H
