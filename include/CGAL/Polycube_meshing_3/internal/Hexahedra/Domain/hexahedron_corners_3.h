// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_HEXAHEDRON_CORNERS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_HEXAHEDRON_CORNERS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Hexahedron_soup_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/is_positive_hexahedron_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/check_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <Eigen/Dense>

#include <map>
#include <tuple>

namespace CGAL::Volume_mesh_parameterization::internal {

// Corners of a hexahedron as tetrahedra: each corner and its neighbors, in an order that makes those of a cube positive.
constexpr std::array<std::array<std::size_t, 4>, 8> corners_of_hexahedron
  = {{ {0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6}, {3, 0, 2, 7},
       {4, 7, 5, 0}, {5, 4, 6, 1}, {6, 5, 7, 2}, {7, 6, 4, 3} }};

// Returns the axis of the unit cube along which two of its neighboring vertices differ.
constexpr int axis_of_edge(const std::size_t k, const std::size_t l)
{
  const auto x = [](const std::size_t i) { return i % 4 == 1 || i % 4 == 2; };
  return k / 4 != l / 4 ? 2 : x(k) != x(l) ? 0 : 1;
}

// Quadrangles of a hexahedron, counterclockwise as seen from outside, and the axes of the hexahedron along which the second and
// the last vertex of each lie from its first one.
constexpr std::array<std::array<std::size_t, 4>, 6> quadrangles_of_hexahedron
  = {{ {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {3, 7, 6, 2}, {0, 4, 7, 3} }};
constexpr std::array<std::array<std::size_t, 2>, 6> axes_of_quadrangle
  = {{ {1, 0}, {0, 1}, {0, 2}, {1, 2}, {2, 0}, {2, 1} }};

// Calls `f` with the four points of each corner of a hexahedron.
template <typename Function>
void for_each_corner(const std::array<std::size_t, 8>& cell, const Function& f)
{
  for(const std::array<std::size_t, 4>& corner : corners_of_hexahedron)
    f(std::array<std::size_t, 4>{ cell[corner[0]], cell[corner[1]], cell[corner[2]], cell[corner[3]] });
}

// Calls `f` with the four points of each corner, eight times for each hexahedron.
template <typename Function>
void for_each_corner(const Hexahedron_soup_3& mesh, const Function& f)
{
  for(const std::array<std::size_t, 8>& cell : mesh.cells)
    for_each_corner(cell, f);
}

// Tells whether a hexahedron is positive all over it, in exact arithmetic on the coordinates as they are.
inline bool is_positive_hexahedron(const Hexahedron_soup_3& mesh, const std::size_t c)
{
  Hexahedron_points_3<double> points;
  for(std::size_t i = 0; i < 8; ++i)
    points[i] = mesh.points[mesh.cells[c][i]];
  return is_positive_hexahedron_3(points);
}

inline Hexahedron_points_3<double> points_of_hexahedron(const Matrix3Xd& positions, const std::array<int, 8>& hexahedron)
{
  Hexahedron_points_3<double> result;
  for(std::size_t i = 0; i < 8; ++i)
    result[i] = coordinates(positions.col(hexahedron[i]));
  return result;
}

// Tells whether a corner is neither flat nor inverted, by exact predicates on the coordinates as they are.
inline bool is_positive_corner(const Hexahedron_soup_3& mesh, const std::array<std::size_t, 4>& corner)
{
  const auto point = [&](const std::size_t i)
  {
    const std::array<double, 3>& p = mesh.points[corner[i]];
    return Exact_point_3(p[0], p[1], p[2]);
  };
  return is_positive_cell({ point(0), point(1), point(2), point(3) });
}

// Returns the edges of a corner or a tetrahedron that lead from its first vertex to the others.
inline Eigen::Matrix3d edge_matrix(const std::vector<std::array<double, 3> >& points, const std::array<std::size_t, 4>& vertices)
{
  Eigen::Matrix3d result;
  for(int i = 0; i < 3; ++i)
    result.col(i) = to_vector(points[vertices[i + 1]]) - to_vector(points[vertices[0]]);
  return result;
}

// Returns the normal of a quadrangle times its area, half of the product of its diagonals.
inline Eigen::Vector3d area_vector(const std::vector<std::array<double, 3> >& points, const std::array<std::size_t, 4>& quadrangle)
{
  const auto point = [&](const std::size_t i) { return to_vector(points[quadrangle[i]]); };
  return (point(2) - point(0)).cross(point(3) - point(1)) / 2;
}

// Returns the scaled Jacobian of a corner, or a smaller value where edges are shorter than a bound: rounding decides where edges
// lead that vanish.
inline double scaled_jacobian(Eigen::Matrix3d edges, const double shortest_edge = 0)
{
  for(int i = 0; i < 3; ++i)
  {
    const double length = length_3(edges.col(i));
    if(length > 0)
      edges.col(i) /= (std::max)(length, shortest_edge);
  }
  return edges.determinant();
}

// Returns the scaled Jacobian of each hexahedron, the least one of its corners.
inline std::vector<double> scaled_jacobians(const Hexahedron_soup_3& mesh)
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

inline const std::array<std::size_t, 8>& worst_hexahedron(const Hexahedron_soup_3& mesh, const std::vector<double>& quality)
{ return mesh.cells[std::min_element(quality.begin(), quality.end()) - quality.begin()]; }

// Quadrangle of a hexahedron: the index of the hexahedron, and that of the quadrangle there.
struct Quadrangle_of_hexahedron
{
  std::size_t cell, side;

  friend bool operator<(const Quadrangle_of_hexahedron& q, const Quadrangle_of_hexahedron& r)
  { return std::tie(q.cell, q.side) < std::tie(r.cell, r.side); }
};

inline std::array<std::size_t, 4> vertices_of(const Hexahedron_soup_3& mesh, const Quadrangle_of_hexahedron& quadrangle)
{
  std::array<std::size_t, 4> result;
  for(std::size_t i = 0; i < 4; ++i)
    result[i] = mesh.cells[quadrangle.cell][quadrangles_of_hexahedron[quadrangle.side][i]];
  return result;
}

// Calls `f(begin, end)` for each quadrangle, in the order of their sorted vertices, with a pair for each of its hexahedra: the
// sorted vertices, and the quadrangle there.
template <typename Function>
void for_each_quadrangle(const Hexahedron_soup_3& mesh, const Function& f)
{
  for_each_group(6 * mesh.cells.size(), [&](const std::size_t i)
  {
    const Quadrangle_of_hexahedron quadrangle = { i / 6, i % 6 };
    return std::make_pair(sorted(vertices_of(mesh, quadrangle)), quadrangle);
  }, f);
}

// Returns which of the six quadrangles of a hexahedron has these vertices, or 6 if none has.
inline std::size_t side_of_quadrangle(const Hexahedron_soup_3& mesh, const std::size_t cell,
                                      const std::array<std::size_t, 4>& vertices)
{
  std::size_t side = 0;
  while(side < quadrangles_of_hexahedron.size() && sorted(vertices_of(mesh, { cell, side })) != sorted(vertices))
    ++side;
  return side;
}

// Returns which of the six quadrangles of its hexahedron a facet of the boundary is, or 6 if it is none.
inline std::size_t side_of_facet(const Hexahedron_soup_3& mesh, const std::size_t f)
{
  std::size_t side = 0;
  while(side < quadrangles_of_hexahedron.size() && vertices_of(mesh, { mesh.facet_cells[f], side }) != mesh.facets[f])
    ++side;
  return side;
}

// Returns the subdomains on both sides of a quadrangle of an interface.
inline std::array<int, 2> subdomains_at_interface(const Hexahedron_soup_3& mesh, const std::size_t i)
{ return { mesh.cell_references[mesh.interface_cells[i][0]], mesh.cell_references[mesh.interface_cells[i][1]] }; }

// Returns the references of quadrangles of interfaces in files that have one number for each: their own ones, or, without them,
// numbers of pairs of subdomains, in ascending order, that follow all other numbers.
inline std::vector<int> references_at_interfaces(const Hexahedron_soup_3& mesh, const std::vector<int>& references_of_boundary)
{
  int last = 0;
  for(const std::vector<int>& references : { references_of_boundary, mesh.interface_references })
    for(const int reference : references)
      last = (std::max)(last, reference);
  std::map<std::array<int, 2>, int> numbers;
  for(std::size_t i = 0; i < mesh.interface_facets.size(); ++i)
    if(mesh.interface_references[i] == 0)
      numbers[subdomains_at_interface(mesh, i)] = 0;
  for(auto& [pair, number] : numbers)
    number = ++last;
  std::vector<int> result = mesh.interface_references;
  for(std::size_t i = 0; i < result.size(); ++i)
    if(result[i] == 0)
      result[i] = numbers.at(subdomains_at_interface(mesh, i));
  return result;
}

// Throws `Input_error` if arrays do not fit together, so that who writes them may trust their indices.
inline void check_hexahedra(const Hexahedron_soup_3& mesh)
{
  const std::size_t n = mesh.cells.size(), m = mesh.facets.size();
  if(mesh.images.size() != mesh.points.size() || mesh.cell_blocks.size() != n || mesh.cell_indices.size() != n
     || mesh.cell_references.size() != n || mesh.facet_cells.size() != m || mesh.facet_patches.size() != m
     || mesh.facet_references.size() != m)
    throw Input_error("there is not one entry of each array per point, per hexahedron and per quadrangle");
  const std::size_t number_of_facets = mesh.interface_facets.size();
  if(mesh.interface_cells.size() != number_of_facets || mesh.interface_references.size() != number_of_facets)
    throw Input_error("there is not one entry of each array per quadrangle of an interface");
  for(std::size_t c = 0; c < n; ++c)
    check_simplex(mesh.cells[c], mesh.points.size(), "hexahedron ", c);
  for(std::size_t f = 0; f < m; ++f)
    if(mesh.facet_cells[f] >= n || side_of_facet(mesh, f) == quadrangles_of_hexahedron.size())
      throw Input_error(sentence("quadrangle ", f, " (counted from 0) is none of its hexahedron"));
  for(std::size_t i = 0; i < mesh.interface_facets.size(); ++i)
    for(const std::size_t c : mesh.interface_cells[i])
      if(c >= n || side_of_quadrangle(mesh, c, mesh.interface_facets[i]) == quadrangles_of_hexahedron.size())
        throw Input_error(sentence("quadrangle ", i, " of an interface (counted from 0) is none of its hexahedra"));
}

// Returns the quadrangles that belong to one hexahedron only.
inline std::vector<Quadrangle_of_hexahedron> boundary_quadrangles_3(const Hexahedron_soup_3& mesh)
{
  std::vector<Quadrangle_of_hexahedron> result;
  for_each_quadrangle(mesh, [&](const auto begin, const auto end)
  {
    if(end - begin == 1)
      result.push_back(begin->second);
  });
  return result;
}

// Tells for each vertex whether it is on the boundary.
inline std::vector<bool> is_on_boundary(const Hexahedron_soup_3& mesh)
{
  std::vector<bool> result(mesh.points.size(), false);
  for(const std::array<std::size_t, 4>& quadrangle : mesh.facets)
    for(const std::size_t v : quadrangle)
      result[v] = true;
  return result;
}

// Collects the boundary of boxes in a domain. Two quadrangles are of one patch if they share an edge and are normal to the
// same direction.
inline void set_facets(Hexahedron_soup_3& domain)
{
  std::vector<std::pair<std::array<std::size_t, 3>, std::size_t> > edges; // vertices and direction, quadrangle
  for(const Quadrangle_of_hexahedron& quadrangle : boundary_quadrangles_3(domain))
  {
    const std::array<std::size_t, 4> v = vertices_of(domain, quadrangle);
    const auto edge_to = [&](const std::size_t i) -> Eigen::Vector3d
    {
      return to_vector(domain.points[v[i]]) - to_vector(domain.points[v[0]]);
    };
    const Eigen::Vector3d normal = edge_to(1).cross(edge_to(3));
    Eigen::Index axis;
    normal.cwiseAbs().maxCoeff(&axis);
    for(std::size_t i = 0; i < 4; ++i)
      edges.push_back({ { (std::min)(v[i], v[(i + 1) % 4]), (std::max)(v[i], v[(i + 1) % 4]),
                          2 * static_cast<std::size_t>(axis) + (normal[axis] > 0) }, domain.facets.size() });
    domain.facets.push_back(v);
    domain.facet_cells.push_back(quadrangle.cell);
  }
  Disjoint_sets patches(domain.facets.size());
  for_each_group(edges.size(), [&](const std::size_t i) { return edges[i]; }, [&](const auto begin, const auto end)
  {
    if(end - begin == 2)
      patches.unite(begin->second, (begin + 1)->second);
  });
  for(const std::size_t number : patches.numbers())
    domain.facet_patches.push_back(1 + number);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_HEXAHEDRON_CORNERS_3_H
