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

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Surface_on_sphere_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Polyline_3.h>

#include <map>
#include <set>
#include <tuple>

namespace CGAL::Volume_mesh_parameterization::internal {

// Vertices of a surface, each with the point that it is pulled to.
using Goals_3 = std::map<int, Vector_3>;

// Points along sharp edges, from one corner to another one, or around a closed curve, whose first point is also the last one. The
// length from the first point is the coordinate on the curve. Around a closed curve, it goes on beyond both ends.
struct Feature_curve_3
{
  std::vector<std::size_t> vertices;
  Polyline_3 line;

  bool is_closed() const { return vertices.front() == vertices.back(); }

  // Returns the index of the vertex at the end of the edge at a length.
  std::size_t end_of_edge_at(const double length) const { return line.end_of_edge_at(turned_back(length)); }
  Vector_3 point(const double length) const { return line.point(turned_back(length)); }

  // Returns the largest distance of a vertex between two lengths from the segment that joins their points, and the length at this
  // vertex; the middle without a vertex. A vertex that rounding alone keeps from an end is there.
  std::pair<double, double> farthest_vertex(const double first, const double last) const
  {
    constexpr double rounding = 1e-9;
    const Polyline_3 chord({ point(first), point(last) });
    std::pair<double, double> result(0, (first + last) / 2);
    for(std::size_t i = 0; i < vertices.size(); ++i)
      for(const int turns : { -1, 0, 1 })
      {
        const double length = line.lengths()[i] + turns * line.length(), part = (length - first) / (last - first);
        if((std::min)(part, 1 - part) > rounding)
          result = (std::max)(result, { chord.nearest(line.points()[i]).first, length });
      }
    return result;
  }

  // Returns the length up to the nearest vertex.
  double length_to_vertex_near(const Vector_3& p) const
  {
    const std::vector<Vector_3>& points = line.points();
    const auto nearest = std::min_element(points.begin(), points.end(), [&](const Vector_3& q, const Vector_3& r)
    { return (q - p).squaredNorm() < (r - p).squaredNorm(); });
    return line.lengths()[static_cast<std::size_t>(nearest - points.begin())];
  }

private:
  double turned_back(const double length) const
  { return is_closed() ? length - std::floor(length / line.length()) * line.length() : length; }
};

// Where vertices and edges of a surface meet features of a target.
struct Matched_features_3
{
  struct Part_of_curve { const Feature_curve_3* curve; double first, last; }; // along an edge from its smaller vertex

  Goals_3 points;
  std::map<std::array<std::size_t, 2>, Part_of_curve> edges;
  bool are_complete = false; // whether all curves of both surfaces are matched

  // Puts the largest vertex, by which an edge is split, on the curve of the edge, if any.
  void split(const std::array<std::size_t, 2>& edge, const std::size_t vertex)
  {
    const auto found = edges.find(sorted(edge));
    if(found == edges.end())
      return;
    const auto [ends, part] = *found;
    const double middle = part.curve->farthest_vertex(part.first, part.last).second;
    points[static_cast<int>(vertex)] = part.curve->point(middle);
    edges[{ ends[0], vertex }] = { part.curve, part.first, middle };
    edges[{ ends[1], vertex }] = { part.curve, part.last, middle };
    edges.erase(found);
  }
};

// Vertices of a surface at features of a target, and the regions of the target between these for the other vertices.
class Held_features_3
{
public:
  using Facets = std::vector<std::array<std::size_t, 3> >;

  Held_features_3(const Facets& facets, const Matched_features_3& features, const Facets& facets_of_target,
                  const Surface_on_sphere_3& target)
  {
    for(const auto& [v, point] : features.points)
    {
      m_positions.emplace(v, target.nearest_position(point));
      m_positions.at(v).point = point;
    }
    if(features.edges.empty())
      return;
    Sorted_edges borders, borders_of_target;
    for(const auto& [edge, part] : features.edges)
    {
      borders.push_back(edge);
      const std::vector<std::size_t>& vertices = part.curve->vertices;
      for(std::size_t i = 1; i < vertices.size(); ++i)
        borders_of_target.push_back(sorted(Edge{ vertices[i - 1], vertices[i] }));
    }
    std::sort(borders_of_target.begin(), borders_of_target.end());
    const std::vector<std::size_t> regions = patches_of_facets(facets, borders),
                                   regions_of_target = patches_of_facets(facets_of_target, borders_of_target);
    const auto left = facets_on_left(facets), left_of_target = facets_on_left(facets_of_target);
    std::map<std::size_t, std::set<std::size_t> > partners;
    for(const auto& [edge, part] : features.edges)
    {
      const std::size_t i = part.curve->end_of_edge_at((part.first + part.last) / 2);
      Edge alike = { part.curve->vertices[i - 1], part.curve->vertices[i] };
      if(part.last < part.first)
        std::swap(alike[0], alike[1]);
      for(const std::size_t side : { 0, 1 })
        partners[regions[left.at({ edge[side], edge[1 - side] })]].insert(
          regions_of_target[left_of_target.at({ alike[side], alike[1 - side] })]);
    }
    std::map<std::size_t, Facets> facets_of_regions;
    for(std::size_t f = 0; f < facets_of_target.size(); ++f)
      facets_of_regions[regions_of_target[f]].push_back(facets_of_target[f]);
    for(std::size_t f = 0; f < facets.size(); ++f)
      if(const std::set<std::size_t>& found = partners[regions[f]]; found.size() == 1)
      {
        const std::size_t region = *found.begin();
        const Surface_on_sphere_3& surface = m_regions.try_emplace(region, target, facets_of_regions[region]).first->second;
        for(const std::size_t v : facets[f])
          m_region_of_vertex[static_cast<int>(v)] = &surface;
      }
  }

