// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VERTICES_OF_CORNERS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VERTICES_OF_CORNERS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_charts_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/split_edges_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Voxel_faces_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace CGAL::Polycube_meshing_3::internal {

using Volume_mesh_parameterization::internal::vertex_index; // not CGAL's

// Returns the sums of the normals of facets around the vertices, weighted by area.
inline std::vector<Vector_3> normals_of_vertices(const Boundary_mesh_3& mesh)
{
  std::vector<Vector_3> result(mesh.number_of_vertices(), Vector_3::Zero());
  const Facets_3 facets(mesh);
  for(const auto f : mesh.faces())
    for(const auto v : vertices_of_face(mesh, f))
      result[v] += facets.areas[f] * facets.normals[f];
  return result;
}

// Vertices of a surface, by corners of charts of placed faces of voxels.
using Vertices_of_corners_3 = std::map<Polycube_charts_3::Vertex, Polycube_charts_3::Vertex>;

// Returns the halfedges that leave a corner between two charts, in their order around it.
inline std::vector<Boundary_mesh_3::Halfedge_index>
chains_from_corner(const Boundary_mesh_3& faces, const Polycube_charts_3& charts, const Polycube_charts_3::Vertex corner)
{
  std::vector<Boundary_mesh_3::Halfedge_index> result;
  for(const auto h : CGAL::halfedges_around_source(corner, faces))
    if(charts.chart(h) != charts.chart(faces.opposite(h)))
      result.push_back(h);
  return result;
}

// Finds a vertex for each corner: the nearest one with enough edges, and with two edges at least to any other. None if there is
// no such vertex.
inline Vertices_of_corners_3 vertices_of_corners_3(const Boundary_mesh_3& mesh, const Voxel_faces_3& faces,
                                                   const Polycube_charts_3& charts)
{
  const std::vector<Vector_3> points = points_of(mesh), normals = normals_of_vertices(mesh),
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

// Splits all edges of the facets at the vertices of corners.
inline void split_around(const Vertices_of_corners_3& vertices, Unit_surface_3& surface)
{
  const Boundary_mesh_3& mesh = surface.mesh;
  std::set<Boundary_mesh_3::Edge_index> edges;
  for(const auto& [corner, v] : vertices)
    for(const auto h : CGAL::halfedges_around_source(v, mesh))
      edges.insert({ mesh.edge(h), mesh.edge(mesh.next(h)) });
  split_edges_3({ edges.begin(), edges.end() }, surface);
}

// Chooses for each row of costs a column, in an order that is cyclic for both, such that the sum is least. Nothing if there are
// fewer columns.
inline std::vector<std::size_t> cyclic_assignment(const std::vector<std::vector<double> >& costs)
{
  constexpr double infinity = (std::numeric_limits<double>::infinity)();
  const std::size_t rows = costs.size(), columns = costs.front().size();
  std::vector<std::size_t> result;
  double least = infinity;
  for(std::size_t shift = 0; shift < columns; ++shift) // the column of the first row
  {
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

// Chooses for each halfedge with which a chain leaves a corner one that leaves the vertex of the corner, in a direction close to
// it. Both have the same order around. None if there are too few.
inline std::map<Boundary_mesh_3::Halfedge_index, Boundary_mesh_3::Halfedge_index>
first_halfedges_of_chains_3(const Boundary_mesh_3& mesh, const Boundary_mesh_3& faces, const Polycube_charts_3& charts,
                            const Vertices_of_corners_3& vertices)
{
  const std::vector<Vector_3> normals = normals_of_vertices(mesh);
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

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VERTICES_OF_CORNERS_3_H
