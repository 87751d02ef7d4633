// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_IN_ORDER_OF_PLANES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_IN_ORDER_OF_PLANES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_map_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/ordered_coordinates_3.h>

#include <map>

namespace CGAL::Polycube_meshing_3::internal {

// Returns whether a line along an axis meets the boxes of two faces that are orthogonal to it.
inline bool overlap_along_axis(const Box_3& a, const Box_3& b, const int axis)
{
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  return a.smallest[u] <= b.largest[u] && b.smallest[u] <= a.largest[u]
      && a.smallest[v] <= b.largest[v] && b.smallest[v] <= a.largest[v];
}

// Returns for each chart of a polycube the multiple of the spacing that its face is moved to, as close as the orders allow: planes
// do not change their order, and faces that overlap along their axis stay apart. Space is mapped by monotone functions of the
// coordinates then, so that the polycube stays embedded, however thin its walls are. If planes may join, edges of parts may touch.
inline std::vector<double> multiples_in_order_3(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts,
                                                const std::vector<Vector_3>& images, const double spacing, const bool may_join)
{
  const std::size_t n = charts.number_of_charts();
  std::vector<Box_3> boxes(n);
  std::vector<double> areas(n, 0), result(n);
  for(const auto f : mesh.faces())
  {
    const std::size_t c = charts.chart_of_face()[f];
    areas[c] += area_of_face(mesh, f);
    for(const auto v : vertices_of_face(mesh, f))
      boxes[c].extend(images[v]);
  }
  for(int axis = 0; axis < 3; ++axis)
  {
    std::map<double, std::vector<std::size_t> > charts_of_planes;
    for(std::size_t c = 0; c < n; ++c)
      if(charts.axis(c) == axis)
        charts_of_planes[boxes[c].smallest[axis]].push_back(c);
    std::vector<double> area_of_planes, moments;
    std::vector<Order_of_coordinates> orders;
    std::vector<std::pair<std::size_t, std::size_t> > lower; // charts, with the numbers of their planes
    for(const auto& [x, charts_of_plane] : charts_of_planes)
    {
      const std::size_t plane = area_of_planes.size();
      if(plane > 0)
        orders.push_back({ plane - 1, plane, may_join ? 0 : spacing });
      const auto nearest = std::find_if(lower.rbegin(), lower.rend(), [&, &on_plane = charts_of_plane](const auto& below)
      {
        return std::any_of(on_plane.begin(), on_plane.end(), [&](const std::size_t c)
                           { return overlap_along_axis(boxes[c], boxes[below.first], axis); });
      });
      if(nearest != lower.rend())
        orders.push_back({ nearest->second, plane, spacing });
      area_of_planes.push_back(0);
      for(const std::size_t c : charts_of_plane)
      {
        area_of_planes.back() += areas[c];
        lower.emplace_back(c, plane);
      }
      moments.push_back(area_of_planes.back() * x);
    }
    const Plane_grid_3 grid = { Vector_3::Zero(), spacing };
    const std::vector<double> values = ordered_coordinates_3(area_of_planes, moments, orders, grid, axis).value().values;
    for(const auto& [c, plane] : lower)
      result[c] = values[plane];
  }
  return result;
}

// Maps a surface to the polycube that given images are on, after its faces have been moved to multiples of the spacing.
inline Surface_map_3 map_in_order_of_planes_3(const Unit_surface_3& surface, const std::vector<Vector_3>& images,
                                              const Budget& budget)
{
  std::vector<std::size_t> labels;
  for(const auto f : surface.mesh.faces())
    labels.push_back(label_of_image(vertices_of_face(surface.mesh, f), images));
  const double size = surface.box.diagonal().maxCoeff();
  Surface_map_3 result;
  for(const bool may_join : { true, false })
  {
    Polycube_map_3 map(surface, labels);
    const Polycube_charts_3& charts = map.charts();
    std::vector<double> coordinates = multiples_in_order_3(surface.mesh, charts, images, surface.spacing, may_join);
    for(std::size_t c = 0; c < coordinates.size(); ++c)
      coordinates[c] = (coordinates[c] - surface.box.center()[charts.axis(c)]) / size;
    const Error_code status = map.start_at(coordinates, budget);
    result = status == OK ? finished_map_3(map, budget) : Surface_map_3{ status };
    if(result.status == OK)
      break;
  }
  return result;
}

// Maps a surface by a function `map(surface)`. If that finds no polycube with the spacing, a polycube without a spacing is moved
// to multiples: walls, slots and bores thinner than the spacing become as wide.
template <typename Map>
Surface_map_3 map_with_thin_walls_3(const Unit_surface_3& surface, const Map& map, const Budget& budget)
{
  const Surface_map_3 first = map(surface);
  if(first.status == OK || surface.spacing == 0)
    return first;
  Unit_surface_3 without_spacing = surface;
  without_spacing.spacing = 0;
  const Surface_map_3 other = map(without_spacing);
  if(other.status != OK)
    return first;
  const Surface_map_3 moved = map_in_order_of_planes_3(surface, other.images, budget);
  return moved.status == OK ? moved : Surface_map_3{ ERROR_SPACING_TOO_COARSE };
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_IN_ORDER_OF_PLANES_3_H
