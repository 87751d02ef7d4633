// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_MANIFOLD_VOXELS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_MANIFOLD_VOXELS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Voxels_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <optional>

namespace CGAL::Polycube_meshing_3::internal {

// Returns whether the boundary between a set of octants around a point and the others is a disc there, or empty: faces join the
// octants of the set, and the others, too.
inline bool is_manifold_at(const unsigned int octants)
{
  static const std::array<bool, 256> result = []
  {
    std::array<bool, 256> of_sets;
    for(unsigned int set = 0; set < of_sets.size(); ++set)
    {
      Disjoint_sets parts(8);
      for(unsigned int k = 0; k < 8; ++k)
        for(const unsigned int next : { k ^ 1u, k ^ 2u, k ^ 4u })
          if((set >> k & 1) == (set >> next & 1))
            parts.unite(k, next);
      const std::vector<std::size_t> numbers = parts.numbers();
      of_sets[set] = *std::max_element(numbers.begin(), numbers.end()) < 2;
    }
    return of_sets;
  }();
  return result[octants];
}

// Returns the Euler characteristic of the part of the boundary of voxels that is at points of a box: vertices, and edges and
// faces by their lowest points. Nothing if the boundary is no manifold there.
inline std::optional<int> characteristic_of_voxels_3(const Voxels_3& voxels, const Eigen::Vector3i& lo, const Eigen::Vector3i& hi)
{
  int result = 0;
  for(int k = lo[2]; k <= hi[2]; ++k)
    for(int j = lo[1]; j <= hi[1]; ++j)
      for(int i = lo[0]; i <= hi[0]; ++i)
      {
        const unsigned int octants = voxels.octants(Eigen::Vector3i(i, j, k));
        if(!is_manifold_at(octants))
          return std::nullopt;
        result += octants != 0 && octants != 255;
        for(unsigned int a = 0; a < 3; ++a)
        {
          const unsigned int u = 1u << (a + 1) % 3, v = 1u << (a + 2) % 3, upper = 1u << a;
          const unsigned int around = (octants >> upper & 1) + (octants >> (upper | u) & 1) + (octants >> (upper | v) & 1)
                                    + (octants >> (upper | u | v) & 1);
          result -= around > 0 && around < 4;                                 // the edge along a
          result += (octants >> (u | v) & 1) != (octants >> (u | v | upper) & 1); // the face normal to a
        }
      }
  return result;
}

// Adds or removes voxels where the boundary is no manifold, those first of which it is least certain that they are inside.
// Returns whether it is one then.
inline bool make_manifold(Voxels_3& voxels, const double least_part)
{
  constexpr int maximum_number_of_changes = 20000; // a guess
  const auto is_bad = [&](const Eigen::Vector3i& p) { return !is_manifold_at(voxels.octants(p)); };
  std::deque<Eigen::Vector3i> bad;
  const auto collect = [&](const Eigen::Vector3i& lo, const Eigen::Vector3i& hi)
  {
    for(int k = lo[2]; k <= hi[2]; ++k)
      for(int j = lo[1]; j <= hi[1]; ++j)
        for(int i = lo[0]; i <= hi[0]; ++i)
          if(is_bad(Eigen::Vector3i(i, j, k)))
            bad.emplace_back(i, j, k);
  };
  const auto number_of_bad_points = [&](const Eigen::Vector3i& v)
  {
    int result = 0;
    for(unsigned int k = 0; k < 8; ++k)
      result += is_bad(v + Voxels_3::octant(k));
    return result;
  };
  collect(Eigen::Vector3i::Zero(), voxels.size);
  std::vector<int> changes(voxels.is_inside.size(), 0);
  for(int i = 0; !bad.empty() && i < maximum_number_of_changes; ++i)
  {
    const Eigen::Vector3i p = bad.front();
    bad.pop_front();
    if(!is_bad(p))
      continue;
    double least_cost = (std::numeric_limits<double>::infinity)();
    std::size_t best = 0;
    for(unsigned int k = 0; k < 8; ++k)
    {
      const Eigen::Vector3i v = p + Voxels_3::octant(k) - Eigen::Vector3i::Ones();
      if(!voxels.is_in_box(v, 1))
        continue;
      const std::size_t index = voxels.index(v);
      const int before = number_of_bad_points(v);
      voxels.is_inside[index] = !voxels.is_inside[index];
      const int after = number_of_bad_points(v);
      voxels.is_inside[index] = !voxels.is_inside[index];
      // weights are guesses: a bad point more is worse than any doubt, and a voxel that changed before is left alone
      const double cost = after - before + 0.9 * std::abs(voxels.parts[index] - least_part) + 0.7 * changes[index];
      if(cost < least_cost)
      {
        least_cost = cost;
        best = index;
      }
    }
    if(std::isinf(least_cost))
      return false;
    voxels.is_inside[best] = !voxels.is_inside[best];
    ++changes[best];
    collect(voxels.voxel(best), voxels.voxel(best) + Eigen::Vector3i::Ones());
  }
  return bad.empty();
}

// Keeps the largest of the parts of a body that share faces, and fills its cavities.
inline void keep_largest_part(Voxels_3& voxels)
{
  for(const bool is_inside : { true, false })
  {
    Disjoint_sets sets(voxels.is_inside.size());
    for(std::size_t i = 0; i < voxels.is_inside.size(); ++i)
      for(const std::size_t d : { 0, 2, 4 })
        if(const Eigen::Vector3i w = voxels.voxel(i) + step_of_direction(d);
           voxels.is_in_box(w) && voxels.is_inside[i] == is_inside && voxels.is_inside[voxels.index(w)] == is_inside)
          sets.unite(i, voxels.index(w));
    std::vector<std::size_t> sizes(voxels.is_inside.size(), 0);
    for(std::size_t i = 0; i < sizes.size(); ++i)
      if(voxels.is_inside[i] == is_inside)
        ++sizes[sets.find(i)];
    const std::size_t kept = is_inside ? static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin())
                                       : sets.find(0); // the corner of the box is outside
    for(std::size_t i = 0; i < sizes.size(); ++i)
      if(voxels.is_inside[i] == is_inside && sets.find(i) != kept)
        voxels.is_inside[i] = !is_inside;
  }
}

// Makes the boundary of voxels a connected manifold of the given Euler characteristic, if it is nearly one. Returns whether it
// is one then.
inline bool make_surface_of_characteristic(Voxels_3& voxels, const double least_part, const int characteristic)
{
  keep_largest_part(voxels);
  if(!make_manifold(voxels, least_part))
    return false;
  keep_largest_part(voxels);
  return std::find(voxels.is_inside.begin(), voxels.is_inside.end(), true) != voxels.is_inside.end()
         && characteristic_of_voxels_3(voxels, Eigen::Vector3i::Zero(), voxels.size) == characteristic;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_MANIFOLD_VOXELS_3_H
