// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_FRAMES_OF_NORMALS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_FRAMES_OF_NORMALS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>

#include <CGAL/number_utils.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Normals of a surface, times parts of its area, and how far they are from the axes once they are turned.
class Turned_normals_3
{
public:
  // Sums up normals that differ by about a degree, such that their number does not depend on that of the facets.
  explicit Turned_normals_3(const Boundary_mesh_3& mesh)
  {
    std::map<std::array<double, 3>, Eigen::Vector3d> sums;
    double area = 0;
    for(const auto f : mesh.faces())
    {
      const Facet_edges_3 X = edges_of_face(mesh, f);
      const Eigen::Vector3d normal = X[0].cross(X[1]);
      const Eigen::Vector3d bin = (resolution * normal.normalized()).array().round();
      sums.emplace(std::array{ bin.x(), bin.y(), bin.z() }, Eigen::Vector3d::Zero()).first->second += normal;
      area += normal.norm();
    }
    for(const auto& [bin, normal] : sums)
      if(normal.norm() > 0)
        m_normals.push_back(normal / area);
  }

  // Returns the mean distance of a turned unit normal from the nearest axis, weighted by area.
  double distance(const Eigen::Matrix3d& rotation) const
  {
    double result = 0;
    for(const Eigen::Vector3d& normal : m_normals)
      result += (rotation * normal - normal.norm() * nearest_axis(rotation * normal)).norm();
    return result;
  }

  // Lowers the distance from a rotation on: the normals are turned, in the sense of least squares, to the axes nearest to them,
  // with the inverses of their distances as weights, of which the smallest are raised less and less (Weiszfeld's algorithm).
  Eigen::Matrix3d minimize(Eigen::Matrix3d rotation) const
  {
    for(double least = 0.5; least > 1e-7; least *= 0.7) // guesses, the last one far above rounding
    {
      Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
      for(const Eigen::Vector3d& normal : m_normals)
      {
        const Eigen::Vector3d axis = nearest_axis(rotation * normal);
        sum += axis * normal.transpose() / (std::max)(least, (rotation * normal.normalized() - axis).norm());
      }
#if EIGEN_VERSION_AT_LEAST(3, 4, 90) // from then on, the options are in the type
      const Eigen::JacobiSVD<Eigen::Matrix3d, Eigen::ComputeFullU | Eigen::ComputeFullV> svd(sum);
#else
      const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
#endif
      Eigen::Matrix3d U = svd.matrixU();
      U.col(2) *= (U * svd.matrixV().transpose()).determinant();
      rotation = U * svd.matrixV().transpose();
    }
    return rotation;
  }

private:
  static Eigen::Vector3d nearest_axis(const Eigen::Vector3d& vector)
  {
    int axis;
    vector.cwiseAbs().maxCoeff(&axis);
    return std::copysign(1., vector[axis]) * Eigen::Vector3d::Unit(axis);
  }

  static constexpr double resolution = 50; // a guess: one degree

  std::vector<Eigen::Vector3d> m_normals;
};

// Returns the rotation followed by that symmetry of the cube with which it turns least.
inline Eigen::Matrix3d least_turning(const Eigen::Matrix3d& rotation)
{
  Eigen::Matrix3d result = rotation;
  std::array<int, 3> axes = { 0, 1, 2 };
  do
    for(int signs = 0; signs < 8; ++signs)
    {
      Eigen::Matrix3d symmetry = Eigen::Matrix3d::Zero();
      for(int i = 0; i < 3; ++i)
        symmetry(i, axes[i]) = (signs >> i & 1) ? -1 : 1;
      if(symmetry.determinant() > 0 && (symmetry * rotation).trace() > result.trace())
        result = symmetry * rotation;
    }
  while(std::next_permutation(axes.begin(), axes.end()));
  return result;
}

// Returns rotations that bring the normals of a surface close to the axes, at most three, the closest one first: those of
// nearly the least distance among the minima that are reached from rotations by multiples of 30 degrees. The distance of the
// identity need not be minimal: if it is nearly the least one, there is no other rotation.
inline std::vector<Eigen::Matrix3d> frames_of_normals_3(const Boundary_mesh_3& mesh)
{
  constexpr double tolerance = 0.003; // a guess: a cube that is turned by a sixth of a degree differs by it
  const Turned_normals_3 normals(mesh);
  std::multimap<double, Eigen::Matrix3d> minima; // by distance
  for(int i = 0; i < 27; ++i)
  {
    const auto turn = [](const int multiple, const Eigen::Vector3d& axis)
    { return Eigen::AngleAxisd(multiple * CGAL_PI / 6, axis).toRotationMatrix(); };
    const Eigen::Matrix3d start = turn(i % 3, Eigen::Vector3d::UnitX()) * turn(i / 3 % 3, Eigen::Vector3d::UnitY())
      * turn(i / 9, Eigen::Vector3d::UnitZ());
    const Eigen::Matrix3d rotation = normals.minimize(start);
    minima.emplace(normals.distance(rotation), rotation);
  }
  const double bound = minima.begin()->first + tolerance;
  std::vector<Eigen::Matrix3d> result;
  if(normals.distance(Eigen::Matrix3d::Identity()) <= bound)
    result.push_back(Eigen::Matrix3d::Identity());
  else
    for(auto it = minima.begin(); it != minima.end() && it->first <= bound && result.size() < 3; ++it)
    {
      const auto is_other = [&](const Eigen::Matrix3d& other) // by more than three degrees, a guess
      { return least_turning(it->second * other.transpose()).trace() < 1 + 2 * std::cos(0.05); };
      if(std::all_of(result.begin(), result.end(), is_other))
        result.push_back(least_turning(it->second));
    }
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_FRAMES_OF_NORMALS_3_H
