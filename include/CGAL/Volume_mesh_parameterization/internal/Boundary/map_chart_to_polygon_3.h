// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_MAP_CHART_TO_POLYGON_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_MAP_CHART_TO_POLYGON_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/sparse_systems.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/centroid.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>

namespace CGAL::Volume_mesh_parameterization::internal {

// Border parameterizer for CGAL's Surface_mesh_parameterization that keeps the coordinates of the border.
class Prescribed_border_parameterizer_3
{
public:
  using Triangle_mesh = Boundary_mesh_3;
  using TriangleMesh = Triangle_mesh;

  template <typename VertexUVMap, typename VertexIndexMap, typename VertexParameterizedMap>
  Surface_mesh_parameterization::Error_code parameterize(const Triangle_mesh& mesh,
                                                         const Triangle_mesh::Halfedge_index border, VertexUVMap,
                                                         VertexIndexMap, VertexParameterizedMap is_parameterized) const
  {
    for(const auto v : CGAL::vertices_around_face(border, mesh))
      put(is_parameterized, v, true);
    return Surface_mesh_parameterization::OK;
  }

  bool is_border_convex() const { return true; }
};

// Solves the linear systems of that package.
struct Sparse_elimination_traits
{
  using NT = double;
  using Vector = std::vector<double>;

  struct Matrix
  {
    std::vector<Sparse_entry> entries;

    Matrix(int, int) {}
    void set_coef(const int i, const int j, const double x, bool) { entries.push_back({ i, j, x }); }
  };

  static bool linear_solver(const Matrix& A, const Vector& b, Vector& x, double& denominator)
  {
    denominator = 1;
    return solve_by_elimination(A.entries, b, x);
  }
};

// Spaces the images of the vertices of a path between those of its ends, along an axis, by their distances.
template <typename Path>
void map_path_to_segment_3(const Boundary_mesh_3& mesh, const Path& path, const int axis,
                           std::vector<Eigen::Vector3d>& images)
{
  const std::vector<double> length = arc_lengths(mesh, path);
  const Eigen::Vector3d first = images[path.front()], last = images[path.back()];
  for(std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    const double part = length[i] / length.back();
    images[path[i]] = first;
    images[path[i]][axis] = (1 - part) * first[axis] + part * last[axis];
  }
}

// Part of a surface, with the numbers of its vertices and faces in the whole.
struct Surface_chart_3
{
  Boundary_mesh_3 mesh;
  std::vector<int> vertices;
  std::vector<Boundary_mesh_3::Face_index> faces;
};

inline Surface_chart_3 extract_chart(const Boundary_mesh_3& whole, const std::vector<std::size_t>& chart_of_face,
                                     const std::size_t chart)
{
  Surface_chart_3 result;
  std::unordered_map<int, Boundary_mesh_3::Vertex_index> number;
  for(const auto f : whole.faces())
  {
    if(chart_of_face[f] != chart)
      continue;
    std::vector<Boundary_mesh_3::Vertex_index> face;
    for(const auto v : CGAL::vertices_around_face(whole.halfedge(f), whole))
    {
      const auto [entry, is_new] = number.emplace(static_cast<int>(v), Boundary_mesh_3::Vertex_index());
      if(is_new)
      {
        entry->second = result.mesh.add_vertex(whole.point(v));
        result.vertices.push_back(static_cast<int>(v));
      }
      face.push_back(entry->second);
    }
    result.mesh.add_face(face);
    result.faces.push_back(f);
  }
  return result;
}

// Closes all borders of a chart by fans, except the one whose image surrounds the others, and returns that border.
inline Boundary_mesh_3::Halfedge_index fill_holes(Boundary_mesh_3& mesh, const std::vector<Boundary_point_2>& images)
{
  std::vector<Boundary_mesh_3::Halfedge_index> borders;
  Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  const auto leftmost = [&](const Boundary_mesh_3::Halfedge_index border)
  {
    double x = images[mesh.target(border)].x();
    for(const auto v : CGAL::vertices_around_face(border, mesh))
      x = (std::min)(x, images[v].x());
    return x;
  };
  std::iter_swap(borders.begin(), std::min_element(borders.begin(), borders.end(), [&](const auto a, const auto b)
  { return leftmost(a) < leftmost(b); }));
  for(std::size_t i = 1; i < borders.size(); ++i)
  {
    std::vector<Boundary_point_3> points;
    for(const auto v : CGAL::vertices_around_face(borders[i], mesh))
      points.push_back(mesh.point(v));
    Euler::fill_hole(borders[i], mesh);
    mesh.point(mesh.target(Euler::add_center_vertex(borders[i], mesh))) = CGAL::centroid(points.begin(), points.end());
  }
  return borders.front();
}

// Maps the inner vertices of a chart into the polygon of its border by mean value coordinates: one to one if the polygon is
// convex. The images have their coordinates u and v set. Holes are filled for the map, and keep their images. Returns whether
// the linear system was solved.
inline bool map_chart_to_polygon_3(const Surface_chart_3& chart, const int u, const int v,
                                   std::vector<Eigen::Vector3d>& images)
{
  namespace SMP = Surface_mesh_parameterization;

  std::vector<Boundary_point_2> start;
  for(const int w : chart.vertices)
    start.emplace_back(images[w][u], images[w][v]);
  Boundary_mesh_3 mesh = chart.mesh;
  const auto border = fill_holes(mesh, start);
  auto uv_map = mesh.add_property_map<Boundary_mesh_3::Vertex_index, Boundary_point_2>("v:uv").first;
  for(const auto w : chart.mesh.vertices())
    uv_map[w] = start[w];

  SMP::Mean_value_coordinates_parameterizer_3<Boundary_mesh_3, Prescribed_border_parameterizer_3,
                                              Sparse_elimination_traits> parameterizer;
  if(SMP::parameterize(mesh, parameterizer, border, uv_map) != SMP::OK)
    return false;
  const auto vertices = chart.mesh.vertices();
  const auto is_finite = [&](const auto w) { return std::isfinite(uv_map[w].x()) && std::isfinite(uv_map[w].y()); };
  if(!std::all_of(vertices.begin(), vertices.end(), is_finite))
    return false;
  for(const auto w : chart.mesh.vertices())
    if(!chart.mesh.is_border(w))
    {
      images[chart.vertices[w]][u] = uv_map[w].x();
      images[chart.vertices[w]][v] = uv_map[w].y();
    }
  return true;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_MAP_CHART_TO_POLYGON_3_H
