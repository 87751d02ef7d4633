// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOUNDARY_MESH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOUNDARY_MESH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

using Boundary_kernel = Exact_predicates_inexact_constructions_kernel;
using Boundary_point_2 = Boundary_kernel::Point_2;
using Boundary_point_3 = Boundary_kernel::Point_3;
using Boundary_mesh_3 = Surface_mesh<Boundary_point_3>;

inline Boundary_mesh_3::Vertex_index vertex_index(const std::size_t v)
{ return Boundary_mesh_3::Vertex_index(static_cast<Boundary_mesh_3::size_type>(v)); }

// Builds the surface with its neighborhoods. The mesh is complete only if OK is returned: the surface is a closed manifold.
template <typename Surface>
Error_code build_boundary_mesh_3(const Surface& surface, Boundary_mesh_3& mesh)
{
  if(surface.facets.empty())
    return ERROR_EMPTY_COMPLEX;
  for(const Vector_3& p : surface.points)
    if(!p.allFinite())
      return ERROR_NON_FINITE_COORDINATE;
  if(!Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(surface.facets))
    return ERROR_NON_MANIFOLD_BOUNDARY;

  for(const Vector_3& p : surface.points)
    mesh.add_vertex(exact_point(p));
  for(const std::array<std::size_t, 3>& facet : surface.facets)
    mesh.add_face(vertex_index(facet[0]), vertex_index(facet[1]), vertex_index(facet[2]));
  return CGAL::is_closed(mesh) ? OK : ERROR_NON_MANIFOLD_BOUNDARY;
}

// Returns for each edge of a mesh whether it is among those between the given vertices.
template <typename Edges>
std::vector<bool> are_among(const Boundary_mesh_3& mesh, const Edges& edges)
{
  std::vector<bool> result(mesh.number_of_edges(), false);
  for(const auto& [v, w] : edges)
    result[mesh.edge(mesh.halfedge(vertex_index(v), vertex_index(w)))] = true;
  return result;
}

inline Vector_3 edge_vector(const Boundary_mesh_3& mesh, const Boundary_mesh_3::Halfedge_index h)
{ return to_vector(mesh.point(mesh.target(h))) - to_vector(mesh.point(mesh.source(h))); }

// Returns the lengths of a path up to each of its vertices.
template <typename Path>
std::vector<double> arc_lengths(const Boundary_mesh_3& mesh, const Path& path)
{
  const auto point = [&](const std::size_t i) { return to_vector(mesh.point(Boundary_mesh_3::Vertex_index(path[i]))); };
  std::vector<double> result(1, 0.);
  for(std::size_t i = 1; i < path.size(); ++i)
    result.push_back(result.back() + (point(i) - point(i - 1)).norm());
  return result;
}

// Spaces the images of the vertices of a path between those of its ends, along an axis, by their distances.
template <typename Path>
void map_path_to_segment_3(const Boundary_mesh_3& mesh, const Path& path, const int axis,
                           std::vector<Vector_3>& images)
{
  const std::vector<double> length = arc_lengths(mesh, path);
  const Vector_3 first = images[path.front()], last = images[path.back()];
  for(std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    const double part = length[i] / length.back();
    images[path[i]] = first;
    images[path[i]][axis] = (1 - part) * first[axis] + part * last[axis];
  }
}

// Returns the vertices of a face, counterclockwise as seen from outside.
inline std::array<Boundary_mesh_3::Vertex_index, 3> vertices_of_face(const Boundary_mesh_3& mesh,
                                                                     const Boundary_mesh_3::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return { mesh.source(h), mesh.target(h), mesh.target(mesh.next(h)) };
}

inline Facet_edges_3 edges_of_face(const Boundary_mesh_3& mesh, const Boundary_mesh_3::Face_index f)
{ return edges_of_facet(vertices_of_face(mesh, f), [&](const auto v) { return to_vector(mesh.point(v)); }); }

inline double area_of_face(const Boundary_mesh_3& mesh, const Boundary_mesh_3::Face_index f)
{
  const auto [a, b, c] = vertices_of_face(mesh, f);
  return std::sqrt(CGAL::squared_area(mesh.point(a), mesh.point(b), mesh.point(c)));
}

inline Box_3 bounding_box(const std::vector<Vector_3>& points)
{
  Box_3 box;
  for(const Vector_3& p : points)
    box.extend(p);
  return box;
}

inline std::vector<Vector_3> points_of(const Boundary_mesh_3& mesh)
{
  std::vector<Vector_3> result;
  for(const auto v : mesh.vertices())
    result.push_back(to_vector(mesh.point(v)));
  return result;
}

// Returns the points of the surface, moved and scaled such that the longest side of their bounding box is 1.
inline std::vector<Vector_3> unit_points(const Boundary_mesh_3& mesh)
{
  std::vector<Vector_3> points = points_of(mesh);
  const Box_3 box = bounding_box(points);
  for(Vector_3& p : points)
    p = (p - box.center()) / box.diagonal().maxCoeff();
  return points;
}

inline void set_points(Boundary_mesh_3& mesh, const std::vector<Vector_3>& points)
{
  for(const auto v : mesh.vertices())
    mesh.point(v) = exact_point(points[v]);
}

// Returns OK if the closed surface is a topological sphere, or else what it is instead.
template <typename Mesh>
Error_code check_sphere(const Mesh& mesh)
{
  std::vector<std::size_t> component(mesh.number_of_faces());
  const auto component_map = boost::make_iterator_property_map(component.begin(), get(boost::face_index, mesh));
  if(Polygon_mesh_processing::connected_components(mesh, component_map) > 1)
    return ERROR_SEVERAL_BOUNDARY_COMPONENTS;
  if(mesh.number_of_vertices() + mesh.number_of_faces() != mesh.number_of_edges() + 2)
    return ERROR_BOUNDARY_NOT_OF_GENUS_ZERO;
  return OK;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOUNDARY_MESH_3_H
