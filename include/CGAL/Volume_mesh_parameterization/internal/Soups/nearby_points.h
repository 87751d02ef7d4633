// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_NEARBY_POINTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_NEARBY_POINTS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <cmath>
#include <map>
#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns for each point the first one that a chain of steps no longer than a distance joins to it, or the point itself. Chains
// lead over some points only. Points in the boxes of a grid with this spacing find each other in neighboring boxes.
inline std::vector<std::size_t> first_nearby_points(const std::vector<std::array<double, 3> >& points,
                                                    const std::set<std::size_t>& points_of_chains, const double distance)
{
  Disjoint_sets sets(points.size());
  std::map<std::array<double, 3>, std::vector<std::size_t> > grid;
  for(const std::size_t v : points_of_chains)
  {
    std::array<double, 3> box;
    for(std::size_t i = 0; i < 3; ++i)
      box[i] = std::floor(points[v][i] / distance);
    for(int neighbor = 0; neighbor < 27; ++neighbor)
      if(const auto found = grid.find({ box[0] + neighbor % 3 - 1, box[1] + neighbor / 3 % 3 - 1, box[2] + neighbor / 9 - 1 });
         found != grid.end())
        for(const std::size_t w : found->second)
          if((to_vector(points[v]) - to_vector(points[w])).norm() <= distance)
            sets.unite(v, w);
    grid[box].push_back(v);
  }
  std::vector<std::size_t> firsts, result;
  for(const std::size_t set : sets.numbers())
  {
    if(set == firsts.size())
      firsts.push_back(result.size());
    result.push_back(firsts[set]);
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_NEARBY_POINTS_H
