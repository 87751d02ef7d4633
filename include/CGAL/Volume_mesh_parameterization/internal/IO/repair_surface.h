// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_REPAIR_SURFACE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_REPAIR_SURFACE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Triangulated_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/read_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/require_tetrahedra.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Makes a surface of a file enclose a body, if CGAL's functions can. They join points with the same coordinates, and points closer
// than a distance if that closes the surface; flip triangles without area away; and turn triangles that are turned over. If the
// distance is 0, it is a tiny part of the surface. Adds notes. A surface without such faults keeps its triangles.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE void repair_surface(Tetrahedron_soup_3& surface, double distance);

// Throws unless each edge of a surface has two triangles, and names an edge. Where a body touches itself, an edge has more.
inline void require_closed(const Tetrahedron_soup_3& surface, const bool may_touch_itself)
{
  const auto describe_point = [&](const std::size_t v) { return describe(to_vector(surface.points[v])); };
  if(surface.facets.empty())
    throw Input_error("the surface has no triangle. Strips of triangles are not read: save it with triangles, as *.stl has them");
  for(std::size_t i = 0; i < 3; ++i)
    if(std::all_of(surface.points.begin(), surface.points.end(), [&](const auto& p) { return p[i] == surface.points[0][i]; }))
      throw Input_error(sentence("the surface encloses no body, because it is in the plane ", "xyz"[i], " = ",
                                 surface.points[0][i], ". Extrude it to a solid in a CAD program"));
  for_each_edge(surface.facets, [&](const auto begin, const auto end)
  {
    if(end - begin != 2 && !(may_touch_itself && (end - begin) % 2 == 0))
      throw Input_error("the surface is not closed, because the edge between the points " + describe_point(begin->first[0])
                        + " and " + describe_point(begin->first[1]) + " has " + counted(end - begin, "triangle", "triangles")
                        + " instead of 2. " + ((end - begin) % 2 == 0 ? "Separate the parts that meet there, or remove one of them"
                          : "Close the hole, or use --merge-points=DISTANCE to join points closer than this distance"));
  });
}

// Reads a surface that is to enclose a body, and repairs it.
inline Tetrahedron_soup_3 read_closed_surface(const std::string& filename, const double distance, const Budget& budget,
                                              const bool may_touch_itself = false)
{
  Tetrahedron_soup_3 surface = read_surface(filename, budget);
  repair_surface(surface, distance);
  require_closed(surface, may_touch_itself);
  return surface;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/IO/repair_surface_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_REPAIR_SURFACE_H
