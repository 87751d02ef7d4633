// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_SCALED_JACOBIANS_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_SCALED_JACOBIANS_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/is_positive_hexahedron_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

namespace CGAL::Polycube_meshing_3::internal {

// Corners of a hexahedron as tetrahedra: each corner and its neighbors, in an order that makes those of a cube positive.
constexpr std::array<std::array<std::size_t, 4>, 8> corners_of_hexahedron
  = {{ {0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6}, {3, 0, 2, 7},
       {4, 7, 5, 0}, {5, 4, 6, 1}, {6, 5, 7, 2}, {7, 6, 4, 3} }};

// Returns whether vertex k of the unit cube, in the order of VTK, is on its upper side along an axis.
constexpr bool is_upper(const std::size_t k, const std::size_t axis)
{ return axis == 0 ? k % 4 == 1 || k % 4 == 2 : axis == 1 ? k % 4 >= 2 : k >= 4; }

// Returns the axis of the unit cube along which its neighboring vertices k and l differ.
constexpr int axis_of_edge(const std::size_t k, const std::size_t l)
{ return is_upper(k, 2) != is_upper(l, 2) ? 2 : is_upper(k, 0) != is_upper(l, 0) ? 0 : 1; }

// Calls `f` with the four vertices of each corner of a hexahedron: its own vertex first, then the neighbors.
template <typename Function>
void for_each_corner(const std::array<std::size_t, 8>& cell, const Function& f)
{
  for(const std::array<std::size_t, 4>& corner : corners_of_hexahedron)
    f(std::array<std::size_t, 4>{ cell[corner[0]], cell[corner[1]], cell[corner[2]], cell[corner[3]] });
}

// Calls `f` likewise for all hexahedra, eight times for each.
template <typename Hexahedra, typename Function>
void for_each_corner(const Hexahedra& mesh, const Function& f)
{
  for(const std::array<std::size_t, 8>& cell : mesh.cells)
    for_each_corner(cell, f);
}

inline Hexahedron_points_3<double> points_of_hexahedron(const std::vector<Vector_3>& points,
                                                        const std::array<std::size_t, 8>& hexahedron)
{
  Hexahedron_points_3<double> result;
  for(std::size_t i = 0; i < 8; ++i)
    result[i] = coordinates(points[hexahedron[i]]);
  return result;
}

// Returns whether the Jacobian determinant of a hexahedron is positive all over it, in exact arithmetic.
inline bool is_positive_hexahedron(const std::vector<Vector_3>& points, const std::array<std::size_t, 8>& hexahedron)
{ return is_positive_hexahedron_3(points_of_hexahedron(points, hexahedron)); }

// Returns whether a corner is neither flat nor inverted, by exact predicates.
inline bool is_positive_corner(const std::vector<Vector_3>& points, const std::array<std::size_t, 4>& corner)
{
  const auto point = [&](const std::size_t i) { return exact_point(points[corner[i]]); };
  return is_positive_cell({ point(0), point(1), point(2), point(3) });
}

// Returns the matrix whose columns are the edges of a corner or a tetrahedron from its first vertex to the others.
template <typename Point>
Matrix_3 edge_matrix(const std::vector<Point>& points, const std::array<std::size_t, 4>& vertices)
{
  const auto edge = [&](const std::size_t i) { return to_vector(points[vertices[i]]) - to_vector(points[vertices[0]]); };
  return { edge(1), edge(2), edge(3) };
}

// Returns the scaled Jacobian of a corner. An edge shorter than `shortest_edge`, whose direction is noise, counts as so long.
inline double scaled_jacobian(Matrix_3 edges, const double shortest_edge = 0)
{
  for(int i = 0; i < 3; ++i)
  {
    const double length = length_3(edges.col(i));
    if(length > 0)
      edges.col(i) = edges.col(i) / (std::max)(length, shortest_edge);
  }
  return edges.determinant();
}

// Returns the scaled Jacobian of each hexahedron, the least one of its corners.
template <typename Hexahedra>
std::vector<double> scaled_jacobians(const Hexahedra& mesh)
{
  std::vector<double> of_corners;
  for_each_corner(mesh, [&](const std::array<std::size_t, 4>& corner)
  {
    of_corners.push_back(scaled_jacobian(edge_matrix(mesh.points, corner)));
  });
  std::vector<double> result;
  for(auto first = of_corners.begin(); first != of_corners.end(); first += 8)
    result.push_back(*std::min_element(first, first + 8));
  return result;
}

// Returns the vertices of the hexahedron with the least of the scaled Jacobians of hexahedra.
inline const std::array<std::size_t, 8>& worst_hexahedron(const Hexahedra_3& mesh, const std::vector<double>& quality)
{ return mesh.cells[std::min_element(quality.begin(), quality.end()) - quality.begin()]; }

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_SCALED_JACOBIANS_H
