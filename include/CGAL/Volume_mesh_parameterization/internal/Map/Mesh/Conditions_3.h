// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_CONDITIONS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_CONDITIONS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>

#include <Eigen/Core>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the unit vector of a direction. Along an axis, it is exact: a division may be a product with a rounded reciprocal.
inline Eigen::Vector3d unit_vector_3(const Eigen::Vector3d& n)
{ return (n.array() != 0).count() == 1 ? Eigen::Vector3d(n.array().sign()) : n.stableNormalized(); }

// Returns the projector onto the directions in which a vertex may move: space, a plane, a line or a point.
inline Eigen::Matrix3d projector_3(const Vertex_condition_3& condition)
{
  const auto& [x, y, z] = condition.direction();
  const Eigen::Vector3d n = unit_vector_3(Eigen::Vector3d(x, y, z));
  switch(condition.kind())
  {
    case Vertex_condition_3::FREE: return Eigen::Matrix3d::Identity();
    case Vertex_condition_3::IN_PLANE: return Eigen::Matrix3d::Identity() - n * n.transpose();
    case Vertex_condition_3::ON_LINE: return n * n.transpose();
    case Vertex_condition_3::AT_TARGET: return Eigen::Matrix3d::Zero();
  }
  return Eigen::Matrix3d::Zero();
}

// Tells whether the conditions keep all these vertices in one plane, wherever they move, and not each at its target. A plane
// orthogonal to an axis is known exactly, any other within rounding.
template <typename Vertices, typename ProjectorOf, typename TargetOf>
bool are_kept_in_one_plane(const Vertices& vertices, const ProjectorOf& projector, const TargetOf& target)
{
  constexpr double rounding = 1e-12;
  std::vector<Eigen::Vector3d> normals = { Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ() };
  bool is_one_moving = false;
  for(const auto v : vertices)
  {
    const Eigen::Matrix3d Q = Eigen::Matrix3d::Identity() - projector(v);
    int k;
    if(Q.colwise().norm().maxCoeff(&k) == 0)
      return false;
    is_one_moving = is_one_moving || !Q.isIdentity(0);
    if(Q.trace() < 1.5 && !Q.isDiagonal(0)) // the normal of a plane
      normals.push_back(Q.col(k).normalized());
  }
  const Eigen::Vector3d origin = target(*std::begin(vertices));
  for(std::size_t i = 0; i < normals.size() && is_one_moving; ++i)
    if(std::all_of(std::begin(vertices), std::end(vertices), [&](const auto v)
    {
      const Eigen::Vector3d p = target(v);
      const double bound = i < 3 ? 0 : rounding * (p.norm() + origin.norm());
      return (projector(v) * normals[i]).norm() <= (i < 3 ? 0 : rounding) && std::abs(normals[i].dot(p - origin)) <= bound;
    }))
      return true;
  return false;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_CONDITIONS_3_H
