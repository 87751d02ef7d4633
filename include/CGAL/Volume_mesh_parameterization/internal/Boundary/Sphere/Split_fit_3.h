// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_SPLIT_FIT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_SPLIT_FIT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Surface_relaxation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/split_edge_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/turned_facets_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Surface that is fitted to a target. Its edges are split until both are close to each other. It remains fitted.
class Split_fit_3
{
public:
  // Takes a fitted pair, with the mesh of its surface.
  Split_fit_3(const Surface_pair_3& pair, const Boundary_mesh_3& mesh, const Triangulated_surface_3& triangulated_target)
    : m_fit{ *pair.surface.surface, mesh, pair.surface.directions, pair.images, {}, pair.features }, m_target(pair.target),
      m_goals(pair.goals), m_holds_features(pair.holds_features),
      m_on_target(m_target.surface->points, m_target.surface->facets, m_target.directions),
      m_triangulated_target(triangulated_target)
  {}

  // Splits edges until no midpoint of an edge, and no point of an edge of the target, is farther than the tolerance from the other
  // surface; of edges of the target, points are examined whose distance is the tolerance.
  // Returns whether this succeeds before there are too many vertices, or only edges that cannot be split.
  bool split(const double tolerance, const Budget& budget)
  {
    constexpr std::size_t largest_growth = 20; // a guess
    const std::size_t maximum = largest_growth * (m_fit.surface.points.size() + m_target.surface->points.size());
    examine_edges_of_target(tolerance, maximum);
    while(budget.may_begin_round(Phase::BOUNDARY, "splits of a fitted boundary"))
    {
      const Edges edges = edges_beyond(tolerance);
      if(edges.empty())
        return true;
      if(edges.size() + m_fit.surface.points.size() > maximum || !split_without_spoiling(edges, budget))
        return false;
    }
    return false;
  }

  const std::vector<Vector_3>& images() const { return m_fit.images; }
  const std::vector<std::array<std::size_t, 2> >& splits() const { return m_fit.splits; }

private:
  using Edge_index = Boundary_mesh_3::Edge_index;
  using Edges = std::vector<Edge_index>;

  struct Fit
  {
    Numbered_surface_3 surface;
    Boundary_mesh_3 mesh;
    std::vector<Vector_3> directions, images;
    std::vector<std::array<std::size_t, 2> > splits;
    Matched_features_3 features;
  };

  // Collects the vertices of the target, and points on its edges at most a distance apart, with their directions. The distance is
  // larger if there were far more points than a number.
  void examine_edges_of_target(double distance, const std::size_t number)
  {
    const std::vector<Vector_3>& points = m_target.surface->points;
    std::vector<std::array<std::size_t, 2> > edges;
    double length = 0;
    for(std::size_t v = 0; v < points.size(); ++v)
      m_examined.emplace_back(points[v], m_target.directions[v]);
    for(const auto& [a, b, c] : m_target.surface->facets)
      for(const std::array<std::size_t, 2>& edge : { std::array{ a, b }, { b, c }, { c, a } })
        if(edge[0] < edge[1])
        {
          edges.push_back(edge);
          length += (points[edge[1]] - points[edge[0]]).norm();
        }
    distance = (std::max)(distance, length / static_cast<double>(number));
    for(const auto& [v, w] : edges)
    {
      const auto between = [v = v, w = w](const std::vector<Vector_3>& of_vertices, const double part) -> Vector_3
      { return (1 - part) * of_vertices[v] + part * of_vertices[w]; };
      const double parts = std::ceil((points[w] - points[v]).norm() / distance);
      for(double k = 1; k < parts; ++k)
        m_examined.emplace_back(between(points, k / parts), between(m_target.directions, k / parts).normalized());
    }
  }

  // Returns the edges whose images have midpoints farther than a distance from the target, and the longest edges of the facets
  // that cover examined points of the target this far from the image; also edges that must be split with them. Longer ones come
  // first.
  Edges edges_beyond(const double distance) const
  {
    Numbered_surface_3 image;
    image.points = m_fit.images;
    image.facets = m_fit.surface.facets;
    const Surface_on_sphere_3 on_image(image.points, image.facets, m_fit.directions);
    const auto is_beyond = [&](const Surface_on_sphere_3& surface, const Vector_3& p)
    { return (surface.nearest_position(p).point - p).norm() > distance; };
    std::vector<double> lengths;
    Edges edges;
    for(const Edge_index e : m_fit.mesh.edges())
    {
      const auto v = m_fit.mesh.vertex(e, 0), w = m_fit.mesh.vertex(e, 1);
      lengths.push_back((m_fit.surface.points[v] - m_fit.surface.points[w]).norm());
      const auto at = m_fit.features.edges.find(sorted(std::array<std::size_t, 2>{ v, w }));
      const bool is_on_curve = m_holds_features && at != m_fit.features.edges.end();
      if(is_on_curve ? at->second.curve->farthest_vertex(at->second.first, at->second.last).first > distance
                     : is_beyond(m_on_target, (m_fit.images[v] + m_fit.images[w]) / 2))
        edges.push_back(e);
    }
    for(const auto& [point, direction] : m_examined)
      if(is_beyond(on_image, point))
      {
        const auto [a, b, c] = image.facets[on_image.facet_in_direction(direction)];
        edges.push_back(longest_edge(m_fit.mesh, m_fit.mesh.halfedge(vertex_index(a), vertex_index(b)), lengths));
      }
    edges = with_longest_edges(m_fit.mesh, edges, lengths);
    std::stable_sort(edges.begin(), edges.end(), [&](const auto e, const auto f) { return lengths[e] > lengths[f]; });
    return edges;
  }

