// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_ROTATION_TO_AXES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_ROTATION_TO_AXES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_arithmetic_3.h>

#include <CGAL/number_utils.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Normals of a surface, weighted by area, and how far they are from the axes after a rotation.
class Turned_normals_3
{
public:
  // Sums up normals that differ by less than about a degree, such that the number of sums does not grow with that of the facets.
  explicit Turned_normals_3(const Boundary_mesh_3& mesh)
  {
    std::map<std::array<double, 3>, Vector_3> sums;
    double area = 0;
    for(const auto f : mesh.faces())
    {
      const Facet_edges_3 X = edges_of_face(mesh, f);
      const Vector_3 normal = X[0].cross(X[1]);
      const Vector_3 bin = (resolution * normal.normalized()).unaryExpr([](const double x) { return std::round(x); });
      sums.emplace(std::array{ bin.x(), bin.y(), bin.z() }, Vector_3::Zero()).first->second += normal;
      area += normal.norm();
    }
    for(const auto& [bin, normal] : sums)
      if(normal.norm() > 0)
        m_normals.push_back(normal / area);
  }

  // Returns the mean distance of a turned unit normal from the nearest unit vector along an axis, weighted by area.
  double distance(const Matrix_3& rotation) const
  {
    double result = 0;
    for(const Vector_3& normal : m_normals)
      result += (rotation * normal - normal.norm() * nearest_axis(rotation * normal)).norm();
    return result;
  }

  // Returns a rotation near a given one whose distance is a local minimum, by Weiszfeld's algorithm. Each step turns the normals,
  // in the sense of least squares, to the axes nearest to them. The weights are the inverses of distances, bounded less and less.
  Matrix_3 minimum_near(Matrix_3 rotation) const
  {
    for(double least_distance = 0.5; least_distance > 1e-7; least_distance *= 0.7) // guesses, the last one far above rounding
    {
      Matrix_3 sum = Matrix_3::Zero();
      for(const Vector_3& normal : m_normals)
      {
        const Vector_3 axis = nearest_axis(rotation * normal);
        sum += Matrix_3::outer_product(axis, normal)
               / (std::max)(least_distance, (rotation * normal.normalized() - axis).norm());
      }
      rotation = rotation_and_stretch_3(sum).rotation;
    }
    return rotation;
  }

private:
  // Returns the unit vector along an axis, in either direction, that is nearest to a vector.
  static Vector_3 nearest_axis(const Vector_3& vector)
  {
    const int axis = vector.cwiseAbs().largest_index();
    return std::copysign(1., vector[axis]) * Vector_3::Unit(axis);
  }

  static constexpr double resolution = 50; // normals per unit of a coordinate that are told apart; a guess, about a degree

  std::vector<Vector_3> m_normals;
};

// Returns, among the products of symmetries of the cube and a rotation, the rotation by the smallest angle.
inline Matrix_3 least_turning(const Matrix_3& rotation)
{
  Matrix_3 result = rotation;
  std::array<int, 3> axes = { 0, 1, 2 };
  do
    for(int signs = 0; signs < 8; ++signs)
    {
      Matrix_3 symmetry = Matrix_3::Zero();
      for(int i = 0; i < 3; ++i)
        symmetry(i, axes[i]) = (signs >> i & 1) ? -1 : 1;
      if(symmetry.determinant() > 0 && (symmetry * rotation).trace() > result.trace())
        result = symmetry * rotation;
    }
  while(std::next_permutation(axes.begin(), axes.end()));
  return result;
}

// Returns the rotation that brings the normals of a surface closest to the axes, among the minima that are reached from rotations
// by multiples of 30 degrees. Returns the identity if its distance, which need not be a minimum, is nearly the least one.
inline Matrix_3 rotation_to_axes_3(const Boundary_mesh_3& mesh)
{
  constexpr double tolerance = 0.003; // a guess: a cube that is turned by a sixth of a degree differs by it
  const Turned_normals_3 normals(mesh);
  std::pair<double, Matrix_3> best = { normals.distance(Matrix_3::Identity()) - tolerance, Matrix_3::Identity() };
  for(int i = 0; i < 27; ++i)
  {
    const auto turn = [](const int multiple, const int axis) -> Matrix_3
    { return Eigen::AngleAxisd(multiple * CGAL_PI / 6, Eigen::Vector3d::Unit(axis)).toRotationMatrix(); };
    const Matrix_3 rotation = normals.minimum_near(turn(i % 3, 0) * turn(i / 3 % 3, 1) * turn(i / 9, 2));
    if(const double distance = normals.distance(rotation); distance < best.first)
      best = { distance, rotation };
  }
  return least_turning(best.second);
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_ROTATION_TO_AXES_3_H
