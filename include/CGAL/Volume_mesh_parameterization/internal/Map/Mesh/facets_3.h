// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_FACETS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_FACETS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Compressed_rows.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Vector_3.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// An array of vertices in ascending order.
template <typename Simplex>
Simplex sorted(Simplex simplex)
{
  std::sort(simplex.begin(), simplex.end());
  return simplex;
}

template <typename Vertex>
std::array<Vertex, 3> sorted(const std::array<Vertex, 3>& facet)
{
  const auto& [u, v, w] = facet;
  const Vertex low = (std::min)(u, v), high = (std::max)(u, v);
  return { (std::min)(low, w), (std::max)(low, (std::min)(high, w)), (std::max)(high, w) };
}

// An edge in one of its facets: its vertices, the smaller first, and its corners there, where corner k of facet i is 3 i + k.
template <typename Vertex>
struct Edge_in_facets
{
  using Pair = std::pair<std::array<Vertex, 2>, std::array<std::size_t, 2> >;
  using Function = std::function<void(const Pair* begin, const Pair* end)>;
};

// Calls `f(begin, end)` for each edge, with a pair for each of its facets.
template <typename Vertex>
void for_each_edge(const std::vector<std::array<Vertex, 3> >& facets, const typename Edge_in_facets<Vertex>::Function& f)
{
  for_each_group(3 * facets.size(), [&](const std::size_t corner) -> typename Edge_in_facets<Vertex>::Pair
  {
    const std::array<Vertex, 3>& facet = facets[corner / 3];
    const std::size_t k = corner % 3, l = (k + 1) % 3;
    const std::size_t next = corner - k + l;
    if(facet[k] < facet[l])
      return {{ facet[k], facet[l] }, { corner, next }};
    return {{ facet[l], facet[k] }, { next, corner }};
  }, [&](const auto begin, const auto end) { f(&*begin, &*begin + (end - begin)); });
}

