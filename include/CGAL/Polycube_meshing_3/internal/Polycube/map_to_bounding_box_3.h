// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_BOUNDING_BOX_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_BOUNDING_BOX_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Unit_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Box/map_to_box_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <cmath>
#include <optional>

namespace CGAL::Polycube_meshing_3::internal {

// Maps a topological sphere to its bounding box. With a spacing, faces of the box are moved to multiples first.
inline Surface_map_3 map_to_bounding_box_3(const Turned_surface_3& turned, const Budget& budget)
{
  const double spacing = turned.spacing;
  Vector_3 lower = turned.box.smallest, upper = turned.box.largest;
  if(spacing > 0)
  {
    const auto rounded = [](const Vector_3& v) { return v.unaryExpr([](const double x) { return std::round(x); }); };
    const Vector_3 first = rounded(lower / spacing);
    lower = spacing * first;
    upper = spacing * (first + Vector_3::Ones()).cwiseMax(rounded(upper / spacing));
  }
  const double size = (upper - lower).maxCoeff();
  const Vector_3 half_lengths = (upper - lower) / (2 * size);
  Numbered_surface_3 unit_surface = turned.surface;
  unit_surface.sharp_edges.clear();
  unit_surface.points = points_of(turned.mesh);
  Surface_map_3 result;
  result.status = map_to_box_3(unit_surface, half_lengths, std::nullopt, result.images, budget);
  if(result.status != OK)
    return result;
  for(Vector_3& image : result.images) // from the box of longest side 1 around 0: faces get exactly their coordinates
    for(int axis = 0; axis < 3; ++axis)
      image[axis] = (image[axis] == half_lengths[axis]) ? upper[axis] : (image[axis] == -half_lengths[axis]) ? lower[axis]
        : (lower[axis] + upper[axis]) / 2 + size * image[axis];
  Boundary_mesh_3 image = turned.mesh;
  set_points(image, result.images);
  if(Polygon_mesh_processing::does_self_intersect(image))
    return { ERROR_BOUNDARY_MAP_NOT_BIJECTIVE };
  result.distortion = distortion_3(turned.mesh, result.images);
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_BOUNDING_BOX_3_H