  // Returns the position at a feature, or null.
  const Surface_position_3* position(const int v) const
  {
    const auto found = m_positions.find(v);
    return found == m_positions.end() ? nullptr : &found->second;
  }

  // Returns the part of the target in which a vertex stays, or null.
  const Surface_on_sphere_3* region(const int v) const
  {
    const auto found = m_region_of_vertex.find(v);
    return found == m_region_of_vertex.end() ? nullptr : found->second;
  }

private:
  using Edge = std::array<std::size_t, 2>;

  std::map<int, Surface_position_3> m_positions;
  std::map<std::size_t, Surface_on_sphere_3> m_regions;
  std::map<int, const Surface_on_sphere_3*> m_region_of_vertex;
};

inline Sorted_edges sharp_edges_by_angle(const Numbered_surface_3& surface)
{ return sharp_edges_3(surface.facets, {}, [&](const std::size_t v) { return surface.points[v]; }); }

// Returns the curves of edges of a surface. They end where other ones begin, and if asked for, also at sharp turns.
inline std::vector<Feature_curve_3> feature_curves_3(const Numbered_surface_3& surface, const Sorted_edges& edges,
                                                     const bool do_end_at_turns)
{
  const auto point = [&](const std::size_t v) { return surface.points[v]; };
  const Neighbors_along_edges neighbors = neighbors_along_edges(edges);
  const std::set<std::size_t> corners = corners_of_curves(neighbors, point, do_end_at_turns);
  std::vector<Feature_curve_3> result;
  for(const std::vector<std::size_t>& vertices : curves_along_edges(neighbors, corners))
  {
    std::vector<Vector_3> points;
    for(const std::size_t v : vertices)
      points.push_back(surface.points[v]);
    result.push_back({ vertices, Polyline_3(points) });
  }
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
// ones, where the surface has its images, and curves by their ends. Vertices keep their parts of the length of a curve. If fewer
// than half of the curves are matched, these are alike by chance, as folds of coarse surfaces are, and nothing is met.
inline Matched_features_3 matched_features_3(const std::vector<Feature_curve_3>& curves,
                                             const std::vector<Feature_curve_3>& curves_of_target,
                                             const Numbered_surface_3& target, const std::vector<Vector_3>& images)
{
  constexpr double infinity = std::numeric_limits<double>::infinity(), near = 0.25; // a guess; by the diagonal of the target
  const double bound = near * bounding_box(target.points).diagonal().norm();
  const std::vector<std::size_t> corners = corners_of(curves), corners_of_target = corners_of(curves_of_target);
  std::map<std::size_t, std::size_t> corner_of;
  Matched_features_3 result;
  for(const auto& [i, j] : nearest_pairs(corners.size(), corners_of_target.size(), [&](const std::size_t i, const std::size_t j)
  {
    const double distance = (images[corners[i]] - target.points[corners_of_target[j]]).norm();
    return distance < bound ? distance : infinity;
  }))
  {
    corner_of[corners[i]] = corners_of_target[j];
    result.points[static_cast<int>(corners[i])] = target.points[corners_of_target[j]];
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
  const auto pairs_of_curves = nearest_pairs(curves.size(), curves_of_target.size(), [&](const std::size_t i, const std::size_t j)
  {
    const Feature_curve_3 &c = curves[i], &d = curves_of_target[j];
    if(c.is_closed() != d.is_closed() || (!c.is_closed() && !is_alike(c, d) && !is_reversed(c, d)))
      return infinity;
    double distance = 0;
    for(const double part : { 0.25, 0.5, 0.75 })
      distance += d.line.nearest(image_at(c, part)).first / 3;
    return distance < bound ? distance : infinity;
  });
  const std::size_t number_of_curves = (std::max)(curves.size(), curves_of_target.size());
  if(2 * pairs_of_curves.size() < number_of_curves)
    return {};
  result.are_complete = pairs_of_curves.size() == number_of_curves;
  for(const auto& [i, j] : pairs_of_curves)
  {
    const Feature_curve_3 &c = curves[i], &d = curves_of_target[j];
    const double length = d.line.length();
    const auto nearest = [&](const double part) { return d.length_to_vertex_near(image_at(c, part)); };
    const double begin = c.is_closed() ? nearest(0) : is_alike(c, d) ? 0 : length;
    const bool is_forward = c.is_closed() ? std::fmod(nearest(0.25) - begin + length, length) < length / 2 : is_alike(c, d);
    const auto part = [&](const std::size_t k)
    { return begin + (is_forward ? 1 : -1) * c.line.lengths()[k] / c.line.length() * length; };
    for(std::size_t k = 0; k < c.vertices.size(); ++k)
      result.points.emplace(static_cast<int>(c.vertices[k]), d.point(part(k)));
    for(std::size_t k = 1; k < c.vertices.size(); ++k)
      if(const std::size_t v = c.vertices[k - 1], w = c.vertices[k]; v < w)
        result.edges[{ v, w }] = { &d, part(k - 1), part(k) };
      else
        result.edges[{ w, v }] = { &d, part(k), part(k - 1) };
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MATCHED_FEATURES_3_H
