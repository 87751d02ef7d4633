// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_CHAINS_OF_VOXEL_CHARTS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_CHAINS_OF_VOXEL_CHARTS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/split_edges_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Voxel_faces_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

namespace CGAL::Polycube_meshing_3::internal {

// Chain between two charts of placed faces of voxels, from corner to corner.
struct Chain_of_voxel_charts_3
{
  std::vector<std::size_t> points;          // of the faces
  std::size_t left, right;                  // charts
  std::size_t first_index, last_index;      // which of the chains at its corners it is, counterclockwise
};

// Borders of charts of placed faces of voxels, and the corners where three or more of them meet.
class Chains_of_voxel_charts_3
{
public:
  Chains_of_voxel_charts_3(const Voxel_faces_3& faces, const std::vector<std::size_t>& chart_of_face)
    : m_faces(faces), m_chart_of_face(chart_of_face), m_ends(faces.points.size())
  {
    for(std::size_t i = 0; i < faces.corners.size(); ++i)
      for(std::size_t k = 0; k < 4; ++k)
        m_side[{ faces.corners[i][k], faces.corners[i][(k + 1) % 4] }] = { i, k };
    find_ends();
    for(std::size_t p = 0; p < m_ends.size(); ++p)
      if(m_ends[p].size() > 2)
      {
        m_corners.push_back(p);
        for(std::size_t i = 0; i < m_ends[p].size(); ++i)
          add_chain(p, i);
      }
  }

  const std::vector<std::size_t>& corners() const { return m_corners; }
  const std::vector<Chain_of_voxel_charts_3>& chains() const { return m_chains; }

  // Returns the points next to a corner on the chains that leave it, counterclockwise.
  const std::vector<std::size_t>& ends(const std::size_t corner) const { return m_ends[corner]; }

  double length(const Chain_of_voxel_charts_3& chain) const
  {
    double result = 0;
    for(std::size_t i = 1; i < chain.points.size(); ++i)
      result += (m_faces.points[chain.points[i]] - m_faces.points[chain.points[i - 1]]).norm();
    return result;
  }

private:
  std::size_t chart_on_left(const std::size_t v, const std::size_t w) const { return m_chart_of_face[m_side.at({ v, w }).first]; }

  void find_ends()
  {
    std::vector<bool> is_done(m_ends.size(), false);
    for(const auto& entry : m_side)
    {
      const auto [p, first] = entry.first;
      if(is_done[p])
        continue;
      is_done[p] = true;
      std::size_t v = first;
      do
      {
        if(chart_on_left(p, v) != chart_on_left(v, p))
          m_ends[p].push_back(v);
        const auto [face, k] = m_side.at({ p, v });
        v = m_faces.corners[face][(k + 3) % 4]; // the next one counterclockwise
      }
      while(v != first);
    }
  }

  std::size_t index_of_end(const std::size_t p, const std::size_t end) const
  { return static_cast<std::size_t>(std::find(m_ends[p].begin(), m_ends[p].end(), end) - m_ends[p].begin()); }

  // Follows a chain to its other corner, and adds it in one of its two directions.
  void add_chain(const std::size_t corner, const std::size_t index_at_corner)
  {
    Chain_of_voxel_charts_3 chain;
    chain.points = { corner, m_ends[corner][index_at_corner] };
    while(m_ends[chain.points.back()].size() == 2)
    {
      const std::vector<std::size_t>& ends = m_ends[chain.points.back()];
      chain.points.push_back(ends[0] == chain.points[chain.points.size() - 2] ? ends[1] : ends[0]);
    }
    chain.first_index = index_at_corner;
    chain.last_index = index_of_end(chain.points.back(), chain.points[chain.points.size() - 2]);
    chain.left = chart_on_left(chain.points[0], chain.points[1]);
    chain.right = chart_on_left(chain.points[1], chain.points[0]);
    if(std::make_pair(corner, chain.first_index) < std::make_pair(chain.points.back(), chain.last_index))
      m_chains.push_back(chain);
  }

  const Voxel_faces_3& m_faces;
  const std::vector<std::size_t>& m_chart_of_face;
  std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, std::size_t> > m_side; // face, corner of an edge
  std::vector<std::vector<std::size_t> > m_ends;
  std::vector<std::size_t> m_corners;
  std::vector<Chain_of_voxel_charts_3> m_chains;
};

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
inline std::vector<Vector_3> normals_of_vertices(const Boundary_mesh_3& mesh)
{
  std::vector<Vector_3> result(mesh.number_of_vertices(), Vector_3::Zero());
  const Facets_3 facets(mesh);
  for(const auto f : mesh.faces())
    for(const auto v : vertices_of_face(mesh, f))
      result[v] += facets.areas[f] * facets.normals[f];
  return result;
}

// Returns a vertex for each corner of the chains: the nearest one with enough edges, and with two edges at least to any other.
// None if there is no such vertex.
inline std::vector<std::size_t> vertices_of_corners(const Boundary_mesh_3& mesh, const Voxel_faces_3& faces,
                                                    const Chains_of_voxel_charts_3& chains)
{
  const std::vector<Vector_3> points = points_of(mesh), normals = normals_of_vertices(mesh),
                              normals_of_faces = faces.normals_of_points();
  std::vector<bool> is_used(points.size(), false);
  std::vector<std::size_t> result;
  for(const std::size_t corner : chains.corners())
  {
    double least = (std::numeric_limits<double>::infinity)();
    std::size_t best = 0;
    for(const auto v : mesh.vertices())
    {
      const double distance = (points[v] - faces.points[corner]).squaredNorm();
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
inline void split_around(const std::vector<std::size_t>& vertices, Unit_surface_3& surface)
{
  const Boundary_mesh_3& mesh = surface.mesh;
  std::set<Boundary_mesh_3::Edge_index> edges;
  for(const std::size_t v : vertices)
    for(const auto h : CGAL::halfedges_around_source(vertex_index(v), mesh))
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

// Returns for each corner the vertices next to it at which its chains leave, in their order, in directions close to theirs.
// None if there are too few vertices.
inline std::vector<std::vector<std::size_t> > vertices_beside_corners(const Boundary_mesh_3& mesh, const Voxel_faces_3& faces,
                                                                      const Chains_of_voxel_charts_3& chains,
                                                                      const std::vector<std::size_t>& vertices)
{
  const std::vector<Vector_3> points = points_of(mesh), normals = normals_of_vertices(mesh);
  std::vector<std::vector<std::size_t> > result;
  for(std::size_t i = 0; i < vertices.size(); ++i)
  {
    const std::size_t corner = chains.corners()[i], v = vertices[i];
    const Vector_3 n = normals[v].normalized();
    const auto direction = [&](const Vector_3& edge) { return Vector_3(edge - edge.dot(n) * n).normalized(); };
    const std::vector<std::size_t> around = vertices_around(mesh, v);
    std::vector<std::vector<double> > costs;
    for(const std::size_t end : chains.ends(corner))
    {
      costs.emplace_back();
      for(const std::size_t w : around)
        costs.back().push_back(1 - direction(faces.points[end] - faces.points[corner]).dot(direction(points[w] - points[v])));
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

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_CHAINS_OF_VOXEL_CHARTS_3_H
