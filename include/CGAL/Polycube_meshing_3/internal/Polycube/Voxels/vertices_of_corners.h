// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VERTICES_OF_CORNERS_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VERTICES_OF_CORNERS_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Chains_of_voxel_charts_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Split_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>

#include <limits>
#include <optional>
#include <set>

namespace CGAL::Polycube_meshing_3::internal {

using Volume_mesh_parameterization::internal::vertex_index; // not CGAL's

// Returns the neighbors of a vertex, counterclockwise as seen from outside.
inline std::vector<std::size_t> vertices_around(const Boundary_mesh_3& mesh, const std::size_t v)
{
  std::vector<std::size_t> result;
  for(const auto h : CGAL::halfedges_around_source(vertex_index(v), mesh))
    result.push_back(mesh.target(h));
  std::reverse(result.begin() + 1, result.end()); // CGAL goes clockwise
  return result;
}

// Returns the sums of the normals of facets around the vertices, weighted by area.
inline std::vector<Eigen::Vector3d> normals_of_vertices(const Split_surface_3& surface)
{
  std::vector<Eigen::Vector3d> result(surface.points.size(), Eigen::Vector3d::Zero());
  const Facets_3 facets(surface);
  for(std::size_t f = 0; f < surface.facets.size(); ++f)
    for(const std::size_t v : surface.facets[f])
      result[v] += facets.areas[f] * facets.normals[f];
  return result;
}

// Returns a vertex for each corner of the chains: the nearest one with enough edges, and with two edges at least to any other.
// None if there is no such vertex.
inline std::vector<std::size_t> vertices_of_corners(const Split_surface_3& surface, const Voxel_faces_3& faces,
                                                    const Chains_of_voxel_charts_3& chains)
{
  const Boundary_mesh_3 mesh = surface.mesh();
  const std::vector<Eigen::Vector3d> normals = normals_of_vertices(surface), normals_of_faces = faces.normals_of_points();
  std::vector<bool> is_used(surface.points.size(), false);
  std::vector<std::size_t> result;
  for(const std::size_t corner : chains.corners())
  {
    double least = (std::numeric_limits<double>::infinity)();
    std::size_t best = 0;
    for(const auto v : mesh.vertices())
    {
      const double distance = (surface.points[v] - faces.points[corner]).squaredNorm();
      if(distance >= least || is_used[v] || normals[v].dot(normals_of_faces[corner]) < 0
         || mesh.degree(v) < chains.ends(corner).size())
        continue;
      least = distance;
      best = v;
    }
    if(std::isinf(least))
      return {};
    result.push_back(best);
    for(const std::size_t v : vertices_around(mesh, best))
    {
      is_used[v] = true;
      for(const std::size_t w : vertices_around(mesh, v))
        is_used[w] = true;
    }
  }
  return result;
}

// Splits all edges of the facets at some vertices.
inline void split_around(const std::vector<std::size_t>& vertices, Split_surface_3& surface)
{
  const std::set<std::size_t> at(vertices.begin(), vertices.end());
  std::set<Split_surface_3::Edge> edges;
  for(const std::array<std::size_t, 3>& facet : surface.facets)
    if(std::any_of(facet.begin(), facet.end(), [&](const std::size_t v) { return at.count(v) > 0; }))
      for(std::size_t i = 0; i < 3; ++i)
        edges.insert(Split_surface_3::edge(facet, i));
  surface.split(edges);
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

// Returns for each corner the vertices next to it at which its chains leave, in their order, in directions close to theirs.
// None if there are too few vertices.
inline std::vector<std::vector<std::size_t> > vertices_beside_corners(const Split_surface_3& surface, const Boundary_mesh_3& mesh,
                                                                      const Voxel_faces_3& faces,
                                                                      const Chains_of_voxel_charts_3& chains,
                                                                      const std::vector<std::size_t>& vertices)
{
  const std::vector<Eigen::Vector3d> normals = normals_of_vertices(surface);
  std::vector<std::vector<std::size_t> > result;
  for(std::size_t i = 0; i < vertices.size(); ++i)
  {
    const std::size_t corner = chains.corners()[i], v = vertices[i];
    const Eigen::Vector3d n = normals[v].normalized();
    const auto direction = [&](const Eigen::Vector3d& edge) { return Eigen::Vector3d(edge - edge.dot(n) * n).normalized(); };
    const std::vector<std::size_t> around = vertices_around(mesh, v);
    std::vector<std::vector<double> > costs;
    for(const std::size_t end : chains.ends(corner))
    {
      costs.emplace_back();
      for(const std::size_t w : around)
        costs.back().push_back(1 - direction(faces.points[end] - faces.points[corner])
                                     .dot(direction(surface.points[w] - surface.points[v])));
    }
    result.emplace_back();
    for(const std::size_t k : cyclic_assignment(costs))
      result.back().push_back(around[k]);
    if(result.back().empty())
      return {};
  }
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VERTICES_OF_CORNERS_H
