// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_POLYGON_SOUP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_POLYGON_SOUP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

namespace CGAL::Volume_mesh_parameterization::internal {

using Repair_kernel = Exact_predicates_inexact_constructions_kernel;
using Repaired_mesh = Surface_mesh<Repair_kernel::Point_3>;

// Points and triangles as CGAL's functions for soups take them.
struct Polygon_soup
{
  std::vector<Repair_kernel::Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;

  explicit Polygon_soup(const Tetrahedron_soup_3& surface)
  {
    for(const auto& [x, y, z] : surface.points)
      points.emplace_back(x, y, z);
    for(const auto& [u, v, w] : surface.facets)
      polygons.push_back({ u, v, w });
  }

  explicit Polygon_soup(const Repaired_mesh& mesh)
  { Polygon_mesh_processing::polygon_mesh_to_polygon_soup(mesh, points, polygons); }

  bool is_mesh() const { return Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(polygons); }

  Repaired_mesh mesh() const
  {
    Repaired_mesh result;
    Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, polygons, result);
    return result;
  }

  void assign_to(Tetrahedron_soup_3& surface) const
  {
    surface.points.clear();
    for(const Repair_kernel::Point_3& p : points)
      surface.points.push_back({ p.x(), p.y(), p.z() });
    surface.facets.clear();
    for(const std::vector<std::size_t>& polygon : polygons)
      surface.facets.push_back({ polygon[0], polygon[1], polygon[2] });
    surface.facet_references.assign(surface.facets.size(), 0);
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_POLYGON_SOUP_H
