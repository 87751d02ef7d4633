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

#include <cmath>
#include <map>

namespace CGAL::Volume_mesh_parameterization::internal {

// Plane of voxels along an axis: the area of its charts, and the integral of their coordinate on the surface.
struct Plane_of_voxels_3
{
  double area = 0, moment = 0;
};

// Returns coordinates in their order, at least as far apart as the gap, that are closest to the means of the planes in the sense
// of least squares: by the algorithm of adjacent violators.
inline std::vector<double> ordered_means(const std::vector<Plane_of_voxels_3>& planes, const double gap)
{
  struct Block { double area, moment; std::size_t size; };
  std::vector<Block> blocks;
  const auto mean = [](const Block& block) { return block.moment / block.area; };
  for(std::size_t i = 0; i < planes.size(); ++i)
  {
    blocks.push_back({ planes[i].area, planes[i].moment - planes[i].area * gap * static_cast<double>(i), 1 });
    while(blocks.size() > 1 && mean(blocks[blocks.size() - 2]) >= mean(blocks.back()))
    {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back() = { blocks.back().area + last.area, blocks.back().moment + last.moment, blocks.back().size + last.size };
    }
  }
  std::vector<double> result;
  for(const Block& block : blocks)
    for(std::size_t k = 0; k < block.size; ++k)
      result.push_back(mean(block) + gap * static_cast<double>(result.size()));
  return result;
}

// Returns coordinates of charts that keep the order of the planes of the voxels along each axis, so that the polycube stays
// embedded: space is mapped by monotone functions of the coordinates. With a spacing, they are multiples of it away from the
// origin.
inline std::vector<double> coordinates_of_voxel_charts_3(const Facets_3& facets, const std::vector<std::size_t>& chart_of_facet,
                                                         const std::vector<std::size_t>& label_of_chart,
                                                         const std::vector<int>& plane_of_chart, const double gap,
                                                         const Eigen::Vector3d& origin, const double spacing)
{
  std::vector<double> result(label_of_chart.size());
  for(int axis = 0; axis < 3; ++axis)
  {
    std::map<int, Plane_of_voxels_3> planes;
    for(std::size_t f = 0; f < chart_of_facet.size(); ++f)
      if(const std::size_t c = chart_of_facet[f]; axis_of_direction(label_of_chart[c]) == axis)
      {
        planes[plane_of_chart[c]].area += facets.areas[f];
        planes[plane_of_chart[c]].moment += facets.areas[f] * facets.centers[f][axis];
      }
    std::vector<Plane_of_voxels_3> in_order;
    std::map<int, std::size_t> indices;
    for(const auto& [plane, measures] : planes)
    {
      indices.emplace(plane, in_order.size());
      in_order.push_back(measures);
    }
    std::vector<double> coordinates = ordered_means(in_order, (std::max)(gap, spacing * (1 + 1e-9)));
    for(double& x : coordinates)
      if(spacing > 0)
        x = origin[axis] + spacing * std::round((x - origin[axis]) / spacing);
    for(std::size_t c = 0; c < label_of_chart.size(); ++c)
      if(axis_of_direction(label_of_chart[c]) == axis)
        result[c] = coordinates[indices.at(plane_of_chart[c])];
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_COORDINATES_OF_VOXEL_CHARTS_3_H
