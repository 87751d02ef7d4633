// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VOXELS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VOXELS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/directions.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Body of voxels in a box, with three layers free on each side.
struct Voxels_3
{
  Eigen::Vector3i size = Eigen::Vector3i::Zero();     // numbers of voxels along the axes
  double spacing = 0;
  Vector_3 origin = Vector_3::Zero();   // lowest corner of the box
  std::vector<double> parts;                          // part of each voxel, by its index, that is inside of a surface
  std::vector<bool> is_inside;                        // whether each voxel belongs to the body

  std::size_t index(const Eigen::Vector3i& v) const { return static_cast<std::size_t>((v[2] * size[1] + v[1]) * size[0] + v[0]); }

  Eigen::Vector3i voxel(const std::size_t index) const
  {
    const int i = static_cast<int>(index);
    return Eigen::Vector3i(i % size[0], i / size[0] % size[1], i / size[0] / size[1]);
  }

  // Returns whether a voxel is in the box, with at least so many voxels between it and the sides.
  bool is_in_box(const Eigen::Vector3i& v, const int distance = 0) const
  { return (v.array() >= distance).all() && (v.array() < size.array() - distance).all(); }

  bool contains(const Eigen::Vector3i& v) const { return is_in_box(v) && is_inside[index(v)]; }

  // Returns which of the eight octants around the lowest corner of voxel p are in the body: bit k of the result for octant k. Bits
  // 1, 2 and 4 of k are set for octants on the side of +x, +y and +z.
  unsigned int octants(const Eigen::Vector3i& p) const
  {
    unsigned int result = 0;
    for(unsigned int k = 0; k < 8; ++k)
      if(contains(p + octant(k) - Eigen::Vector3i::Ones()))
        result |= 1u << k;
    return result;
  }

  // Returns the steps along the axes from octant 0 to another one.
  static Eigen::Vector3i octant(const unsigned int k)
  { return Eigen::Vector3i(static_cast<int>(k & 1), static_cast<int>(k >> 1 & 1), static_cast<int>(k >> 2 & 1)); }
};

// Vertical lines through regular samples of voxels, with the heights at which a surface crosses the lines.
class Columns_of_voxels_3
{
public:
  static constexpr int samples = 3; // along each axis of a voxel; a guess: 27 points of a voxel decide which part is inside

  explicit Columns_of_voxels_3(const Voxels_3& voxels)
    : m_origin(voxels.origin), m_spacing(voxels.spacing / samples), m_size{ samples * voxels.size[0], samples * voxels.size[1] },
      m_heights(static_cast<std::size_t>(m_size[0] * m_size[1]))
  {}

  void add_crossings(const std::array<Vector_3, 3>& triangle)
  {
    const Vector_3 a = scaled(triangle[0]), b = scaled(triangle[1]), c = scaled(triangle[2]);
    const double area = cross_product(b - a, c - a);
    if(area == 0)
      return;
    std::array<int, 2> lo, hi;
    for(int axis = 0; axis < 2; ++axis)
    {
      const auto [least, largest] = std::minmax({ a[axis], b[axis], c[axis] });
      lo[axis] = (std::max)(0, static_cast<int>(std::ceil(least)));
      hi[axis] = (std::min)(m_size[axis] - 1, static_cast<int>(std::floor(largest)));
    }
    for(int j = lo[1]; j <= hi[1]; ++j)
      for(int i = lo[0]; i <= hi[0]; ++i)
      {
        const Vector_3 p(i, j, 0); // whose barycentric coordinates are u, v and w
        const double u = cross_product(b - p, c - p) / area, v = cross_product(c - p, a - p) / area, w = 1 - u - v;
        if(u >= 0 && v >= 0 && w >= 0)
          m_heights[static_cast<std::size_t>(j * m_size[0] + i)].push_back(u * a[2] + v * b[2] + w * c[2]);
      }
  }

  // Adds to each voxel the part of its samples that are inside: between an odd and the next even crossing of their line.
  void add_parts_to(Voxels_3& voxels)
  {
    constexpr double part = 1. / (samples * samples * samples);
    for(int j = 0; j < m_size[1]; ++j)
      for(int i = 0; i < m_size[0]; ++i)
      {
        std::vector<double>& heights = m_heights[static_cast<std::size_t>(j * m_size[0] + i)];
        std::sort(heights.begin(), heights.end());
        for(std::size_t k = 0; k + 1 < heights.size(); k += 2)
          for(int l = (std::max)(0, static_cast<int>(std::ceil(heights[k])));
              l < heights[k + 1] && l < samples * voxels.size[2]; ++l)
            voxels.parts[voxels.index(Eigen::Vector3i(i / samples, j / samples, l / samples))] += part;
      }
  }

private:
  static double cross_product(const Vector_3& p, const Vector_3& q) { return p[0] * q[1] - p[1] * q[0]; }

  // Returns coordinates in which samples have whole numbers. Lines are shifted by small arbitrary parts of the distance between
  // them, so that they miss vertices of regular meshes.
  Vector_3 scaled(const Vector_3& p) const
  { return (p - m_origin) / m_spacing - Vector_3(0.5 + 1.234e-4, 0.5 - 2.345e-4, 0.5); }

