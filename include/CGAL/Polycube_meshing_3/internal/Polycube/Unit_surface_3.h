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

#include <CGAL/Polycube_meshing_3/internal/Polycube/map_to_polycube_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

using Volume_mesh_parameterization::internal::vertex_index; // not CGAL's

// Surface of longest side 1 that is mapped to a polycube, and where this is to be.
struct Unit_surface_3
{
  Boundary_mesh_3 mesh;
  std::vector<bool> is_sharp; // of its edges
  Box_3 box;    // of the surface before it was scaled, which gives the size of the polycube
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

// Surface that is turned about the center of its bounding box, as it is in space and in the unit box.
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
    if(rotation != Matrix_3::Identity()) // which would round
      turn(bounding_box(points_of(mesh)).center());
    box = bounding_box(points_of(mesh));
    set_points(mesh, unit_points(mesh));
  }

private:
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

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_UNIT_SURFACE_3_H
