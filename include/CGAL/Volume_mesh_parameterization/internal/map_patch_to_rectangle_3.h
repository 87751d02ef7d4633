// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PATCH_TO_RECTANGLE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PATCH_TO_RECTANGLE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary_surface_3.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Dense>
#include <Eigen/SparseLU>

#include <cstddef>
#include <iterator>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A border parameterizer for CGAL's Surface_mesh_parameterization: the border keeps the coordinates it has.
class Prescribed_border_parameterizer_3
{
public:
  using Triangle_mesh = Boundary_mesh_3;
  using TriangleMesh = Triangle_mesh;

  template <typename VertexUVMap, typename VertexIndexMap, typename VertexParameterizedMap>
  Surface_mesh_parameterization::Error_code parameterize(const Triangle_mesh& mesh,
                                                         const Triangle_mesh::Halfedge_index border,
                                                         VertexUVMap, VertexIndexMap,
                                                         VertexParameterizedMap is_parameterized) const
  {
    for(const auto v : CGAL::vertices_around_face(border, mesh))
      put(is_parameterized, v, true);
    return Surface_mesh_parameterization::OK;
  }

  bool is_border_convex() const { return true; }
};

// Part of a surface, and the numbers of its vertices in the whole.
struct Surface_patch_3
{
  Boundary_mesh_3 mesh;
  std::vector<int> vertices;
};

inline Surface_patch_3 extract_patch(const Boundary_mesh_3& whole, const std::vector<std::size_t>& patch_of_face,
                                     const std::size_t patch)
{
  Surface_patch_3 result;
  std::unordered_map<int, Boundary_mesh_3::Vertex_index> number;
  for(const auto f : whole.faces())
  {
    if(patch_of_face[f] != patch)
      continue;
    std::vector<Boundary_mesh_3::Vertex_index> face;
    for(const auto v : CGAL::vertices_around_face(whole.halfedge(f), whole))
    {
      const auto inserted = number.emplace(static_cast<int>(v), Boundary_mesh_3::Vertex_index());
      if(inserted.second)
      {
        inserted.first->second = result.mesh.add_vertex(whole.point(v));
        result.vertices.push_back(static_cast<int>(v));
      }
      face.push_back(inserted.first->second);
    }
    result.mesh.add_face(face);
  }
  return result;
}

// Maps the inner vertices of a patch into the convex polygon of its border, by mean value coordinates.
// Uses the axes u and v of the images. Returns whether the linear system was solved.
inline bool map_patch_to_rectangle_3(Surface_patch_3& patch, const int u, const int v,
                                     std::vector<Eigen::Vector3d>& images)
{
  namespace SMP = Surface_mesh_parameterization;
  using Matrix = Eigen_sparse_matrix<double>::EigenType;
  using Solver = Eigen_solver_traits<Eigen::SparseLU<Matrix> >;
  using Point_2 = Exact_predicates_inexact_constructions_kernel::Point_2;

  Boundary_mesh_3& mesh = patch.mesh;
  auto uv_map = mesh.add_property_map<Boundary_mesh_3::Vertex_index, Point_2>("v:uv").first;
  for(const auto w : mesh.vertices())
    uv_map[w] = Point_2(images[patch.vertices[w]][u], images[patch.vertices[w]][v]);

  std::vector<Boundary_mesh_3::Halfedge_index> borders;
  Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  SMP::Mean_value_coordinates_parameterizer_3<Boundary_mesh_3, Prescribed_border_parameterizer_3, Solver> parameterizer;
  if(borders.size() != 1 || SMP::parameterize(mesh, parameterizer, borders[0], uv_map) != SMP::OK)
    return false;
  for(const auto w : mesh.vertices())
    if(!mesh.is_border(w))
    {
      images[patch.vertices[w]][u] = uv_map[w].x();
      images[patch.vertices[w]][v] = uv_map[w].y();
    }
  return true;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PATCH_TO_RECTANGLE_3_H
