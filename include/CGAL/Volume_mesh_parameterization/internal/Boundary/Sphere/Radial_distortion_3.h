// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_RADIAL_DISTORTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_RADIAL_DISTORTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// The distortion of a triangle whose image a, b, c is seen from the origin, as a function of a:
// f = Q (1 + 1 / D^2), with Q the Dirichlet energy of the map of the triangle, and D = det(a, b, c) / (2 weight).
// If the weight is the area of the source, times the distance of the image from the origin, then D is the ratio
// of the areas, and f the symmetric Dirichlet energy times the area.
// It is infinite at the triangles whose plane contains the origin.
class Radial_distortion_3
{
public:
  // The weight is the area of the source pqr times `scale`.
  Radial_distortion_3(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r, const double scale,
                      const Eigen::Vector3d& b, const Eigen::Vector3d& c)
    : m_b(b), m_c(c)
  {
    double pq = (q - p).squaredNorm(), qr = (r - q).squaredNorm(), rp = (p - r).squaredNorm();
    const double regular = 1e-6 * (pq + qr + rp); // a flat triangle gets a positive area
    pq += regular;
    qr += regular;
    rp += regular;
    const double square = 2 * (pq * qr + qr * rp + rp * pq) - (pq * pq + qr * qr + rp * rp); // 16 area^2
    const double area = std::sqrt(square) / 4;
    m_constant = (pq + rp - qr) / (8 * area) * (b - c).squaredNorm();
    m_cotangent_b = (pq + qr - rp) / (4 * area);
    m_cotangent_c = (qr + rp - pq) / (4 * area);
    m_normal = b.cross(c) / (2 * scale * area);
  }

  double value(const Eigen::Vector3d& a) const
  {
    const double d = a.dot(m_normal);
    return (d > 0) ? dirichlet(a) * (1 + 1 / (d * d)) : (std::numeric_limits<double>::infinity)();
  }

  void add_derivatives(const Eigen::Vector3d& a, Eigen::Vector3d& gradient, Eigen::Matrix3d& hessian) const
  {
    const double d = 1 / a.dot(m_normal);
    const double q = dirichlet(a);
    const Eigen::Vector3d q_gradient = m_cotangent_b * (a - m_c) + m_cotangent_c * (a - m_b);
    const Eigen::Matrix3d mixed = q_gradient * m_normal.transpose();
    gradient += (1 + d * d) * q_gradient - 2 * q * d * d * d * m_normal;
    hessian += (1 + d * d) * (m_cotangent_b + m_cotangent_c) * Eigen::Matrix3d::Identity()
             - 2 * d * d * d * (mixed + mixed.transpose())
             + 6 * q * d * d * d * d * m_normal * m_normal.transpose();
  }

private:
  double dirichlet(const Eigen::Vector3d& a) const
  {
    return m_constant + ((m_cotangent_b * (a - m_c).squaredNorm()) + m_cotangent_c * (a - m_b).squaredNorm()) / 2;
  }

  Eigen::Vector3d m_b, m_c, m_normal;
  double m_constant, m_cotangent_b, m_cotangent_c;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_RADIAL_DISTORTION_3_H
