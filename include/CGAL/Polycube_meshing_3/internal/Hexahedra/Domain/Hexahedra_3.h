// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_HEXAHEDRA_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_HEXAHEDRA_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Hexahedron_soup_3.h>
#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>

#include <set>
#include <utility>

namespace CGAL::Polycube_meshing_3::internal {

// Hexahedra while they are made; the arrays are those of Hexahedron_soup_3.
struct Hexahedra_3
{
  std::vector<Vector_3> points, images;
  std::vector<std::array<std::size_t, 8> > cells;
  std::vector<std::size_t> cell_blocks;
  std::vector<std::array<std::size_t, 3> > cell_indices;
  std::vector<int> cell_references;
  std::vector<std::array<std::size_t, 4> > facets;
  std::vector<std::size_t> facet_cells, polycube_faces;
};

// Returns the soup of the hexahedra, still without references of quadrangles and interfaces.
inline Hexahedron_soup_3 hexahedron_soup_of(Hexahedra_3 mesh)
{
  Hexahedron_soup_3 result;
  result.points = arrays_of(mesh.points);
  result.images = arrays_of(mesh.images);
  result.cells = std::move(mesh.cells);
  result.cell_blocks = std::move(mesh.cell_blocks);
  result.cell_indices = std::move(mesh.cell_indices);
  result.cell_references = std::move(mesh.cell_references);
  result.facets = std::move(mesh.facets);
  result.facet_cells = std::move(mesh.facet_cells);
  result.polycube_faces = std::move(mesh.polycube_faces);
  return result;
}

// Returns for each vertex whether it is on the boundary.
template <typename Hexahedra>
std::vector<bool> is_on_boundary(const Hexahedra& mesh) { return used_points(mesh.facets, mesh.points.size()); }

// Quadrangles of a hexahedron, counterclockwise as seen from outside, and the axes of the hexahedron along which the second and
// the last vertex of each lie from its first one.
constexpr std::array<std::array<std::size_t, 4>, 6> quadrangles_of_hexahedron
  = {{ {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {3, 7, 6, 2}, {0, 4, 7, 3} }};
constexpr std::array<std::array<std::size_t, 2>, 6> axes_of_quadrangle
  = {{ {1, 0}, {0, 1}, {0, 2}, {1, 2}, {2, 0}, {2, 1} }};

// Quadrangle of a hexahedron: the index of the hexahedron, and that of the quadrangle there.
struct Quadrangle_of_hexahedron
{
  std::size_t cell, side;

  friend bool operator<(const Quadrangle_of_hexahedron& q, const Quadrangle_of_hexahedron& r)
  { return std::tie(q.cell, q.side) < std::tie(r.cell, r.side); }
};

// Returns the vertices of a quadrangle, counterclockwise as seen from outside of its hexahedron.
template <typename Hexahedra>
std::array<std::size_t, 4> vertices_of(const Hexahedra& mesh, const Quadrangle_of_hexahedron& quadrangle)
{
  std::array<std::size_t, 4> result;
  for(std::size_t i = 0; i < 4; ++i)
    result[i] = mesh.cells[quadrangle.cell][quadrangles_of_hexahedron[quadrangle.side][i]];
  return result;
}

inline void add_cell(const std::array<std::size_t, 8>& vertices, const std::size_t block, const std::array<std::size_t, 3>& index,
                     const int reference, Hexahedra_3& mesh)
{
  mesh.cells.push_back(vertices);
  mesh.cell_blocks.push_back(block);
  mesh.cell_indices.push_back(index);
  mesh.cell_references.push_back(reference);
}

inline void add_facet(const Quadrangle_of_hexahedron& quadrangle, const std::size_t polycube_face, Hexahedra_3& mesh)
{
  mesh.facets.push_back(vertices_of(mesh, quadrangle));
  mesh.facet_cells.push_back(quadrangle.cell);
  mesh.polycube_faces.push_back(polycube_face);
}

// Calls `f(begin, end)` for each quadrangle, in the order of their sorted vertices, with a pair for each of its hexahedra: the
// sorted vertices, and the quadrangle there.
template <typename Function>
void for_each_quadrangle(const Hexahedra_3& mesh, const Function& f)
{
  for_each_group(6 * mesh.cells.size(), [&](const std::size_t i)
  {
    const Quadrangle_of_hexahedron quadrangle = { i / 6, i % 6 };
    return std::make_pair(sorted(vertices_of(mesh, quadrangle)), quadrangle);
  }, f);
}

// Returns the quadrangles that belong to one hexahedron only.
inline std::vector<Quadrangle_of_hexahedron> boundary_quadrangles_3(const Hexahedra_3& mesh)
{
  std::vector<Quadrangle_of_hexahedron> result;
  for_each_quadrangle(mesh, [&](const auto begin, const auto end)
  {
    if(end - begin == 1)
      result.push_back(begin->second);
  });
  return result;
}

// Returns which of the six quadrangles of its hexahedron a facet of the boundary is, or 6 if it is none.
template <typename Hexahedra>
std::size_t side_of_facet(const Hexahedra& mesh, const std::size_t f)
{
  std::size_t side = 0;
  while(side < quadrangles_of_hexahedron.size() && vertices_of(mesh, { mesh.facet_cells[f], side }) != mesh.facets[f])
    ++side;
  return side;
}

// Returns the edge of a quadrangle from its vertex i to the next one, both modulo 4; the smaller vertex comes first.
inline std::array<std::size_t, 2> edge_of_quadrangle(const std::array<std::size_t, 4>& quadrangle, const std::size_t i)
{ return sorted(std::array<std::size_t, 2>{ quadrangle[i % 4], quadrangle[(i + 1) % 4] }); }

// Returns the edges of the quadrangles of the boundary, the smaller vertex first.
inline std::set<std::array<std::size_t, 2> > boundary_edges_3(const Hexahedra_3& mesh)
{
  std::set<std::array<std::size_t, 2> > result;
  for(const std::array<std::size_t, 4>& q : mesh.facets)
    for(std::size_t i = 0; i < 4; ++i)
      result.insert(edge_of_quadrangle(q, i));
  return result;
}

// Returns the mean of the vertices of a quadrangle or hexahedron.
template <std::size_t N>
Vector_3 center_of(const std::vector<Vector_3>& points, const std::array<std::size_t, N>& vertices)
{
  Vector_3 sum = Vector_3::Zero();
  for(const std::size_t v : vertices)
    sum += points[v];
  return sum / N;
}

// Returns the mean of any number of points, divided before they are added.
inline Vector_3 mean_of(const std::vector<Vector_3>& points, const std::vector<std::size_t>& vertices)
{
  Vector_3 result = Vector_3::Zero();
  for(const std::size_t v : vertices)
    result += points[v] / static_cast<double>(vertices.size());
  return result;
}

// Returns the normal of a quadrangle times its area, half of the product of its diagonals.
inline Vector_3 area_vector(const std::vector<Vector_3>& points, const std::array<std::size_t, 4>& quadrangle)
{
  const auto& [a, b, c, d] = quadrangle;
  return (points[c] - points[a]).cross(points[d] - points[b]) / 2;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_HEXAHEDRA_3_H
