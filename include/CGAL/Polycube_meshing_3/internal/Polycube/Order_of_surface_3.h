// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_ORDER_OF_SURFACE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_ORDER_OF_SURFACE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace CGAL::Polycube_meshing_3::internal {

// Order of the points and facets of a surface by the distances of the points from the center of the surface. The order depends
// neither on their numbers nor on the position of the surface. Greedy searches that visit facets one after the other then find the
// same however the surface is numbered and turned, up to points that rounding or a symmetry makes equally distant.
class Order_of_surface_3
{
public:
  explicit Order_of_surface_3(const Numbered_surface_3& surface)
    : m_surface(surface), m_points(surface.points.size()), m_indices(surface.points.size()), m_facets(surface.facets.size())
  {
    const std::vector<double> distance = squared_distances();
    std::iota(m_points.begin(), m_points.end(), 0);
    std::stable_sort(m_points.begin(), m_points.end(),
                     [&](const std::size_t v, const std::size_t w) { return distance[v] < distance[w]; });
    for(std::size_t i = 0; i < m_points.size(); ++i)
      m_indices[m_points[i]] = i;
    std::vector<std::array<std::size_t, 3> > keys;
    for(const std::array<std::size_t, 3>& facet : surface.facets)
      keys.push_back(sorted(indices_of(facet)));
    std::iota(m_facets.begin(), m_facets.end(), 0);
    std::sort(m_facets.begin(), m_facets.end(), [&](const std::size_t f, const std::size_t g) { return keys[f] < keys[g]; });
  }

  // Returns the surface in this order; each facet begins with its first point.
  Numbered_surface_3 surface() const
  {
    Numbered_surface_3 result;
    result.cells = m_surface.cells;
    for(const std::size_t v : m_points)
    {
      result.points.push_back(m_surface.points[v]);
      result.vertices.push_back(m_surface.vertices[v]);
    }
    for(const std::size_t f : m_facets)
    {
      std::array<std::size_t, 3> facet = indices_of(m_surface.facets[f]);
      std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
      result.facets.push_back(facet);
    }
    for(const std::array<std::size_t, 2>& edge : m_surface.sharp_edges)
      result.sharp_edges.push_back(sorted(indices_of(edge)));
    std::sort(result.sharp_edges.begin(), result.sharp_edges.end());
    return result;
  }

  // Returns values of facets, which are in the order of the given surface, in this order.
  std::vector<std::size_t> of_facets(const std::vector<std::size_t>& values) const
  {
    CGAL_assertion(values.empty() || values.size() == m_facets.size());
    std::vector<std::size_t> result;
    for(std::size_t i = 0; i < values.size(); ++i)
      result.push_back(values[m_facets[i]]);
    return result;
  }

  // Returns values of points, which are in this order, in that of the given surface. Points that were added to the surface come
  // behind all others in both orders.
  std::vector<Vector_3> in_given_order(const std::vector<Vector_3>& values) const
  {
    std::vector<Vector_3> result(values.size());
    for(std::size_t i = 0; i < values.size(); ++i)
      result[given_point(i)] = values[i];
    return result;
  }

  // Returns the number in the given surface, or of a point added there, of the point at a place in this order.
  std::size_t given_point(const std::size_t i) const { return i < m_points.size() ? m_points[i] : i; }

private:
  template <std::size_t n>
  std::array<std::size_t, n> indices_of(std::array<std::size_t, n> simplex) const
  {
    for(std::size_t& v : simplex)
      v = m_indices[v];
    return simplex;
  }

  // Returns the squared distances of the points from the center, up to a common factor; 0 if a distance is not finite.
  std::vector<double> squared_distances() const
  {
    Vector_3 moment = Vector_3::Zero();
    double area = 0;
    for(const auto& [a, b, c] : m_surface.facets)
    {
      const Vector_3 &p = m_surface.points[a], &q = m_surface.points[b], &r = m_surface.points[c];
      const double twice_area = (q - p).cross(r - p).norm();
      moment += twice_area * (p + q + r) / 3;
      area += twice_area;
    }
    std::vector<double> result;
    for(const Vector_3& p : m_surface.points)
    {
      const double distance = (area * p - moment).squaredNorm();
      result.push_back(std::isfinite(distance) ? distance : 0);
    }
    return result;
  }

  const Numbered_surface_3& m_surface;
  std::vector<std::size_t> m_points, m_indices, m_facets; // points in this order, index of each point there, facets in this order
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_ORDER_OF_SURFACE_3_H
