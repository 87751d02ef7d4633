// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_REPAIR_SURFACE_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_REPAIR_SURFACE_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/Polygon_soup.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/repair_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Soups/nearby_points.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <cmath>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns whether `is_right(n)` for each number n of triangles at an edge.
template <typename Predicate>
bool for_all_edges(const Tetrahedron_soup_3& surface, const Predicate& is_right)
{
  bool result = !surface.facets.empty();
  for_each_edge(surface.facets, [&](const auto begin, const auto end) { result = result && is_right(end - begin); });
  return result;
}

// A closed surface may touch itself at edges.
inline bool is_closed(const Tetrahedron_soup_3& surface)
{ return for_all_edges(surface, [](const auto n) { return n % 2 == 0; }); }

inline bool is_manifold(const Tetrahedron_soup_3& surface)
{ return for_all_edges(surface, [](const auto n) { return n == 2; }); }

// Moves triangles to the first of the points at gaps that chains of steps no longer than a distance join.
inline void join_points_at_gaps(Tetrahedron_soup_3& surface, const double distance)
{
  std::set<std::size_t> at_gaps;
  for_each_edge(surface.facets, [&](const auto begin, const auto end)
  {
    if((end - begin) % 2 != 0)
      at_gaps.insert(begin->first.begin(), begin->first.end());
  });
  const std::vector<std::size_t> first = first_nearby_points(surface.points, at_gaps, distance);
  for_each_vertex(surface, [&](std::size_t& v) { v = first[v]; });
}

// Removes triangles without three vertices, and points without triangles.
inline void remove_unused(Tetrahedron_soup_3& surface)
{
  Triangles& triangles = surface.facets;
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), [](const auto& t)
                                 { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }), triangles.end());
  surface.facet_references.assign(triangles.size(), 0);
  remove_unused_points(surface);
}

inline bool is_flat(const Tetrahedron_soup_3& surface, const std::array<std::size_t, 3>& triangle)
{
  constexpr double small_part = 1e-4; // a guess; the height of a flat triangle, relative to its longest edge
  const auto [a, b] = edges_of_facet(triangle, [&](const std::size_t v) { return to_vector(surface.points[v]); });
  const double longest = (std::max)({ a.squaredNorm(), b.squaredNorm(), (a - b).squaredNorm() });
  return a.cross(b).norm() <= small_part * longest;
}

// Removes pairs of triangles without area, up to rounding, that have the same vertices: they enclose nothing. Polygons without
// area become such triangles.
inline void remove_flat_pairs(Tetrahedron_soup_3& surface)
{
  std::map<std::array<std::size_t, 3>, std::size_t> last; // of each set of vertices
  std::set<std::size_t> removed;
  for(std::size_t t = 0; t < surface.facets.size(); ++t)
    if(is_flat(surface, surface.facets[t]))
    {
      const auto [entry, is_first] = last.emplace(sorted(surface.facets[t]), t);
      if(is_first)
        continue;
      removed.insert({ entry->second, t });
      last.erase(entry);
    }
  Triangles kept;
  for(std::size_t t = 0; t < surface.facets.size(); ++t)
    if(removed.count(t) == 0)
      kept.push_back(surface.facets[t]);
  surface.facets = kept;
}

inline void join_points(Tetrahedron_soup_3& surface, const double given_distance)
{
  if(is_manifold(surface))
    return;
  const std::size_t n = surface.points.size();
  const auto add_note = [&](Tetrahedron_soup_3& joined, const std::string& distance)
  {
    if(joined.points.size() < n)
      joined.notes.push_back(counted(n - joined.points.size(), "point is", "points are") + " joined to " + distance);
  };
  Tetrahedron_soup_3 joined = surface;
  Polygon_soup soup(surface);
  Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup(soup.points, soup.polygons);
  soup.assign_to(joined);
  remove_flat_pairs(joined);
  soup = Polygon_soup(joined);
  Polygon_mesh_processing::repair_polygon_soup(soup.points, soup.polygons);
  soup.assign_to(joined);
  if(is_closed(joined) || given_distance > 0)
    surface = joined;
  if(is_closed(joined))
    return add_note(surface, "others with the same coordinates");
  const auto diagonal = [&]
  {
    Bbox_3 box;
    for(const Repair_kernel::Point_3& p : soup.points)
      box += p.bbox();
    return std::sqrt(square(box.xmax() - box.xmin()) + square(box.ymax() - box.ymin()) + square(box.zmax() - box.zmin()));
  };
  const std::vector<double> parts = { 1e-9, 1e-7, 1e-5 }; // guesses: rounding of double and single precision, and of short texts
  for(const double part : given_distance > 0 ? std::vector<double>{ 1 } : parts)
  {
    const double distance = given_distance > 0 ? given_distance : part * diagonal();
    Tetrahedron_soup_3 nearby = joined;
    join_points_at_gaps(nearby, distance);
    remove_flat_pairs(nearby);
    remove_unused(nearby);
    if(!is_closed(nearby))
      continue;
    surface = nearby;
    return add_note(surface, "others within " + sentence(distance) + ", which closes the surface");
  }
}

