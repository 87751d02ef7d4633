// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SELF_INTERSECTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SELF_INTERSECTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Looks, by exact predicates, for pairs of triangles of a surface that have more in common than their common vertices.
class Self_intersection_3
{
public:
  using Facet = std::array<int, 3>;
  using Pair = std::pair<std::size_t, std::size_t>; // indices of facets

  Self_intersection_3(const Matrix3Xd& points, const std::vector<Facet>& facets) : m_points(points), m_facets(facets)
  {}

  // Enough of the pairs, in ascending order. None if the budget ends before. Triangles without area are left out.
  std::vector<Pair> find(const Budget& budget = Budget(),
                         const std::size_t enough = (std::numeric_limits<std::size_t>::max)()) const
  {
    std::vector<Box> boxes;
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      if(const Triangle t = triangle(f); !CGAL::collinear(t[0], t[1], t[2]))
        boxes.emplace_back(t.bbox(), f);
    std::vector<const Box*> pointers; // which are faster to sort
    for(const Box& box : boxes)
      pointers.push_back(&box);
    std::vector<Pair> result;
    struct End {}; // the only way out of the comparison
    try
    {
      constexpr std::ptrdiff_t cutoff = 2000; // a guess; fewer boxes are compared without a tree
      CGAL::box_self_intersection_d(pointers.begin(), pointers.end(), [&](const Box* const a, const Box* const b)
      {
        if(budget.is_exhausted() || result.size() >= enough)
          throw End();
        if(const Pair pair = std::minmax(a->info(), b->info()); do_intersect(pair.first, pair.second))
          result.push_back(pair);
      }, cutoff);
    }
    catch(const End&)
    {
      if(result.size() < enough)
        return {};
    }
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Triangle = Kernel::Triangle_3;
  using Segment = Kernel::Segment_3;
  using Box = Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

  Exact_point_3 point(const int v) const { return exact_point(m_points.col(v)); }

  Triangle triangle(const std::size_t f) const
  { return Triangle(point(m_facets[f][0]), point(m_facets[f][1]), point(m_facets[f][2])); }

  // Are two points strictly on the same side of a triangle?
  bool is_on_one_side(const int v, const int w, const Facet& facet) const
  {
    const auto side = [&](const int u)
    { return CGAL::orientation(point(facet[0]), point(facet[1]), point(facet[2]), point(u)); };
    const CGAL::Orientation of_v = side(v);
    return of_v != CGAL::COPLANAR && of_v == side(w);
  }

  // Common vertices come last.
  static int put_common_vertices_last(Facet& f, const Facet& other)
  {
    const auto is_single = [&](const int v) { return std::find(other.begin(), other.end(), v) == other.end(); };
    return static_cast<int>(f.end() - std::stable_partition(f.begin(), f.end(), is_single));
  }

  bool do_intersect(const std::size_t a, const std::size_t b) const
  {
    Facet f = m_facets[a], g = m_facets[b];
    const int n = put_common_vertices_last(f, g);
    put_common_vertices_last(g, f);
    if(n == 0)
      return CGAL::do_intersect(triangle(a), triangle(b));
    if(n == 1 && is_on_one_side(f[0], f[1], g))
      return false;
    if(n == 1) // the common vertex is an end of all other edges
      return CGAL::do_intersect(Segment(point(f[0]), point(f[1])), triangle(b))
          || CGAL::do_intersect(Segment(point(g[0]), point(g[1])), triangle(a));
    if(n == 2) // folded onto each other
      return CGAL::coplanar(point(f[1]), point(f[2]), point(f[0]), point(g[0]))
          && CGAL::coplanar_orientation(point(f[1]), point(f[2]), point(f[0]), point(g[0])) == CGAL::POSITIVE;
    return true;
  }

  const Matrix3Xd& m_points;
  const std::vector<Facet>& m_facets;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SELF_INTERSECTION_3_H
