// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_LSCM_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_LSCM_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

The energy of least squares conformal maps,
\f$\psi = (\sigma_1^2 - \sigma_2^2)^2 + (\sigma_2^2 - \sigma_3^2)^2 + (\sigma_3^2 - \sigma_1^2)^2
        = 3\,|J^T J|^2 - |J|^4\f$
in the form of Jin et al.\ \cgalCite{cgal:jqzctz-smvp-15}, equation (5).

Minimum: 0 at a similarity, but at a collapsed cell as well. It is homogeneous of degree 4: large
cells dominate. It has no barrier: cells may collapse or invert, unless the step length or
`Barrier_energy_3` forbids it.

Use it for comparisons. For maps that preserve angles, `MIPS_energy_3` does not favor small cells.

\cgalModels{DistortionEnergy_3}
*/
struct LSCM_energy_3
{
  /// returns \f$\psi\f$.
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const Eigen::Matrix<T, 3, 1> square = s.cwiseProduct(s);
    const Eigen::Matrix<T, 3, 1> difference(square[0] - square[1], square[1] - square[2], square[2] - square[0]);
    return difference.squaredNorm();
  }

  /// returns the derivatives \f$\partial\psi/\partial\sigma_i\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  { return s.cwiseProduct(derivative_by_squares(s)); }

  /// returns the second derivatives \f$\partial^2\psi/\partial\sigma_i\partial\sigma_j\f$.
  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  {
    Eigen::Matrix<T, 3, 3> H = T(-8) * s * s.transpose();
    H.diagonal() += T(24) * s.cwiseProduct(s) + derivative_by_squares(s);
    return H;
  }

private:
  // Returns twice the derivative of psi by the squares of the singular values.
  template <typename T>
  static Eigen::Matrix<T, 3, 1> derivative_by_squares(const Eigen::Matrix<T, 3, 1>& s)
  {
    const Eigen::Matrix<T, 3, 1> square = s.cwiseProduct(s);
    return T(12) * square - T(4) * square.sum() * Eigen::Matrix<T, 3, 1>::Ones();
  }
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_LSCM_ENERGY_3_H
