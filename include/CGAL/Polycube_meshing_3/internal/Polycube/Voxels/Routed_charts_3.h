// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_ROUTED_CHARTS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_ROUTED_CHARTS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/vertices_of_corners_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Shortest_paths.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <numeric>
#include <unordered_map>

namespace CGAL::Polycube_meshing_3::internal {

// Finds charts on a surface that are connected like those of placed faces of voxels: their chains become paths that share no
// vertices but corners, and leave these in the right order.
class Routed_charts_3
{
public:
  // Takes the faces of voxels on the surface, their charts, and the size of voxels. Facets at corners are split.
  Routed_charts_3(Unit_surface_3& surface, const Voxel_faces_3& faces, const Polycube_charts_3& charts, const double spacing)
    : m_surface(surface), m_mesh(surface.mesh), m_faces(faces), m_charts(charts), m_spacing(spacing),
      m_paths(charts.chains().size())
  {}

  // Returns the chart of each facet; none if a path is blocked.
  std::vector<std::size_t> run(const Budget& budget)
  {
    constexpr int layers_around_corners = 2; // give room to the paths that leave them
    constexpr int maximum_number_of_attempts = 40; // a guess
    m_corners = vertices_of_corners_3(m_mesh, m_faces, m_charts);
    for(int i = 0; i < layers_around_corners; ++i)
      split_around(m_corners, m_surface);
    m_first_halfedges = first_halfedges_of_chains_3(m_mesh, m_faces.mesh, m_charts, m_corners);
    if(m_first_halfedges.empty())
      return {};

    std::vector<std::size_t> order(m_paths.size()); // shorter ones first
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto length = [&](const std::size_t i) { return arc_lengths(m_faces.mesh, chain(i)).back(); };
    std::stable_sort(order.begin(), order.end(),
                     [&](const std::size_t i, const std::size_t j) { return length(i) < length(j); });
    for(int attempt = 0; attempt < maximum_number_of_attempts && !budget.is_exhausted(); ++attempt)
    {
      const auto blocked = route(order);
      if(blocked == order.end())
        return charts_between_paths();
      std::rotate(order.begin(), blocked, blocked + 1); // it comes first
    }
    return {};
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Returns the vertices of a chain on the faces of voxels.
  std::vector<Polycube_charts_3::Vertex> chain(const std::size_t i) const { return m_charts.vertices(m_charts.chains()[i]); }

  // Routes the chains one after the other. Returns the first one that is blocked.
  std::vector<std::size_t>::iterator route(std::vector<std::size_t>& order)
  {
    m_is_used.assign(m_mesh.number_of_vertices(), false);
    for(const auto& [corner, v] : m_corners)
      m_is_used[v] = true;
    for(const auto& [first, h] : m_first_halfedges) // belongs to one chain
      m_is_used[m_mesh.target(h)] = true;
    return std::find_if_not(order.begin(), order.end(), [&](const std::size_t i) { return route(i); });
  }

  bool route(const std::size_t i)
  {
    const auto& halfedges = m_charts.chains()[i].halfedges;
    const auto first = m_first_halfedges.at(halfedges.front()),
               last = m_first_halfedges.at(m_faces.mesh.opposite(halfedges.back()));
    std::vector<std::size_t> path = shortest_path(m_mesh.target(first), m_mesh.target(last), chain(i));
    if(path.empty())
      return false;
    for(const std::size_t v : path)
      m_is_used[v] = true;
    path.insert(path.begin(), m_mesh.source(first));
    path.push_back(m_mesh.source(last));
    m_paths[i] = std::move(path);
    return true;
  }

  // Returns how much longer a path is at a vertex that is off the chain of the faces.
  double factor(const Vector_3& p, const std::vector<Polycube_charts_3::Vertex>& chain) const
  {
    constexpr double weight = 20; // a guess
    double least = (std::numeric_limits<double>::infinity)();
    for(std::size_t i = 1; i < chain.size(); ++i)
    {
      const Vector_3 a = m_faces.point(chain[i - 1]), edge = m_faces.point(chain[i]) - a;
      const double t = edge.squaredNorm() > 0 ? (std::min)((std::max)((p - a).dot(edge) / edge.squaredNorm(), 0.), 1.) : 0;
      least = (std::min)(least, (a + t * edge - p).squaredNorm());
    }
    return 1 + weight * least / (m_spacing * m_spacing);
  }

  // Returns the vertices of a path around those in use; none if there is none.
  std::vector<std::size_t> shortest_path(const std::size_t from, const std::size_t to,
                                         const std::vector<Polycube_charts_3::Vertex>& chain) const
  {
    const auto for_each_edge = [&](const std::size_t v, const auto& reach)
    {
      for(const auto h : CGAL::halfedges_around_source(vertex_index(v), m_mesh))
        if(const std::size_t w = m_mesh.target(h); !m_is_used[w] || w == to)
          reach(w, edge_vector(m_mesh, h).norm() * factor(to_vector(m_mesh.point(m_mesh.target(h))), chain));
    };
    return Shortest_paths(m_mesh.number_of_vertices(), std::array<std::size_t, 1>{ from }, for_each_edge,
                          [&](const std::size_t v) { return v == to; }).path_to(to);
  }

  // Returns the charts of the facets between the paths; none if one has no part or several.
  std::vector<std::size_t> charts_between_paths() const
  {
    std::vector<std::size_t> chart_of_halfedge(m_mesh.number_of_halfedges(), none);
    for(std::size_t i = 0; i < m_paths.size(); ++i)
      for(std::size_t k = 1; k < m_paths[i].size(); ++k)
      {
        const auto h = m_mesh.halfedge(vertex_index(m_paths[i][k - 1]), vertex_index(m_paths[i][k]));
        chart_of_halfedge[h] = m_charts.chains()[i].charts[0];
        chart_of_halfedge[m_mesh.opposite(h)] = m_charts.chains()[i].charts[1];
      }
    Disjoint_sets sets(m_mesh.number_of_faces());
    for(const auto h : m_mesh.halfedges())
      if(chart_of_halfedge[h] == none)
        sets.unite(m_mesh.face(h), m_mesh.face(m_mesh.opposite(h)));
    std::unordered_map<std::size_t, std::size_t> chart_of_part, part_of_chart;
    for(const auto h : m_mesh.halfedges())
      if(const std::size_t chart = chart_of_halfedge[h]; chart != none)
      {
        const std::size_t part = sets.find(m_mesh.face(h));
        if(chart_of_part.emplace(part, chart).first->second != chart || part_of_chart.emplace(chart, part).first->second != part)
          return {};
      }
    std::vector<std::size_t> result;
    for(std::size_t f = 0; f < m_mesh.number_of_faces(); ++f)
      if(const auto it = chart_of_part.find(sets.find(f)); it != chart_of_part.end())
        result.push_back(it->second);
    if(result.size() != m_mesh.number_of_faces() || part_of_chart.size() != m_charts.number_of_charts())
      return {};
    return result;
  }

  Unit_surface_3& m_surface;
  const Boundary_mesh_3& m_mesh; // of the surface
  const Voxel_faces_3& m_faces;
  const Polycube_charts_3& m_charts; // of the faces
  const double m_spacing;
  std::vector<std::vector<std::size_t> > m_paths; // vertices, of each chain
  Vertices_of_corners_3 m_corners;
  std::map<Boundary_mesh_3::Halfedge_index, Boundary_mesh_3::Halfedge_index> m_first_halfedges;
  std::vector<bool> m_is_used;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_ROUTED_CHARTS_3_H