  Vector_3 m_origin;
  double m_spacing;
  std::array<int, 2> m_size;
  std::vector<std::vector<double> > m_heights; // for each line, along x first
};

// Returns the voxels of which more than `least_part` is inside of a closed surface. The shift of the grid is in units of voxels.
inline Voxels_3 voxels_of_surface_3(const Boundary_mesh_3& mesh, const double spacing, const Vector_3& shift,
                                    const double least_part)
{
  constexpr int free_layers = 3; // on each side: charts may move outward, and voxels may be added where the body is pinched
  const std::vector<Vector_3> points = points_of(mesh);
  const Box_3 box = bounding_box(points);
  Voxels_3 voxels;
  voxels.spacing = spacing;
  for(int axis = 0; axis < 3; ++axis)
    voxels.size[axis] = static_cast<int>(std::ceil(box.diagonal()[axis] / spacing)) + 2 * free_layers;
  voxels.origin = box.center() - spacing / 2 * voxels.size.cast<double>() + spacing * shift;
  voxels.parts.assign(static_cast<std::size_t>(voxels.size.prod()), 0);
  Columns_of_voxels_3 columns(voxels);
  for(const auto f : mesh.faces())
  {
    const auto [a, b, c] = vertices_of_face(mesh, f);
    columns.add_crossings({ points[a], points[b], points[c] });
  }
  columns.add_parts_to(voxels);
  for(const double part : voxels.parts)
    voxels.is_inside.push_back(part > least_part);
  return voxels;
}

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

// Returns the Euler characteristic of the vertices, edges and faces of the boundary of voxels whose lowest points are in the box
// from lo to hi. Returns nothing if the boundary is no manifold there.
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
        for(unsigned int axis = 0; axis < 3; ++axis)
        {
          const unsigned int u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3, upper = 1u << axis;
          const unsigned int around = (octants >> upper & 1) + (octants >> (upper | u) & 1) + (octants >> (upper | v) & 1)
                                    + (octants >> (upper | u | v) & 1);
          result -= around > 0 && around < 4;                                 // the edge along the axis
          result += (octants >> (u | v) & 1) != (octants >> (u | v | upper) & 1); // the face normal to the axis
        }
      }
  return result;
}

// Adds or removes voxels where the boundary is no manifold, those first whose parts inside are closest to the least one. Returns
// whether the boundary is a manifold then.
inline bool make_manifold(Voxels_3& voxels, const double least_part)
{
  constexpr int maximum_number_of_changes = 20000; // a guess
  const auto is_bad = [&](const Eigen::Vector3i& p) { return !is_manifold_at(voxels.octants(p)); };
  const auto flip = [&](const std::size_t voxel) { voxels.is_inside[voxel] = !voxels.is_inside[voxel]; };
  std::deque<Eigen::Vector3i> bad; // points
  const auto collect = [&](const Eigen::Vector3i& lo, const Eigen::Vector3i& hi)
  {
    for(int k = lo[2]; k <= hi[2]; ++k)
      for(int j = lo[1]; j <= hi[1]; ++j)
        for(int i = lo[0]; i <= hi[0]; ++i)
          if(is_bad(Eigen::Vector3i(i, j, k)))
            bad.emplace_back(i, j, k);
  };
  const auto number_of_bad_corners = [&](const Eigen::Vector3i& v)
  {
    int result = 0;
    for(unsigned int k = 0; k < 8; ++k)
      result += is_bad(v + Voxels_3::octant(k));
    return result;
  };
  collect(Eigen::Vector3i::Zero(), voxels.size);
  std::vector<int> number_of_changes(voxels.is_inside.size(), 0); // of each voxel
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
      const int before = number_of_bad_corners(v);
      flip(index);
      const int after = number_of_bad_corners(v);
      flip(index);
      // weights are guesses: a bad corner more is worse than any doubt, and a voxel that changed before is left alone
      const double cost = after - before + 0.9 * std::abs(voxels.parts[index] - least_part) + 0.7 * number_of_changes[index];
      if(cost < least_cost)
      {
        least_cost = cost;
        best = index;
      }
    }
    if(std::isinf(least_cost))
      return false;
    flip(best);
    ++number_of_changes[best];
    collect(voxels.voxel(best), voxels.voxel(best) + Eigen::Vector3i::Ones());
  }
  return bad.empty();
}

// Keeps the largest of the parts of a body that are connected by faces of voxels, and fills its cavities.
inline void keep_largest_part_without_cavities(Voxels_3& voxels)
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

// Makes the boundary of voxels a connected manifold, if it is nearly one. Returns whether the boundary is one of the given Euler
// characteristic then.
inline bool make_surface_of_characteristic(Voxels_3& voxels, const double least_part, const int characteristic)
{
  keep_largest_part_without_cavities(voxels);
  if(!make_manifold(voxels, least_part))
    return false;
  keep_largest_part_without_cavities(voxels);
  return std::find(voxels.is_inside.begin(), voxels.is_inside.end(), true) != voxels.is_inside.end()
         && characteristic_of_voxels_3(voxels, Eigen::Vector3i::Zero(), voxels.size) == characteristic;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VOXELS_3_H
