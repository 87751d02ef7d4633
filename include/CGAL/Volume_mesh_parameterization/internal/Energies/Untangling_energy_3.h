// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENERGIES_UNTANGLING_ENERGY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENERGIES_UNTANGLING_ENERGY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/select.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns chi(D) = (D + sqrt(D^2 + epsilon^2)) / 2, without cancellation for D < 0. Untangling after Garanzha et al.,
// Foldover-free Maps in 50 Lines of Code (TOG 2021), replaces D = det J by chi(D), which is positive also for inverted cells,
// in an energy that tends to infinity when D tends to 0; epsilon tends to 0.
template <typename T>
T regularized_determinant(const T& D, const double epsilon)
{
  using std::abs;
  using std::sqrt;
  const T root = sqrt(D * D + T(epsilon * epsilon));
  const T larger = T(0.5) * (root + abs(D));
  return select(D < T(0), T(0.25 * epsilon * epsilon) / larger, larger);
}

// Returns epsilon by the rule of Garanzha et al., section 4, with the smallest determinants of all cells: the energy tends to
// infinity at inverted cells. The last step, from `D_before` to `D_after`, lowered the energy by the part `decrease`.
inline double first_epsilon(const double D) { return std::sqrt(1e-12 + 0.04 * D * D); }

inline double next_epsilon(const double epsilon, const double decrease, const double D_before, const double D_after)
{
  const double mu = (1 - (std::max)(decrease, 0.1)) * regularized_determinant(D_before, epsilon);
  return D_after < mu ? 2 * std::sqrt(mu * (mu - D_after)) : 1e-10;
}

// Energy of a cell by Garanzha et al., f = |J|^2 / chi^(2/3) + theta (D^2 + 1) / chi. Theta is 1/2 there; with a small one the
// energy is nearly independent of scale, so that parts that must shrink a million times do not dominate it.
class Untangling_energy_3
{
public:
  Untangling_energy_3(const double epsilon, const double theta) : m_epsilon(epsilon), m_theta(theta) {}

  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const { return value_of_norms(s.squaredNorm(), T(0), s[0] * s[1] * s[2]); }

  template <typename T>
  T value_of_norms(const T& squared, const T&, const T& D) const
  {
    using std::exp;
    using std::log;
    const T c = regularized_determinant(D, m_epsilon);
    return squared * exp(T(-2. / 3.) * log(c)) + T(m_theta) * (D * D + T(1)) / c;
  }

  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const Terms<T> t(*this, s);
    return T(2) * t.power * s + t.first * t.cofactors;
  }

  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>& s) const
  {
    const Terms<T> t(*this, s);
    Eigen::Matrix<T, 3, 3> H;
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
      {
        H(i, j) = T(2) * t.power_first * (s[i] * t.cofactors[j] + s[j] * t.cofactors[i])
                + t.second * t.cofactors[i] * t.cofactors[j];
        H(i, j) += (i == j) ? T(2) * t.power : t.first * s[3 - i - j];
      }
    return H;
  }

private:
  // Terms of the derivatives of f(s, D) = |s|^2 p(D) + theta q(D), p = chi^(-2/3), q = (D^2 + 1) / chi.
  template <typename T>
  struct Terms
  {
    T power, power_first;                // p, p'
    T first, second;                     // first and second derivative of f by D at fixed |s|
    Eigen::Matrix<T, 3, 1> cofactors;    // dD / ds

    Terms(const Untangling_energy_3& energy, const Eigen::Matrix<T, 3, 1>& s)
      : cofactors(s[1] * s[2], s[0] * s[2], s[0] * s[1])
    {
      using std::exp;
      using std::log;
      using std::sqrt;
      const T D = s[0] * s[1] * s[2];
      const T epsilon_squared(energy.m_epsilon * energy.m_epsilon);
      const T root = sqrt(D * D + epsilon_squared);
      const T inverse = T(1) / regularized_determinant(D, energy.m_epsilon);

      const T slope = T(1) / root;                                                 // chi' / chi
      const T curvature = T(0.5) * epsilon_squared / (root * root * root) * inverse; // chi'' / chi

      power = exp(T(2. / 3.) * log(inverse));
      power_first = T(-2. / 3.) * power * slope;
      const T power_second = power * (T(10. / 9.) * slope * slope - T(2. / 3.) * curvature);

      const T q = (D * D + T(1)) * inverse;
      const T q_first = T(2) * D * inverse - q * slope;
      const T q_second = T(2) * inverse - T(4) * D * inverse * slope + q * (T(2) * slope * slope - curvature);

      const T theta(energy.m_theta);
      const T norm = s.squaredNorm();
      first = norm * power_first + theta * q_first;
      second = norm * power_second + theta * q_second;
    }
  };

  double m_epsilon;
  double m_theta;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENERGIES_UNTANGLING_ENERGY_3_H
