// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_HEXAHEDRON_CORNERS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_HEXAHEDRON_CORNERS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/boundary_facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_point_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Each corner of a hexahedron as a tetrahedron: the corner, and its neighbors such that a cube has positive ones.
constexpr std::array<std::array<std::size_t, 4>, 8> corners_of_hexahedron
  = {{ {0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6}, {3, 0, 2, 7},
       {4, 7, 5, 0}, {5, 4, 6, 1}, {6, 5, 7, 2}, {7, 6, 4, 3} }};

// The quadrangles of a hexahedron, seen from outside.
constexpr std::array<std::array<std::size_t, 4>, 6> quadrangles_of_hexahedron
  = {{ {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7} }};

// Calls `f` with the four points of each corner, eight times for each hexahedron.
template <typename Function>
void for_each_corner(const Hexahedron_soup_3& mesh, const Function& f)
{
  for(const std::array<std::size_t, 8>& cell : mesh.cells)
    for(const std::array<std::size_t, 4>& corner : corners_of_hexahedron)
      f(std::array<std::size_t, 4>{ cell[corner[0]], cell[corner[1]], cell[corner[2]], cell[corner[3]] });
}

// Is the corner neither flat nor inverted? Decided by exact predicates on the coordinates as they are.
inline bool is_positive_corner(const Hexahedron_soup_3& mesh, const std::array<std::size_t, 4>& corner)
{
  const auto point = [&](const std::size_t i)
  {
    const std::array<double, 3>& p = mesh.points[corner[i]];
    return Exact_point_3(p[0], p[1], p[2]);
  };
  return is_positive_cell({ point(0), point(1), point(2), point(3) });
}

inline double scaled_jacobian(const Hexahedron_soup_3& mesh, const std::array<std::size_t, 4>& corner)
{
  Eigen::Matrix3d edges;
  for(int i = 0; i < 3; ++i)
    edges.col(i) = (to_vector(mesh.points[corner[i + 1]]) - to_vector(mesh.points[corner[0]])).stableNormalized();
  return edges.determinant();
}

// The scaled Jacobian of each hexahedron.
inline std::vector<double> scaled_jacobians(const Hexahedron_soup_3& mesh)
{
  std::vector<double> of_corners;
  for_each_corner(mesh, [&](const std::array<std::size_t, 4>& corner)
  {
    of_corners.push_back(scaled_jacobian(mesh, corner));
  });
  std::vector<double> result;
  for(auto first = of_corners.begin(); first != of_corners.end(); first += 8)
    result.push_back(*std::min_element(first, first + 8));
  return result;
}

// The quadrangles that belong to one hexahedron only, seen from outside.
inline std::vector<std::array<std::size_t, 4> > boundary_quadrangles_3(const Hexahedron_soup_3& mesh)
{
  std::vector<std::array<std::size_t, 4> > quadrangles;
  for(const std::array<std::size_t, 8>& cell : mesh.cells)
    for(const auto& [a, b, c, d] : quadrangles_of_hexahedron)
      quadrangles.push_back({ cell[a], cell[b], cell[c], cell[d] });
  return faces_of_one_cell(quadrangles);
}

// Of each vertex: is it on the boundary?
inline std::vector<bool> is_on_boundary(const Hexahedron_soup_3& mesh)
{
  std::vector<bool> result(mesh.points.size(), false);
  for(const std::array<std::size_t, 4>& quadrangle : boundary_quadrangles_3(mesh))
    for(const std::size_t v : quadrangle)
      result[v] = true;
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_HEXAHEDRON_CORNERS_3_H
