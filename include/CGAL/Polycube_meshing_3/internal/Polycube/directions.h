// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_DIRECTIONS_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_DIRECTIONS_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/basic.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL::Polycube_meshing_3::internal {

// Directions along the axes: 0 and 1 are +x and -x, 2 and 3 are +y and -y, 4 and 5 are +z and -z.
inline int axis_of_direction(const std::size_t d) { return static_cast<int>(d / 2); }
inline int sign_of_direction(const std::size_t d) { return (d % 2 == 0) ? 1 : -1; }
inline std::size_t opposite_direction(const std::size_t d) { return d ^ 1; }

inline Vector_3 vector_of_direction(const std::size_t d) { return sign_of_direction(d) * Vector_3::Unit(axis_of_direction(d)); }

// Returns the step from a voxel to the next one in a direction.
inline Eigen::Vector3i step_of_direction(const std::size_t d)
{ return sign_of_direction(d) * Eigen::Vector3i::Unit(axis_of_direction(d)); }

// Calls f for the four directions that are orthogonal to d.
template <typename Function>
void for_each_orthogonal_direction(const std::size_t d, const Function& f)
{
  for(std::size_t e = 0; e < 6; ++e)
    if(axis_of_direction(e) != axis_of_direction(d))
      f(e);
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_DIRECTIONS_H
