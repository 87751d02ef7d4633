// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_SPLIT_EDGES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_SPLIT_EDGES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Unit_surface_3.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <numeric>

namespace CGAL::Polycube_meshing_3::internal {

// Splits edges at their midpoints, the longest one first, and the facets beside them. Returns which facet each one comes from. As
// edges are split one after the other, a tetrahedral mesh can be split in the same way.
inline std::vector<std::size_t> split_edges_3(std::vector<Boundary_mesh_3::Edge_index> edges, Unit_surface_3& surface)
{
  Boundary_mesh_3& mesh = surface.mesh;
  const auto length = [&](const auto e) { return edge_vector(mesh, mesh.halfedge(e)).norm(); };
  std::stable_sort(edges.begin(), edges.end(), [&](const auto e, const auto f) { return length(e) > length(f); });
  std::vector<std::size_t> parents(mesh.number_of_faces());
  std::iota(parents.begin(), parents.end(), std::size_t(0));
  for(const auto e : edges)
  {
    const auto h = mesh.halfedge(e);
    const auto v = mesh.source(h), w = mesh.target(h);
    surface.splits.push_back({ v, w });
    const auto half = CGAL::Euler::split_edge(h, mesh); // from v to the midpoint
    mesh.point(mesh.target(half)) = exact_point((to_vector(mesh.point(v)) + to_vector(mesh.point(w))) / 2);
    surface.is_sharp.push_back(surface.is_sharp[e]);
    for(const auto g : { half, mesh.opposite(h) }) // both end at the midpoint
    {
      parents.push_back(parents[mesh.face(g)]);
      CGAL::Euler::split_face(g, mesh.next(mesh.next(g)), mesh);
      surface.is_sharp.push_back(false);
    }
  }
  return parents;
}

// Splits edges that are longer than is allowed at their midpoints, and their halves, until there are none. No facet is split
// unless its longest edge is, which keeps its angles from becoming ever smaller.
template <typename Length>
void split_long_edges_3(const Length& maximum_length_at, Unit_surface_3& surface)
{
  const Boundary_mesh_3& mesh = surface.mesh;
  while(true)
  {
    std::vector<double> lengths;
    std::vector<Boundary_mesh_3::Edge_index> edges;
    std::vector<bool> is_among(mesh.number_of_edges(), false);
    const auto add = [&](const auto e)
    {
      if(is_among[e])
        return;
      is_among[e] = true;
      edges.push_back(e);
    };
    for(const auto e : mesh.edges())
    {
      const auto h = mesh.halfedge(e);
      const Vector_3 p = to_vector(mesh.point(mesh.source(h))), q = to_vector(mesh.point(mesh.target(h)));
      lengths.push_back((p - q).norm());
      if(lengths.back() > maximum_length_at((p + q) / 2))
        add(e);
    }
    for(std::size_t i = 0; i < edges.size(); ++i) // also those that are added here
      for(const auto h : { mesh.halfedge(edges[i]), mesh.opposite(mesh.halfedge(edges[i])) })
      {
        const std::array<Boundary_mesh_3::Edge_index, 3> around
          = { mesh.edge(h), mesh.edge(mesh.next(h)), mesh.edge(mesh.prev(h)) };
        add(*std::max_element(around.begin(), around.end(), [&](const auto e, const auto f) { return lengths[e] < lengths[f]; }));
      }
    if(edges.empty())
      return;
    split_edges_3(std::move(edges), surface);
  }
}

// Measures of the facets of a surface.
struct Facets_3
{
  std::vector<Vector_3> centers, normals; // unit normals, or 0
  std::vector<double> areas;

  explicit Facets_3(const Boundary_mesh_3& mesh)
  {
    for(const auto f : mesh.faces())
    {
      const Facet_edges_3 X = edges_of_face(mesh, f);
      const Vector_3 n = X[0].cross(X[1]) / 2;
      areas.push_back(n.norm());
      normals.push_back(n.normalized());
      centers.push_back(to_vector(mesh.point(vertices_of_face(mesh, f)[0])) + (X[0] + X[1]) / 3);
    }
  }
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_SPLIT_EDGES_3_H
