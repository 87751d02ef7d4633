// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_IS_RADIALLY_BIJECTIVE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_IS_RADIALLY_BIJECTIVE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Is the triangle counterclockwise as seen from outside, the origin being inside? Decided by exact predicates.
inline Orientation radial_orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const auto point = [](const Eigen::Vector3d& p) { return Boundary_point_3(p[0], p[1], p[2]); };
  return CGAL::orientation(Boundary_point_3(0, 0, 0), point(a), point(b), point(c));
}

// Is the central projection of the image onto a sphere one to one? If all triangles are positive, it covers the
// sphere everywhere equally often, and it suffices to count how often in one direction.
inline bool is_radially_bijective_3(const Boundary_mesh_3& mesh, const std::vector<Eigen::Vector3d>& images)
{
  std::vector<std::array<Eigen::Vector3d, 3> > triangles;
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    triangles.push_back({ images[mesh.source(h)], images[mesh.target(h)], images[mesh.target(mesh.next(h))] });
  }
  const Eigen::Vector3d direction = triangles[0][0] + triangles[0][1] + triangles[0][2];
  const auto is_in_direction = [&](const std::array<Eigen::Vector3d, 3>& t)
  {
    return radial_orientation(t[0], t[1], direction) != NEGATIVE
           && radial_orientation(t[1], t[2], direction) != NEGATIVE
           && radial_orientation(t[2], t[0], direction) != NEGATIVE;
  };
  return std::all_of(triangles.begin(), triangles.end(), [](const std::array<Eigen::Vector3d, 3>& t)
         {
           return radial_orientation(t[0], t[1], t[2]) == POSITIVE;
         })
         && std::count_if(triangles.begin(), triangles.end(), is_in_direction) == 1;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_IS_RADIALLY_BIJECTIVE_3_H
