// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_COORDINATES_OF_VOXEL_CHARTS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_COORDINATES_OF_VOXEL_CHARTS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Split_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/directions.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/ordered_coordinates_3.h>

#include <map>

namespace CGAL::Polycube_meshing_3::internal {

// Returns coordinates of charts that keep the order of the planes of the voxels along each axis, with a gap between planes at
// least: the polycube stays embedded, as space is mapped by monotone functions of the coordinates. Among such coordinates, they
// are those closest to the means of the planes on the surface in the sense of least squares.
inline std::vector<double> coordinates_of_voxel_charts_3(const Facets_3& facets, const std::vector<std::size_t>& chart_of_facet,
                                                         const std::vector<std::size_t>& label_of_chart,
                                                         const std::vector<int>& plane_of_chart, const double gap,
                                                         const Plane_grid_3& grid)
{
  std::vector<double> result(label_of_chart.size());
  for(int axis = 0; axis < 3; ++axis)
  {
    const auto is_along_axis = [&](const std::size_t c) { return axis_of_direction(label_of_chart[c]) == axis; };
    std::map<int, std::size_t> number_of_plane;
    for(std::size_t c = 0; c < label_of_chart.size(); ++c)
      if(is_along_axis(c))
        number_of_plane.emplace(plane_of_chart[c], 0);
    std::vector<Order_of_coordinates> orders;
    std::size_t n = 0;
    for(auto& [plane, number] : number_of_plane)
    {
      number = n++;
      if(number > 0)
        orders.push_back({ number - 1, number, gap });
    }
    std::vector<double> areas(n, 0), moments(n, 0);
    for(std::size_t f = 0; f < chart_of_facet.size(); ++f)
      if(const std::size_t c = chart_of_facet[f]; is_along_axis(c))
      {
        const std::size_t number = number_of_plane.at(plane_of_chart[c]);
        areas[number] += facets.areas[f];
        moments[number] += facets.areas[f] * facets.centers[f][axis];
      }
    const std::vector<double> coordinates = ordered_coordinates_3(areas, moments, orders, grid, axis).value().values;
    for(std::size_t c = 0; c < label_of_chart.size(); ++c)
      if(is_along_axis(c))
        result[c] = coordinates[number_of_plane.at(plane_of_chart[c])];
  }
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_COORDINATES_OF_VOXEL_CHARTS_3_H
