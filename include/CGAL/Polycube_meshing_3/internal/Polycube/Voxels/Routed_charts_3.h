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

#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_charts_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Voxel_faces_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Unit_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Shortest_paths.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Polyline_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

namespace CGAL::Polycube_meshing_3::internal {

// Returns for each vertex the sum of the area vectors of the facets around it: a normal, but not of unit length.
inline std::vector<Vector_3> area_vectors_of_vertices(const Boundary_mesh_3& mesh)
{
  std::vector<Vector_3> result(mesh.number_of_vertices(), Vector_3::Zero());
  const Facets_3 facets(mesh);
  for(const auto f : mesh.faces())
    for(const auto v : vertices_of_face(mesh, f))
      result[v] += facets.areas[f] * facets.normals[f];
  return result;
}

// Vertices of a surface, by the corners of charts of placed faces of voxels.
using Vertices_of_corners_3 = std::map<Polycube_charts_3::Vertex, Polycube_charts_3::Vertex>;

// Returns the halfedges between two charts that leave a corner, in their order around the corner.
inline std::vector<Boundary_mesh_3::Halfedge_index>
chains_from_corner(const Boundary_mesh_3& faces, const Polycube_charts_3& charts, const Polycube_charts_3::Vertex corner)
{
  std::vector<Boundary_mesh_3::Halfedge_index> result;
  for(const auto h : CGAL::halfedges_around_source(corner, faces))
    if(charts.separates(h))
      result.push_back(h);
  return result;
}

// Returns a vertex for each corner: the nearest one that has an edge for each chain and is at least three edges away from the
// vertices of other corners. Returns none if a corner has no such vertex.
inline Vertices_of_corners_3 vertices_of_corners_3(const Boundary_mesh_3& mesh, const Voxel_faces_3& faces,
                                                   const Polycube_charts_3& charts)
{
  const std::vector<Vector_3> points = points_of(mesh), normals = area_vectors_of_vertices(mesh),
                              normals_of_faces = faces.normals_of_vertices();
  std::vector<bool> is_used(points.size(), false);
  Vertices_of_corners_3 result;
  for(const auto corner : charts.corners())
  {
    const std::size_t number_of_chains = chains_from_corner(faces.mesh, charts, corner).size();
    double least = (std::numeric_limits<double>::infinity)();
    for(const auto v : mesh.vertices())
    {
      const double distance = (points[v] - faces.point(corner)).squaredNorm();
      if(distance >= least || is_used[v] || normals[v].dot(normals_of_faces[corner]) < 0 || mesh.degree(v) < number_of_chains)
        continue;
      least = distance;
      result[corner] = v;
    }
    if(std::isinf(least))
      return {};
    for(const auto v : CGAL::vertices_around_target(mesh.halfedge(result[corner]), mesh))
      for(const auto h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh))
        is_used[v] = is_used[mesh.source(h)] = true;
  }
  return result;
}

// Splits all edges of the facets around the vertices of corners.
inline void split_around(const Vertices_of_corners_3& vertices, Unit_surface_3& surface)
{
  const Boundary_mesh_3& mesh = surface.mesh;
  std::set<Boundary_mesh_3::Edge_index> edges;
  for(const auto& [corner, v] : vertices)
    for(const auto h : CGAL::halfedges_around_source(v, mesh))
      edges.insert({ mesh.edge(h), mesh.edge(mesh.next(h)) });
  split_edges_3({ edges.begin(), edges.end() }, surface);
}

// Returns a column for each row of costs, such that the sum is least and the columns follow each other cyclically as the rows do.
// Returns none if there are fewer columns than rows. Needs a row. Uses dynamic programming for each column of the first row.
inline std::vector<std::size_t> cyclic_assignment(const std::vector<std::vector<double> >& costs)
{
  constexpr double infinity = (std::numeric_limits<double>::infinity)();
  const std::size_t rows = costs.size(), columns = costs.front().size();
  std::vector<std::size_t> result;
  double least = infinity;
  for(std::size_t shift = 0; shift < columns; ++shift) // the column of the first row
  {
    // Least sums of the rows up to j if row j has the column shift + i, and the place of the column of row j - 1 then.
    std::vector<std::vector<double> > sums(rows, std::vector<double>(columns, infinity));
    std::vector<std::vector<std::size_t> > previous(rows, std::vector<std::size_t>(columns, 0));
    sums[0][0] = costs[0][shift];
    for(std::size_t j = 1; j < rows; ++j)
      for(std::size_t i = j; i < columns; ++i)
        for(std::size_t l = j - 1; l < i; ++l)
          if(const double sum = sums[j - 1][l] + costs[j][(shift + i) % columns]; sum < sums[j][i])
          {
            sums[j][i] = sum;
            previous[j][i] = l;
          }
    for(std::size_t i = 0; i < columns; ++i)
      if(sums[rows - 1][i] < least)
      {
        least = sums[rows - 1][i];
        result.assign(rows, 0);
        for(std::size_t j = rows, l = i; j-- > 0; l = previous[j][l])
          result[j] = (shift + l) % columns;
      }
  }
  return result;
}

