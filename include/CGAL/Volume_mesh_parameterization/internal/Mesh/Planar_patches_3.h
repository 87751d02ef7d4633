// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_PLANAR_PATCHES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_PLANAR_PATCHES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Disjoint_sets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_point_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// A triangulated surface as patches of neighbouring facets that are coplanar: exactly, or nearly, as
// where coordinates were rounded in a file. A patch is planar if its vertices are within `tolerance` of
// its plane. A patch that almost coplanar facets have led around a bend is not.
class Planar_patches_3
{
public:
  using Facet = std::array<int, 3>;

  Planar_patches_3(const Eigen::Matrix3Xd& points, const std::vector<Facet>& facets, const double tolerance)
    : m_patch(facets.size())
  {
    unite_coplanar_facets(points, facets);
    fit_planes(points, facets, tolerance);
  }

  // The patch of a facet is named by one of its facets.
  std::size_t patch(const std::size_t facet) const { return m_patch[facet]; }
  bool is_planar(const std::size_t patch) const { return m_is_planar[patch]; }

  // The unit normal; exactly an axis if a coordinate of all vertices is the same.
  const Eigen::Vector3d& normal(const std::size_t patch) const { return m_normal[patch]; }

private:
  // twice the area, times the unit normal
  static Eigen::Vector3d area_vector(const Eigen::Matrix3Xd& points, const Facet& facet)
  {
    const Eigen::Vector3d a = points.col(facet[1]) - points.col(facet[0]);
    const Eigen::Vector3d b = points.col(facet[2]) - points.col(facet[0]);
    return a.cross(b);
  }

  // Along an axis, it is so exactly: a division by the length may be a multiplication by its rounded reciprocal.
  static Eigen::Vector3d unit_normal(const Eigen::Vector3d& n)
  {
    return (n.array() != 0).count() == 1 ? Eigen::Vector3d(n.array().sign()) : n.stableNormalized();
  }

  static Exact_point_3 exact_point(const Eigen::Matrix3Xd& points, const int v)
  {
    return Exact_point_3(points(0, v), points(1, v), points(2, v));
  }

  // Are two facets with a common edge coplanar, and on either side of it?
  static bool are_coplanar(const Eigen::Matrix3Xd& points, const Facet& f, const Facet& g)
  {
    constexpr double small_angle = 1e-3; // a rounded coordinate turns a small facet much
    const Eigen::Vector3d m = area_vector(points, f).stableNormalized(), n = area_vector(points, g).stableNormalized();
    if(m.dot(n) > 0 && m.cross(n).norm() <= small_angle)
      return true;
    const int i = apex(f, g);
    const Exact_point_3 p = exact_point(points, f[(i + 1) % 3]), q = exact_point(points, f[(i + 2) % 3]);
    const Exact_point_3 r = exact_point(points, f[i]), s = exact_point(points, g[apex(g, f)]);
    return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::NEGATIVE;
  }

  // The index of the vertex of f that is not in its neighbour g.
  static int apex(const Facet& f, const Facet& g)
  {
    int i = 0;
    while(std::find(g.begin(), g.end(), f[i]) != g.end())
      ++i;
    return i;
  }

  void unite_coplanar_facets(const Eigen::Matrix3Xd& points, const std::vector<Facet>& facets)
  {
    Disjoint_sets patches(facets.size());
    for_each_pair_of_neighbours(facets, [&](const std::size_t f, const std::size_t g)
    {
      if(are_coplanar(points, facets[f], facets[g]))
        patches.unite(f, g);
    });
    for(std::size_t f = 0; f < facets.size(); ++f)
      m_patch[f] = patches.find(f);
  }

  // An edge of more than two facets joins none of them.
  template <typename Function>
  static void for_each_pair_of_neighbours(const std::vector<Facet>& facets, const Function& f)
  {
    std::vector<std::pair<std::pair<int, int>, std::size_t> > edges; // each with a facet
    for(std::size_t i = 0; i < facets.size(); ++i)
      for(int k = 0; k < 3; ++k)
        edges.emplace_back(std::minmax({facets[i][k], facets[i][(k + 1) % 3]}), i);
    std::sort(edges.begin(), edges.end());
    for(auto begin = edges.begin(), end = begin; begin != edges.end(); begin = end)
    {
      end = std::find_if(begin, edges.end(), [&](const auto& edge) { return edge.first != begin->first; });
      if(end - begin == 2)
        f(begin->second, (begin + 1)->second);
    }
  }

  void fit_planes(const Eigen::Matrix3Xd& points, const std::vector<Facet>& facets, const double tolerance)
  {
    m_normal.assign(facets.size(), Eigen::Vector3d::Zero());
    m_is_planar.assign(facets.size(), true);
    for(std::size_t f = 0; f < facets.size(); ++f)
      m_normal[m_patch[f]] += area_vector(points, facets[f]);
    for(Eigen::Vector3d& normal : m_normal)
      normal = unit_normal(normal);
    for(std::size_t f = 0; f < facets.size(); ++f)
    {
      const std::size_t patch = m_patch[f];
      for(const int v : facets[f])
        if(!(std::abs(m_normal[patch].dot(points.col(v) - points.col(facets[patch][0]))) <= tolerance))
          m_is_planar[patch] = false;
    }
  }

  std::vector<std::size_t> m_patch;      // of each facet
  std::vector<Eigen::Vector3d> m_normal; // of each patch
  std::vector<bool> m_is_planar;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_PLANAR_PATCHES_3_H
