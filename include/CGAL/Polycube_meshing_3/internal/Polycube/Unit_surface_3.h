// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_UNIT_SURFACE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_UNIT_SURFACE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Surface_map_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/split_edge_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

using Volume_mesh_parameterization::internal::vertex_index; // not CGAL's

// Surface whose box has the longest side 1 and the center 0, and size and place of the polycube that it is mapped to.
struct Unit_surface_3
{
  Boundary_mesh_3 mesh;
  std::vector<bool> is_sharp; // by edge
  Box_3 box;                  // of the surface before it was scaled, which gives the size of the polycube
  double spacing = 0;         // that coordinates of faces are multiples of, or 0 for any coordinates
  bool may_move = false;      // may the polycube be moved by a part of the spacing to be close to the surface?
  std::vector<std::array<std::size_t, 2> > splits = {}; // edges whose midpoints became vertices, one after the other
};

inline int number_of_handles(const Boundary_mesh_3& mesh)
{
  const int characteristic = static_cast<int>(mesh.number_of_vertices()) + static_cast<int>(mesh.number_of_faces())
                           - static_cast<int>(mesh.number_of_edges());
  return 1 - characteristic / 2;
}

// Surface that is turned about the center of its bounding box: `mesh` is in the unit box, and `surface` has the size of the body.
struct Turned_surface_3 : Unit_surface_3
{
  Matrix_3 rotation;
  Numbered_surface_3 surface;

  // Takes a surface with its mesh, and the rotation.
  Turned_surface_3(const Numbered_surface_3& given, Boundary_mesh_3 mesh_of_given, const Matrix_3& r)
    : rotation(r), surface(given)
  {
    mesh = std::move(mesh_of_given);
    is_sharp = are_among(mesh, surface.sharp_edges);
    if(rotation != Matrix_3::Identity()) // a turn by the identity would round coordinates
      turn(bounding_box(points_of(mesh)).center());
    box = bounding_box(points_of(mesh));
    set_points(mesh, unit_points(mesh));
  }

private:
  // Turns the surface and its mesh about a center.
  void turn(const Vector_3& center)
  {
    for(Vector_3& p : surface.points)
      p = center + rotation * (p - center);
    set_points(mesh, surface.points);
  }
};

// Returns how far the images of a surface are from it: the root of the mean of log(s)^2 + log(t)^2 over the area, s and t the
// singular values of the map after the best scaling.
inline double distortion_3(const Boundary_mesh_3& mesh, const std::vector<Vector_3>& images)
{
  double area = 0, sum = 0, sum_of_squares = 0;
  for(const auto f : mesh.faces())
  {
    const Facet_edges_3 X = edges_of_face(mesh, f);
    const Facet_edges_3 U = edges_of_facet(vertices_of_face(mesh, f), [&](const auto v) { return images[v]; });
    const auto [a, b] = squared_singular_values_of_facet(X, U);
    const Small_array_2 logarithms = Small_array_2(a, b).log() / 2;
    area += area_of_facet(X);
    sum += area_of_facet(X) * logarithms.sum();
    sum_of_squares += area_of_facet(X) * logarithms.square().sum();
  }
  const double mean = (sum_of_squares - sum * sum / (2 * area)) / area;
  return std::isfinite(mean) ? std::sqrt((std::max)(0., mean)) : (std::numeric_limits<double>::infinity)();
}

// Splits edges at their midpoints, the longest one first, and the facets beside them. Returns for each facet the one that it is a
// part of. As edges are split one after the other, a tetrahedral mesh can be split in the same way.
inline std::vector<std::size_t> split_edges_3(std::vector<Boundary_mesh_3::Edge_index> edges, Unit_surface_3& surface)
{
  Boundary_mesh_3& mesh = surface.mesh;
  const auto length = [&](const auto e) { return edge_vector(mesh, mesh.halfedge(e)).norm(); };
  std::stable_sort(edges.begin(), edges.end(), [&](const auto e, const auto f) { return length(e) > length(f); });
  std::vector<std::size_t> parents(mesh.number_of_faces());
  std::iota(parents.begin(), parents.end(), std::size_t(0));
  for(const auto e : edges)
  {
    for(const auto h : { mesh.halfedge(e), mesh.opposite(mesh.halfedge(e)) })
      parents.push_back(parents[mesh.face(h)]);
    surface.is_sharp.push_back(surface.is_sharp[e]);
    surface.is_sharp.insert(surface.is_sharp.end(), 2, false); // edges that divide the facets
    surface.splits.push_back(split_edge_3(mesh, e));
  }
  return parents;
}

// Splits edges that are longer than is allowed at their midpoints, and their halves likewise, until no edge is too long.
template <typename Length>
void split_long_edges_3(const Length& maximum_length_at, Unit_surface_3& surface)
{
  const Boundary_mesh_3& mesh = surface.mesh;
  while(true)
  {
    std::vector<double> lengths;
    std::vector<Boundary_mesh_3::Edge_index> edges;
    for(const auto e : mesh.edges())
    {
      const auto h = mesh.halfedge(e);
      const Vector_3 p = to_vector(mesh.point(mesh.source(h))), q = to_vector(mesh.point(mesh.target(h)));
      lengths.push_back((p - q).norm());
      if(lengths.back() > maximum_length_at((p + q) / 2))
        edges.push_back(e);
    }
    if(edges.empty())
      return;
    split_edges_3(with_longest_edges(mesh, edges, lengths), surface);
  }
}

// Measures of the facets of a surface.
struct Facets_3
{
  std::vector<Vector_3> centers, normals; // unit normals, or 0
  std::vector<double> areas;

  explicit Facets_3(const Boundary_mesh_3& mesh)
  {
    for(const auto f : mesh.faces())
    {
      const Facet_edges_3 X = edges_of_face(mesh, f);
      const Vector_3 n = X[0].cross(X[1]) / 2;
      areas.push_back(n.norm());
      normals.push_back(n.normalized());
      centers.push_back(to_vector(mesh.point(vertices_of_face(mesh, f)[0])) + (X[0] + X[1]) / 3);
    }
  }
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_UNIT_SURFACE_3_H