  // Splits edges and moves vertices. Leaves out edges whose new vertices have facets that are spoilt. Returns whether there are
  // others.
  bool split_without_spoiling(Edges edges, const Budget& budget)
  {
    const Fit before = m_fit;
    const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(m_fit.images.size());
    while(!edges.empty() && !budget.is_exhausted())
    {
      split(edges);
      std::vector<bool> is_spoilt = are_spoilt(m_fit.images);
      const bool is_fitted = !has_any(is_spoilt.begin(), is_spoilt.end());
      const std::vector<bool> is_spoilt_after = relax(budget);
      if(is_fitted || !has_any(is_spoilt_after.begin(), is_spoilt_after.end()))
        return true;
      if(has_any(is_spoilt_after.begin() + n, is_spoilt_after.end())) // usually fewer
        is_spoilt = is_spoilt_after;
      Edges others;
      for(std::size_t i = 0; i < edges.size(); ++i)
        if(!is_spoilt[static_cast<std::size_t>(n) + i])
          others.push_back(edges[i]);
      edges = others.size() < edges.size() ? others : Edges();
      m_fit = before;
    }
    return false;
  }

  // Puts new vertices on the target, where the sphere has the midpoints of the edges.
  void split(const Edges& edges)
  {
    for(const Edge_index e : edges)
    {
      const auto [v, w] = split_edge_3(m_fit.mesh, e);
      const Surface_position_3 position
        = m_on_target.position_in_direction((m_fit.directions[v] + m_fit.directions[w]).normalized());
      m_fit.features.split({ v, w }, m_fit.images.size());
      m_fit.splits.push_back({ v, w });
      m_fit.surface.points.push_back((m_fit.surface.points[v] + m_fit.surface.points[w]) / 2);
      m_fit.directions.push_back(position.direction);
      m_fit.images.push_back(position.point);
    }
    m_fit.surface.facets.clear();
    for(const auto f : m_fit.mesh.faces())
    {
      const auto [a, b, c] = vertices_of_face(m_fit.mesh, f);
      m_fit.surface.facets.push_back({ a, b, c });
    }
  }

  // Moves all vertices to lower the distortion, unless facets are spoilt. Returns which vertices have such facets.
  std::vector<bool> relax(const Budget& budget)
  {
    const Vertex_rings_3 rings(m_fit.mesh);
    Surface_pair_3 relaxed = { { &m_fit.surface, &rings, m_fit.directions }, m_target };
    relaxed.goals = m_goals;
    relaxed.features = m_fit.features;
    relaxed.holds_features = m_holds_features;
    relaxed.sharpen(budget);
    const std::vector<bool> is_spoilt = are_spoilt(relaxed.images);
    if(!has_any(is_spoilt.begin(), is_spoilt.end()))
    {
      m_fit.images = relaxed.images;
      m_fit.directions = relaxed.surface.directions;
    }
    return is_spoilt;
  }

  // Returns which vertices have a facet that is turned over or intersects others.
  std::vector<bool> are_spoilt(const std::vector<Vector_3>& images)
  {
    set_points(m_fit.mesh, images);
    std::vector<Boundary_mesh_3::Face_index> facets = turned_facets(m_fit.mesh, m_triangulated_target);
    for(const auto& [f, g] : intersecting_facets(m_fit.mesh))
      facets.insert(facets.end(), { f, g });
    std::vector<bool> result(images.size(), false);
    for(const auto f : facets)
      for(const auto v : vertices_of_face(m_fit.mesh, f))
        result[v] = true;
    return result;
  }

  template <typename Iterator>
  static bool has_any(const Iterator begin, const Iterator end) { return std::find(begin, end, true) != end; }

  Fit m_fit;
  Surface_in_sphere_3 m_target;
  Goals_3 m_goals;
  bool m_holds_features;
  Surface_on_sphere_3 m_on_target;
  const Triangulated_surface_3& m_triangulated_target;
  std::vector<std::pair<Vector_3, Vector_3> > m_examined; // points of the target, with their directions
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_SPLIT_FIT_3_H
