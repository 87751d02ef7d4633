// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_BODIES_APART_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_BODIES_APART_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Surface_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Body that shares no point with the other bodies of a surface, and the numbers of its vertices on the whole surface.
struct Separate_body_3
{
  Numbered_surface_3 surface;
  std::vector<std::array<std::size_t, 4> > cells;
  std::vector<std::size_t> vertices;
};

// Returns the bodies of a surface: sets of cells that are connected by points. Their surfaces do not point to their cells yet, as
// copies would point to cells of the originals.
inline std::vector<Separate_body_3> separate_bodies_3(const Numbered_surface_3& whole)
{
  std::size_t number_of_points = 0;
  for(const std::array<std::size_t, 4>& cell : *whole.cells)
    number_of_points = (std::max)(number_of_points, *std::max_element(cell.begin(), cell.end()) + 1);
  const std::size_t n = whole.cells->size();
  Disjoint_sets sets(n + number_of_points); // cells, and points behind them
  for(std::size_t c = 0; c < n; ++c)
    for(const std::size_t v : (*whole.cells)[c])
      sets.unite(c, n + v);
  const std::vector<std::size_t> numbers = sets.numbers();
  const auto number_of_body = [&](const std::size_t point) { return numbers[n + point]; };

  std::vector<Separate_body_3> bodies(1 + *std::max_element(numbers.begin(), numbers.begin() + n));
  for(std::size_t c = 0; c < n; ++c)
    bodies[numbers[c]].cells.push_back((*whole.cells)[c]);
  std::vector<std::size_t> index_in_body(whole.vertices.size());
  for(std::size_t v = 0; v < index_in_body.size(); ++v)
  {
    Separate_body_3& body = bodies[number_of_body(whole.vertices[v])];
    index_in_body[v] = body.vertices.size();
    body.vertices.push_back(v);
    body.surface.points.push_back(whole.points[v]);
    body.surface.vertices.push_back(whole.vertices[v]);
  }
  for(const auto& [a, b, c] : whole.facets)
    bodies[number_of_body(whole.vertices[a])].surface.facets.push_back({ index_in_body[a], index_in_body[b], index_in_body[c] });
  for(const auto& [a, b] : whole.sharp_edges)
    bodies[number_of_body(whole.vertices[a])].surface.sharp_edges.push_back({ index_in_body[a], index_in_body[b] });
  return bodies;
}

// Moves points by a distance in units of the spacing, if there is one: multiples of it stay multiples, bit by bit.
inline void move_along_x(const double distance, const double spacing, std::vector<Vector_3>& points)
{
  const double unit = spacing > 0 ? spacing : 1;
  for(Vector_3& p : points)
  {
    const double multiple = std::round(p.x() / unit);
    p[0] = spacing > 0 && p.x() == spacing * multiple ? spacing * (multiple + distance) : p.x() + unit * distance;
  }
}

// Adds the map of a body to that of the whole surface. Points of its splits come behind all points before.
inline void add_body(const Separate_body_3& body, const Surface_map_3& map, Surface_map_3& whole)
{
  const std::size_t given = body.vertices.size(), before = whole.images.size();
  const auto number_on_whole = [&](const std::size_t v) { return v < given ? body.vertices[v] : before + v - given; };
  for(const auto& [v, w] : map.splits)
    whole.splits.push_back({ number_on_whole(v), number_on_whole(w) });
  whole.images.resize(before + map.splits.size());
  for(std::size_t v = 0; v < map.images.size(); ++v)
    whole.images[number_on_whole(v)] = map.images[v];
}

// Maps several bodies, each by itself with `map_body(surface)`. A polycube that would touch an earlier one is moved along x beyond
// all of these, as the polycube of a ring linked with another ring must be. A single body with cavities is refused.
template <typename MapBody>
Surface_map_3 map_bodies_apart_3(const Numbered_surface_3& whole, const double spacing, const MapBody& map_body)
{
  std::vector<Separate_body_3> bodies = separate_bodies_3(whole);
  if(bodies.size() == 1)
    return { ERROR_SEVERAL_BOUNDARY_COMPONENTS };
  Surface_map_3 result = { OK, std::vector<Vector_3>(whole.points.size()) };
  std::vector<Box_3> boxes;
  double right = -(std::numeric_limits<double>::infinity)(); // largest x of all boxes
  for(Separate_body_3& body : bodies)
  {
    body.surface.cells = &body.cells;
    Surface_map_3 map = map_body(body.surface);
    if(map.status != OK)
      return { map.status };
    std::vector<Vector_3>& part = map.images;
    const Box_3 box = bounding_box(part);
    const auto meets = [&](const Box_3& other)
    { return (box.smallest.cwiseMax(other.smallest) - box.largest.cwiseMin(other.largest)).maxCoeff() <= 0; };
    if(std::any_of(boxes.begin(), boxes.end(), meets))
    {
      const double distance = right - box.smallest.x();
      move_along_x(spacing > 0 ? std::ceil(distance / spacing + 1) : distance + box.diagonal().x() / 8, spacing, part);
    }
    boxes.push_back(bounding_box(part));
    right = (std::max)(right, boxes.back().largest.x());
    add_body(body, map, result);
  }
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_BODIES_APART_3_H
