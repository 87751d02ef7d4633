// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_POLYLINE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_POLYLINE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Vector_3.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Curve through points, by the length from its first point.
class Polyline_3
{
public:
  explicit Polyline_3(std::vector<Vector_3> points) : m_points(std::move(points)), m_lengths{ 0 }
  {
    for(std::size_t i = 1; i < m_points.size(); ++i)
      m_lengths.push_back(m_lengths.back() + (m_points[i] - m_points[i - 1]).norm());
  }

  const std::vector<Vector_3>& points() const { return m_points; }
  const std::vector<double>& lengths() const { return m_lengths; } // up to each point
  double length() const { return m_lengths.back(); }

  // Returns the index of the point at the end of the edge at a length.
  std::size_t end_of_edge_at(const double length) const
  {
    return static_cast<std::size_t>(std::upper_bound(m_lengths.begin() + 1, m_lengths.end() - 1, length) - m_lengths.begin());
  }

  Vector_3 point(const double length) const
  {
    const std::size_t i = end_of_edge_at(length);
    const double t = (length - m_lengths[i - 1]) / (m_lengths[i] - m_lengths[i - 1]);
    return t <= 0 ? m_points[i - 1] : t >= 1 ? m_points[i] : m_points[i - 1] + t * (m_points[i] - m_points[i - 1]);
  }

  // Returns the lengths of inner points which make, with both ends, a polyline within a distance of all points.
  std::vector<double> bends(const double distance) const
  {
    std::vector<double> result;
    for(std::size_t first = 0, last = 1; last + 1 < m_points.size(); ++last)
      if(deviation(first, last + 1) > distance)
      {
        result.push_back(m_lengths[last]);
        first = last;
      }
    return result;
  }

  // Returns the distance of a point, and the length at which the curve is nearest to it.
  std::pair<double, double> nearest(const Vector_3& p) const
  {
    std::pair<double, double> result = { (std::numeric_limits<double>::infinity)(), 0 };
    for(std::size_t i = 1; i < m_points.size(); ++i)
    {
      const Vector_3 way = m_points[i] - m_points[i - 1];
      const double part = std::clamp(way.dot(p - m_points[i - 1]) / way.squaredNorm(), 0., 1.);
      result = (std::min)(result, { (m_points[i - 1] + part * way - p).norm(), m_lengths[i - 1] + part * way.norm() });
    }
    return result;
  }

private:
  // Returns the largest distance of the points between two others from the segment between these.
  double deviation(const std::size_t first, const std::size_t last) const
  {
    const Polyline_3 chord({ m_points[first], m_points[last] });
    double result = 0;
    for(std::size_t i = first + 1; i < last; ++i)
      result = (std::max)(result, chord.nearest(m_points[i]).first);
    return result;
  }

  std::vector<Vector_3> m_points;
  std::vector<double> m_lengths;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_POLYLINE_3_H