// Returns the volume that a closed surface encloses, which is negative if its triangles turn inwards.
inline double enclosed_volume(const Tetrahedron_soup_3& surface)
{
  const auto point = [&](const std::size_t v) { return exact_point(surface.points[v]); };
  const auto origin = point(surface.facets[0][0]);
  double result = 0;
  for(const auto& [u, v, w] : surface.facets)
    result += CGAL::volume(origin, point(u), point(v), point(w));
  return result;
}

// Turns triangles until all turn alike, and outwards. Only edges with two triangles are known to allow this.
inline void turn_triangles(Tetrahedron_soup_3& surface)
{
  if(!is_manifold(surface))
    return;
  const bool is_oriented = Triangulated_surface(surface.facets).is_oriented();
  if(!is_oriented)
  {
    Polygon_soup soup(surface);
    Polygon_mesh_processing::orient_polygon_soup(soup.points, soup.polygons);
    soup.assign_to(surface);
  }
  const bool is_inside_out = enclosed_volume(surface) < 0;
  if(is_inside_out)
    surface.facets = reversed(surface.facets);
  if(!is_oriented || is_inside_out)
    surface.notes.push_back("some triangles of the surface were turned over, and are turned");
}

// Flips the longest edges of triangles whose area is zero up to rounding, and returns the number of flips.
inline std::size_t flip_caps(Repaired_mesh& mesh)
{
  constexpr double cosine = -1 + 1e-12; // a guess, of the largest angle: the height is a millionth of the longest edge
  std::size_t number = 0;
  for(const auto face : mesh.faces())
  {
    const auto h = Polygon_mesh_processing::is_cap_triangle_face(face, mesh, cosine);
    if(h == Repaired_mesh::null_halfedge())
      continue;
    const auto apex = [&](const auto halfedge) { return mesh.target(mesh.next(halfedge)); };
    if(mesh.halfedge(apex(h), apex(mesh.opposite(h))) != Repaired_mesh::null_halfedge())
      continue;
    Euler::flip_edge(h, mesh);
    ++number;
  }
  return number;
}

inline void remove_flat_triangles(Tetrahedron_soup_3& surface)
{
  if(std::none_of(surface.facets.begin(), surface.facets.end(), [&](const auto& t) { return is_flat(surface, t); }))
    return;
  const Polygon_soup soup(surface);
  if(!is_manifold(surface) || !soup.is_mesh())
    return;
  Repaired_mesh mesh = soup.mesh();
  std::vector<Repaired_mesh::Face_index> flat;
  Polygon_mesh_processing::degenerate_faces(mesh, std::back_inserter(flat));
  if(!Polygon_mesh_processing::remove_degenerate_faces(mesh))
    return;
  std::size_t number = flat.size();
  for(std::size_t n = 1; n > 0 && number <= surface.facets.size(); number += n) // flips may make others flat
    n = flip_caps(mesh);
  if(number == 0)
    return;
  mesh.collect_garbage();
  Polygon_soup(mesh).assign_to(surface);
  surface.notes.push_back(counted(number, "triangle of the surface has", "triangles of the surface have")
                          + " no area, and edges are flipped or joined there");
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE void repair_surface(Tetrahedron_soup_3& surface, const double distance)
{
  remove_unused(surface);
  join_points(surface, distance);
  turn_triangles(surface);
  remove_flat_triangles(surface);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_REPAIR_SURFACE_IMPL_H
