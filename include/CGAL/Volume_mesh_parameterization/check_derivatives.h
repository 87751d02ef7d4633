// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_CHECK_DERIVATIVES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_CHECK_DERIVATIVES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

The errors that `check_derivatives()` finds. They have no unit; those of correct functions are far below 0.001, wrong signs
or factors give 0.5 and more.
*/
struct Derivative_errors_3
{
  static constexpr double bound = 1e-3; ///< errors of correct functions are far below

  double symmetry = 0; ///< error of the value, where two arguments are exchanged
  double gradient = 0; ///< error of the gradient, against central differences of the value
  double hessian = 0;  ///< error of the Hessian, against central differences of the gradient

  /// returns whether all errors are below `bound`.
  bool are_small() const { return symmetry < bound && gradient < bound && hessian < bound; }
};

/*!
\ingroup PkgVolumeMeshParameterizationEnergies

compares the derivatives of an energy with finite differences, at some singular values between 0.4 and 2.5, equal ones among
them. A minimization with wrong derivatives still inverts no cell, but ends somewhere: call this once for an energy of your
own. `CGAL::stretch_minimizing_volume_parameterization()` calls it with `verbose(true)`, and prints which errors are not small.

An error is relative to the size of the derivative, plus a thousandth of the largest value: derivatives may be 0. Functions
that are not twice continuously differentiable at these points, or not finite, have large errors.

\tparam Energy a model of `DistortionEnergy_3`
*/
template <typename Energy>
Derivative_errors_3 check_derivatives(const Energy& energy)
{
  using Vector = Eigen::Matrix<double, 3, 1>;
  // samples avoid 1, where gradients vanish, and round numbers, where formulas may change; some are equal
  static constexpr std::array<std::array<double, 3>, 6> samples
    = { { { 1.71, 1.13, 0.57 }, { 2.47, 0.93, 0.41 }, { 0.83, 0.61, 0.53 },
          { 1.89, 1.63, 1.31 }, { 1.43, 1.43, 0.71 }, { 1.19, 1.19, 1.19 } } };
  constexpr double h = 1e-5; // the errors of truncation, h^2, and of rounding, 1e-16 / h, are far below the bound of 0.001
  double largest = 0;
  for(const std::array<double, 3>& sample : samples)
    largest = (std::max)(largest, std::abs(energy.template value<double>(Vector(sample.data()))));
  Derivative_errors_3 errors;
  const auto raise = [](double& error, const double difference, const double size)
  {
    const double relative = difference == 0 ? 0 : difference / size;
    error = std::isfinite(relative) ? (std::max)(error, relative) : std::numeric_limits<double>::infinity();
  };
  for(const std::array<double, 3>& sample : samples)
  {
    const Vector s(sample.data());
    const double psi = energy.template value<double>(s);
    const Vector g = energy.template gradient<double>(s);
    const Eigen::Matrix<double, 3, 3> H = energy.template hessian<double>(s);
    Vector differences_of_value;
    Eigen::Matrix<double, 3, 3> differences_of_gradient;
    for(int i = 0; i < 3; ++i)
    {
      const Vector above = s + h * Vector::Unit(i), below = s - h * Vector::Unit(i);
      differences_of_value[i]
        = (energy.template value<double>(above) - energy.template value<double>(below)) / (2 * h);
      differences_of_gradient.col(i)
        = (energy.template gradient<double>(above) - energy.template gradient<double>(below)) / (2 * h);
      Vector exchanged = s;
      std::swap(exchanged[i], exchanged[(i + 1) % 3]);
      raise(errors.symmetry, std::abs(energy.template value<double>(exchanged) - psi), largest);
    }
    raise(errors.gradient, (g - differences_of_value).norm(), differences_of_value.norm() + 1e-3 * largest);
    raise(errors.hessian, (H - differences_of_gradient).norm(), differences_of_gradient.norm() + 1e-3 * largest);
  }
  return errors;
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_CHECK_DERIVATIVES_H
