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
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/split_edge_3.h>

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
    for(const auto h : { mesh.halfedge(e), mesh.opposite(mesh.halfedge(e)) })
      parents.push_back(parents[mesh.face(h)]);
    surface.is_sharp.push_back(surface.is_sharp[e]);
    surface.is_sharp.insert(surface.is_sharp.end(), 2, false); // edges that divide the facets
    surface.splits.push_back(split_edge_3(mesh, e));
  }
  return parents;
}

// Splits edges that are longer than is allowed at their midpoints, and their halves, until there are none.
template <typename Length>
void split_long_edges_3(const Length& maximum_length_at, Unit_surface_3& surface)
{
  const Boundary_mesh_3& mesh = surface.mesh;
  while(true)
  {
    std::vector<double> lengths;
    std::vector<Boundary_mesh_3::Edge_index> edges;
    for(const auto e : mesh.edges())
    {
      const auto h = mesh.halfedge(e);
      const Vector_3 p = to_vector(mesh.point(mesh.source(h))), q = to_vector(mesh.point(mesh.target(h)));
      lengths.push_back((p - q).norm());
      if(lengths.back() > maximum_length_at((p + q) / 2))
        edges.push_back(e);
    }
    if(edges.empty())
      return;
    split_edges_3(with_longest_edges(mesh, edges, lengths), surface);
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
