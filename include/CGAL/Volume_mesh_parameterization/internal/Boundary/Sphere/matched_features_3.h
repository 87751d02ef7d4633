// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MATCHED_FEATURES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MATCHED_FEATURES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Surface_relaxation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>

#include <set>
#include <tuple>

namespace CGAL::Volume_mesh_parameterization::internal {

// Points along sharp edges, from one corner to another one, or around a closed curve, whose first point is also the last one.
struct Feature_curve_3
{
  std::vector<std::size_t> vertices;
  std::vector<Vector_3> points;
  std::vector<double> parts; // of the length, up to each point

  bool is_closed() const { return vertices.front() == vertices.back(); }

  Vector_3 point(const double part) const
  {
    const auto next = std::upper_bound(parts.begin() + 1, parts.end() - 1, part);
    const std::size_t i = static_cast<std::size_t>(next - parts.begin());
    const double t = (part - parts[i - 1]) / (parts[i] - parts[i - 1]);
    return t <= 0 ? points[i - 1] : t >= 1 ? points[i] : points[i - 1] + t * (points[i] - points[i - 1]);
  }

  // Returns the part of the length up to the nearest vertex.
  double nearest_part(const Vector_3& p) const
  {
    const auto nearest = std::min_element(points.begin(), points.end(), [&](const Vector_3& q, const Vector_3& r)
    { return (q - p).squaredNorm() < (r - p).squaredNorm(); });
    return parts[static_cast<std::size_t>(nearest - points.begin())];
  }
};

// The curves of sharp edges of a surface, marked or found.
inline std::vector<Feature_curve_3> feature_curves_3(const Numbered_surface_3& surface)
{
  const auto point = [&](const std::size_t v) { return surface.points[v]; };
  const Feature_curves_3 features(sharp_edges_3(surface.facets, surface.sharp_edges, point), arrays_of(surface.points));
  std::vector<bool> is_done(features.edges().size(), false);
  std::vector<Feature_curve_3> result;
  const auto follow = [&](const std::size_t first, std::size_t edge)
  {
    Feature_curve_3 curve;
    double length = 0;
    for(std::size_t v = first; ; )
    {
      length += curve.points.empty() ? 0 : (surface.points[v] - curve.points.back()).norm();
      curve.vertices.push_back(v);
      curve.points.push_back(surface.points[v]);
      curve.parts.push_back(length);
      if(curve.vertices.size() > 1 && (v == first || features.is_corner(v)))
        break;
      const auto& at = features.edges_of_vertices().at(v);
      edge = is_done[edge] ? (at[0] == edge ? at[1] : at[0]) : edge;
      is_done[edge] = true;
      const auto& [a, b] = features.edges()[edge];
      v = a == v ? b : a;
    }
    for(double& part : curve.parts)
      part /= length;
    result.push_back(std::move(curve));
  };
  for(const auto& [v, at] : features.edges_of_vertices())
    for(const std::size_t edge : at)
      if(features.is_corner(v) && !is_done[edge])
        follow(v, edge);
  for(std::size_t edge = 0; edge < is_done.size(); ++edge)
    if(!is_done[edge])
      follow(features.edges()[edge][0], edge);
  return result;
}

// Pairs of the nearest elements of two lists, each once, with the least distances first.
template <typename Distance>
std::vector<std::pair<std::size_t, std::size_t> > nearest_pairs(const std::size_t m, const std::size_t n, const Distance& distance)
{
  std::vector<std::tuple<double, std::size_t, std::size_t> > all;
  for(std::size_t i = 0; i < m; ++i)
    for(std::size_t j = 0; j < n; ++j)
      if(const double d = distance(i, j); std::isfinite(d))
        all.emplace_back(d, i, j);
  std::sort(all.begin(), all.end());
  std::set<std::size_t> used_first, used_second;
  std::vector<std::pair<std::size_t, std::size_t> > result;
  for(const auto& [d, i, j] : all)
    if(used_first.count(i) == 0 && used_second.count(j) == 0)
    {
      used_first.insert(i);
      used_second.insert(j);
      result.emplace_back(i, j);
    }
  return result;
}

inline std::vector<std::size_t> corners_of(const std::vector<Feature_curve_3>& curves)
{
  std::set<std::size_t> result;
  for(const Feature_curve_3& curve : curves)
    if(!curve.is_closed())
      result.insert({ curve.vertices.front(), curve.vertices.back() });
  return { result.begin(), result.end() };
}

// Returns the points of a target at which vertices of a surface meet its corners and curves. Corners are matched with the nearest
// ones, where the surface has its images, and curves by their ends. Vertices keep their parts of the length of a curve.
inline Goals_3 matched_features_3(const std::vector<Feature_curve_3>& curves, const std::vector<Feature_curve_3>& curves_of_target,
                                  const Numbered_surface_3& target, const std::vector<Vector_3>& images)
{
  constexpr double infinity = std::numeric_limits<double>::infinity(), near = 0.25; // a guess; by the diagonal of the target
  const double bound = near * bounding_box(target.points).diagonal().norm();
  const std::vector<std::size_t> corners = corners_of(curves), corners_of_target = corners_of(curves_of_target);
  std::map<std::size_t, std::size_t> corner_of;
  Goals_3 result;
  for(const auto& [i, j] : nearest_pairs(corners.size(), corners_of_target.size(), [&](const std::size_t i, const std::size_t j)
  {
    const double distance = (images[corners[i]] - target.points[corners_of_target[j]]).norm();
    return distance < bound ? distance : infinity;
  }))
  {
    corner_of[corners[i]] = corners_of_target[j];
    result[static_cast<int>(corners[i])] = target.points[corners_of_target[j]];
  }
  const auto ends_at = [&](const std::size_t v, const std::size_t w)
  {
    const auto found = corner_of.find(v);
    return found != corner_of.end() && found->second == w;
  };
  const auto is_alike = [&](const Feature_curve_3& c, const Feature_curve_3& d)
  { return ends_at(c.vertices.front(), d.vertices.front()) && ends_at(c.vertices.back(), d.vertices.back()); };
  const auto is_reversed = [&](const Feature_curve_3& c, const Feature_curve_3& d)
  { return ends_at(c.vertices.front(), d.vertices.back()) && ends_at(c.vertices.back(), d.vertices.front()); };
  const auto image_at = [&](const Feature_curve_3& c, const double part)
  { return images[c.vertices[(c.vertices.size() - 1) * static_cast<std::size_t>(4 * part) / 4]]; };
  for(const auto& [i, j] : nearest_pairs(curves.size(), curves_of_target.size(), [&](const std::size_t i, const std::size_t j)
  {
    const Feature_curve_3 &c = curves[i], &d = curves_of_target[j];
    if(c.is_closed() != d.is_closed() || (!c.is_closed() && !is_alike(c, d) && !is_reversed(c, d)))
      return infinity;
    double distance = 0;
    for(const double part : { 0.25, 0.5, 0.75 })
      distance += (image_at(c, part) - d.point(d.nearest_part(image_at(c, part)))).norm() / 3;
    return distance < bound ? distance : infinity;
  }))
  {
    const Feature_curve_3 &c = curves[i], &d = curves_of_target[j];
    const double begin = c.is_closed() ? d.nearest_part(image_at(c, 0)) : is_alike(c, d) ? 0 : 1;
    const double quarter = d.nearest_part(image_at(c, 0.25)) - begin;
    const double sign = c.is_closed() ? (quarter - std::floor(quarter) < 0.5 ? 1 : -1) : is_alike(c, d) ? 1 : -1;
    for(std::size_t k = 0; k < c.vertices.size(); ++k)
    {
      const double part = begin + sign * c.parts[k];
      result.emplace(static_cast<int>(c.vertices[k]), d.point(c.is_closed() ? part - std::floor(part) : part));
    }
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MATCHED_FEATURES_3_H