// Returns for each halfedge of faces of voxels with which a chain leaves a corner a halfedge of the surface that leaves the vertex
// of the corner. The directions are close, and their orders around the corner are the same. Returns none if there are too few.
inline std::map<Boundary_mesh_3::Halfedge_index, Boundary_mesh_3::Halfedge_index>
first_halfedges_of_chains_3(const Boundary_mesh_3& mesh, const Boundary_mesh_3& faces, const Polycube_charts_3& charts,
                            const Vertices_of_corners_3& vertices)
{
  const std::vector<Vector_3> normals = area_vectors_of_vertices(mesh);
  std::map<Boundary_mesh_3::Halfedge_index, Boundary_mesh_3::Halfedge_index> result;
  for(const auto& [corner, v] : vertices)
  {
    const Vector_3 n = normals[v].normalized();
    const auto direction = [&](const Vector_3& edge) { return Vector_3(edge - edge.dot(n) * n).normalized(); };
    const auto around = CGAL::halfedges_around_source(v, mesh);
    const std::vector<Boundary_mesh_3::Halfedge_index> leaving(around.begin(), around.end());
    const std::vector<Boundary_mesh_3::Halfedge_index> chains = chains_from_corner(faces, charts, corner);
    std::vector<std::vector<double> > costs;
    for(const auto h : chains)
    {
      costs.emplace_back();
      for(const auto k : leaving)
        costs.back().push_back(1 - direction(edge_vector(faces, h)).dot(direction(edge_vector(mesh, k))));
    }
    const std::vector<std::size_t> chosen = cyclic_assignment(costs);
    if(chosen.empty())
      return {};
    for(std::size_t i = 0; i < chains.size(); ++i)
      result[chains[i]] = leaving[chosen[i]];
  }
  return result;
}

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
    std::stable_sort(order.begin(), order.end(),
                     [&](const std::size_t i, const std::size_t j) { return chain(i).length() < chain(j).length(); });
    for(int attempt = 0; attempt < maximum_number_of_attempts && !budget.is_exhausted(); ++attempt)
    {
      const auto blocked = route(order);
      if(blocked == order.end())
        return charts_between_paths();
      m_blocked_chains.insert(*blocked);
      std::rotate(order.begin(), blocked, blocked + 1); // the blocked chain comes first
    }
    return {};
  }

  // Returns the chains that others have blocked in some attempt.
  const std::set<std::size_t>& blocked_chains() const { return m_blocked_chains; }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Returns a chain on the faces of voxels.
  Polyline_3 chain(const std::size_t i) const
  {
    std::vector<Vector_3> points;
    for(const auto v : m_charts.vertices(m_charts.chains()[i]))
      points.push_back(m_faces.point(v));
    return Polyline_3(std::move(points));
  }

  // Routes the chains one after the other. Returns the place in the order of the first one that is blocked, or its end.
  std::vector<std::size_t>::iterator route(std::vector<std::size_t>& order)
  {
    m_is_used.assign(m_mesh.number_of_vertices(), false);
    for(const auto& [corner, v] : m_corners)
      m_is_used[v] = true;
    for(const auto& [first, h] : m_first_halfedges) // no path of another chain may pass
      m_is_used[m_mesh.target(h)] = true;
    return std::find_if_not(order.begin(), order.end(), [&](const std::size_t i) { return route_chain(i); });
  }

  // Finds the path of a chain, and returns whether there is one.
  bool route_chain(const std::size_t i)
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

  // Returns the vertices of the shortest path that avoids vertices in use; none if these block all paths. The weights of edges
  // grow with the distances from the chain on the faces of voxels.
  std::vector<std::size_t> shortest_path(const std::size_t from, const std::size_t to, const Polyline_3& chain) const
  {
    constexpr double weight = 20; // a guess
    const auto factor = [&](const Vector_3& p) { return 1 + weight * std::pow(chain.nearest(p).first / m_spacing, 2); };
    const auto for_each_edge = [&](const std::size_t v, const auto& reach)
    {
      for(const auto h : CGAL::halfedges_around_source(vertex_index(v), m_mesh))
        if(const std::size_t w = m_mesh.target(h); !m_is_used[w] || w == to)
          reach(w, edge_vector(m_mesh, h).norm() * factor(to_vector(m_mesh.point(m_mesh.target(h)))));
    };
    return Shortest_paths(m_mesh.number_of_vertices(), std::array<std::size_t, 1>{ from }, for_each_edge,
                          [&](const std::size_t v) { return v == to; }).path_to(to);
  }

  // Returns the charts of the facets between the paths; none if a chart would be empty, or not connected.
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
  std::vector<std::vector<std::size_t> > m_paths; // vertices of the surface, for each chain
  Vertices_of_corners_3 m_corners;
  std::map<Boundary_mesh_3::Halfedge_index, Boundary_mesh_3::Halfedge_index> m_first_halfedges;
  std::set<std::size_t> m_blocked_chains;
  std::vector<bool> m_is_used; // by vertex: on a path, or where paths begin and end
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_ROUTED_CHARTS_3_H
