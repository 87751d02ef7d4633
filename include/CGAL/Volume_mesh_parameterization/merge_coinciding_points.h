// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MERGE_COINCIDING_POINTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MERGE_COINCIDING_POINTS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/check_tetrahedron_soup.h>

#include <numeric>

namespace CGAL::Volume_mesh_parameterization {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// finds points with the same coordinates, in O(n log n) time for n points.
///
/// \return for each point, the first one with its coordinates; the point itself, if it has a place of its own
inline std::vector<std::size_t> first_coinciding_points(const std::vector<std::array<double, 3> >& points)
{
  std::vector<std::size_t> order(points.size()), result(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](const std::size_t v, const std::size_t w) { return points[v] < points[w]; });
  for(std::size_t i = 0; i < order.size(); ++i)
    result[order[i]] = i > 0 && points[order[i]] == points[order[i - 1]] ? result[order[i - 1]] : order[i];
  return result;
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// makes cells and marked facets, edges and corners use the first one of points with the same coordinates. The other ones stay, so
/// that indices have their meaning, and have no cell any more.
///
/// \return that of `first_coinciding_points()`
///
/// \exception Input_error as the functions for arrays; the soup is then unchanged.
inline std::vector<std::size_t> merge_coinciding_points(Tetrahedron_soup_3& soup)
{
  internal::check_simplices(soup);
  std::vector<std::size_t> first = first_coinciding_points(soup.points);
  for(std::array<std::size_t, 4>& cell : soup.cells)
    for(std::size_t& v : cell)
      v = first[v];
  for(std::array<std::size_t, 3>& facet : soup.facets)
    for(std::size_t& v : facet)
      v = first[v];
  for(std::array<std::size_t, 2>& edge : soup.edges)
    for(std::size_t& v : edge)
      v = first[v];
  for(std::size_t& v : soup.corners)
    v = first[v];
  return first;
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MERGE_COINCIDING_POINTS_H