// The vertices of the facets of a cell, each opposite to one vertex; they turn counterclockwise as seen from outside.
constexpr int facets_of_cell[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

// Returns facet i of a cell.
template <typename Vertex>
std::array<Vertex, 3> facet_of_cell(const std::array<Vertex, 4>& cell, const std::size_t i)
{
  const auto& [a, b, c] = facets_of_cell[i];
  return { cell[a], cell[b], cell[c] };
}

// The facets that belong to one cell only, in the order of their sorted vertices; where the cells are positive, their normals
// point outwards.
template <typename Vertex>
std::vector<std::array<Vertex, 3> > boundary_facets_3(const std::vector<std::array<Vertex, 4> >& cells,
                                                      const bool is_parallel = false)
{
  using Facet = std::array<Vertex, 3>;
  const auto facet_of_side = [&](const std::size_t side) -> Facet { return facet_of_cell(cells[side / 4], side % 4); };
  std::vector<char> is_on_boundary(4 * cells.size(), false);
  for_each_group(is_on_boundary.size(), [&](const std::size_t side) { return std::make_pair(sorted(facet_of_side(side)), side); },
                 [&](const auto begin, const auto end) { is_on_boundary[begin->second] = end - begin == 1; }, is_parallel);
  std::vector<Facet> result;
  for(std::size_t side = 0; side < is_on_boundary.size(); ++side)
    if(is_on_boundary[side])
      result.push_back(facet_of_side(side));
  std::sort(result.begin(), result.end(), [](const Facet& f, const Facet& g) { return sorted(f) < sorted(g); });
  return result;
}

// Returns whether the normal of a facet is opposite to those of surfaces at its vertices, and to those that `normals_at(center)`
// returns next to its center. Normals that are 0 do not count.
template <typename NormalsAt>
bool is_turned_3(const Matrix_3& points, const Matrix_3& normals, const NormalsAt& normals_at)
{
  const Vector_3 p = points.col(0), q = points.col(1), r = points.col(2), normal = (q - p).cross(r - p);
  const auto is_opposite = [&](const Matrix_3& n)
  {
    const Vector_3 products(normal.dot(n.col(0)), normal.dot(n.col(1)), normal.dot(n.col(2)));
    return products.maxCoeff() <= 0 && products.minCoeff() < 0;
  };
  return is_opposite(normals) && is_opposite(normals_at((p + q + r) / 3));
}

using Facet_edges_3 = std::array<Vector_3, 2>;

// Two edges of a facet, and its area by these; `position(v)` is that of a vertex.
template <typename Facet, typename Position>
Facet_edges_3 edges_of_facet(const Facet& facet, const Position& position)
{
  const Vector_3 origin = position(facet[0]);
  return { Vector_3(position(facet[1])) - origin, Vector_3(position(facet[2])) - origin };
}

inline double area_of_facet(const Facet_edges_3& X) { return X[0].cross(X[1]).norm() / 2; }

// The squared singular values of the map between two triangles with edges X and U, the larger one first: the eigenvalues of
// U^T U relative to X^T X, from half of a trace and a determinant.
inline std::array<double, 2> squared_singular_values_of_facet(const Facet_edges_3& X, const Facet_edges_3& U)
{
  const double a = X[0].squaredNorm(), b = X[0].dot(X[1]), c = X[1].squaredNorm(); // X^T X
  const double d = U[0].squaredNorm(), e = U[0].dot(U[1]), f = U[1].squaredNorm(); // U^T U
  const double factor = 1 / (a * c - b * b), p = c * factor, q = -b * factor, r = a * factor; // the inverse of X^T X
  const double p_d = p * d + q * e, p_e = p * e + q * f, q_d = q * d + r * e, q_e = q * e + r * f; // times U^T U
  const double half = (p_d + q_e) / 2, determinant = p_d * q_e - q_d * p_e;
  const double largest = half + std::sqrt((std::max)(half * half - determinant, 0.));
  return { largest, (std::max)(determinant / largest, 0.) };
}

// How far the images of facets are from the facets, by shape and size up to a common scale: the mean over the area of the
// root of log(s)^2 + log(t)^2, with the singular values s and t.
template <typename Facet, typename Point, typename Image>
double facet_distortion_3(const std::vector<Facet>& facets, const Point& point, const Image& image)
{
  double area_of_facets = 0, area_of_images = 0, result = 0;
  for(const Facet& facet : facets)
  {
    area_of_facets += area_of_facet(edges_of_facet(facet, point));
    area_of_images += area_of_facet(edges_of_facet(facet, image));
  }
  for(const Facet& facet : facets)
  {
    const Facet_edges_3 X = edges_of_facet(facet, point);
    const auto [a, b] = squared_singular_values_of_facet(X, edges_of_facet(facet, image));
    const Small_array_2 squares = area_of_facets / area_of_images * Small_array_2(a, b);
    result += area_of_facet(X) / area_of_facets * squares.log().matrix().norm() / 2;
  }
  return std::isnan(result) ? std::numeric_limits<double>::infinity() : result;
}

// The vertices at an edge that has not two facets, and those whose corners of facets are not all joined by such edges.
inline std::vector<std::size_t> non_manifold_vertices(const std::size_t number_of_vertices,
                                                      const std::vector<std::array<std::size_t, 3> >& facets)
{
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<bool> is_bad(number_of_vertices, false);
  Disjoint_sets corners(3 * facets.size());
  for_each_edge(facets, [&](const auto begin, const auto end)
  {
    for(std::size_t i = 0; i < 2; ++i)
      if(end - begin == 2)
        corners.unite(begin->second[i], (begin + 1)->second[i]);
      else
        is_bad[begin->first[i]] = true;
  });

  std::vector<std::size_t> umbrella(number_of_vertices, none);
  for(std::size_t corner = 0; corner < 3 * facets.size(); ++corner)
  {
    const std::size_t v = facets[corner / 3][corner % 3], set = corners.find(corner);
    is_bad[v] = is_bad[v] || (umbrella[v] != none && umbrella[v] != set);
    umbrella[v] = set;
  }
  std::vector<std::size_t> result;
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    if(is_bad[v])
      result.push_back(v);
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_FACETS_3_H
