// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_MAP_TO_BOX_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_MAP_TO_BOX_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Box/Cube_edge_router_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Box/map_to_box_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Chart_relaxation_2.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Radial_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/map_to_sphere_3_impl.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/split_edge_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_arithmetic_3.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <queue>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns the points, moved and scaled such that their bounding box becomes the cube [-1, 1]^3.
inline std::vector<Vector_3> in_bounding_cube(std::vector<Vector_3> points)
{
  const Box_3 box = bounding_box(points);
  const Vector_3 sizes = box.diagonal().cwiseMax(Vector_3::Constant((std::numeric_limits<double>::min)()));
  for(Vector_3& point : points)
    for(int axis = 0; axis < 3; ++axis)
      point[axis] = 2 * ((point[axis] - box.center()[axis]) / sizes[axis]);
  return points;
}

// Returns the corner with positive coordinates of the box in the unit sphere whose faces, seen from the center, have solid
// angles in the ratio of the areas of another box. The angle of the face normal to the third axis of a box with corner
// (a, b, c) is 4 atan(a b / c).
inline Vector_3 corner_on_sphere(const Vector_3& half_lengths)
{
  const Vector_3 areas = half_lengths.minCoeff() * half_lengths.unaryExpr([](const double x) { return 1 / x; });
  Vector_3 corner;
  for(int axis = 0; axis < 3; ++axis)
  {
    const double t = std::tan(CGAL_PI / 2 * areas[(axis + 1) % 3] / areas.sum());
    const double u = std::tan(CGAL_PI / 2 * areas[(axis + 2) % 3] / areas.sum());
    corner[axis] = std::sqrt(t * u);
  }
  return corner;
}

// Returns eight different vertices for the corners of a box, by two measures: on the sphere, the charts between them have
// areas in the ratio of the faces of the box; in space, the vertices are close to the corners of the bounding box.
inline std::array<int, 8> cube_corners_3(const std::vector<Vector_3>& points,
                                         const std::vector<Vector_3>& images,
                                         const Vector_3& half_lengths)
{
  const double weight_of_box = 0.3; // lowered the distortion most over organic and mechanical models
  const std::vector<Vector_3> cube_points = in_bounding_cube(points);
  Matrix_3 covariance = Matrix_3::Zero(); // turns the images into the directions of the points (Kabsch)
  for(std::size_t v = 0; v < cube_points.size(); ++v)
    covariance += Matrix_3::outer_product(cube_points[v], images[v]);
  const Matrix_3 rotation = rotation_and_stretch_3(covariance).rotation;
  const Vector_3 positive_corner = corner_on_sphere(half_lengths);
  std::array<int, 8> corners = {};
  std::vector<bool> is_corner(points.size(), false);
  for(int k = 0; k < 8; ++k)
  {
    const Vector_3 corner(side_of_corner(k, 0), side_of_corner(k, 1), side_of_corner(k, 2));
    const Vector_3 direction = rotation.transpose() * (Matrix_3::diagonal(positive_corner) * corner);
    double largest = -(std::numeric_limits<double>::infinity)();
    for(std::size_t v = 0; v < images.size(); ++v)
    {
      const double closeness = direction.dot(images[v]) + weight_of_box * corner.dot(cube_points[v]) / 3;
      if(!is_corner[v] && closeness > largest)
      {
        largest = closeness;
        corners[k] = static_cast<int>(v);
      }
    }
    is_corner[corners[k]] = true;
  }
  return corners;
}

// Boundary of a box around the origin, as a domain of `Radial_map_3`. Vertices move in their face or along their edge: a
// vertex is on a face if one of its coordinates is exactly the one of the face.
struct Box_boundary_3
{
  static constexpr double curvature = 0; // faces and edges are flat

  Vector_3 half_lengths;

  bool is_on_side(const Vector_3& image, const int axis) const { return std::abs(image[axis]) == half_lengths[axis]; }

  double area() const
  { return 8 * (half_lengths[0] * half_lengths[1] + half_lengths[1] * half_lengths[2] + half_lengths[2] * half_lengths[0]); }

  Small_matrix<3, 2> tangents(const Vector_3& image) const
  {
    Small_matrix<3, 2> result = Small_matrix<3, 2>::Zero();
    int column = 0;
    for(int axis = 0; axis < 3; ++axis)
      if(!is_on_side(image, axis))
        result(axis, column++) = 1;
    return result;
  }

  Vector_3 move(const Vector_3& image, const Vector_3& step) const { return image + step; }

  // Returns the distance from the origin of the face that contains the triangle.
  double height(const Vector_3& a, const Vector_3& b, const Vector_3& c) const
  {
    for(int axis = 0; axis < 3; ++axis)
      if(is_on_side(a, axis) && a[axis] == b[axis] && a[axis] == c[axis])
        return half_lengths[axis];
    return 1;
  }
};

// Maps the charts between the paths, which have their images, to faces of the box.
inline bool map_charts_to_box(const Boundary_mesh_3& mesh, const std::vector<bool>& is_on_path, const std::vector<bool>& is_held,
                              std::vector<Vector_3>& images, const Budget& budget)
{
  std::vector<std::size_t> chart_of_face(mesh.number_of_faces());
  std::vector<std::vector<Boundary_mesh_3::Face_index> > charts(Polygon_mesh_processing::connected_components(
    mesh, boost::make_iterator_property_map(chart_of_face.begin(), get(boost::face_index, mesh)),
    parameters::edge_is_constrained_map(boost::make_function_property_map<Boundary_mesh_3::Edge_index>(
      [&](const Boundary_mesh_3::Edge_index e) -> bool { return is_on_path[e]; }))));
  for(const auto f : mesh.faces())
    charts[chart_of_face[f]].push_back(f);
  Held_coordinates is_held_along;
  for(const bool is : is_held)
    is_held_along.push_back({ is, is, is });
  for(const auto& faces : charts)
  {
    Box_3 border;
    for(const auto f : faces)
      for(const auto v : vertices_of_face(mesh, f))
        if(is_held[v])
          border.extend(images[v]);
    const int axis = (-border.diagonal()).largest_index();
    if(budget.is_exhausted() || border.diagonal()[axis] != 0)
      return false;
    const double height = border.smallest[axis];
    for(const auto f : faces)
      for(const auto v : vertices_of_face(mesh, f))
        images[v][axis] = height;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Chart_relaxation_2(mesh, faces, is_held_along, height > 0 ? u : v, height > 0 ? v : u, images).run(images, budget);
  }
  return true;
}

// Maps a triangulated topological sphere with a known image on the unit sphere onto the boundary of a box: twelve paths on
// the surface become the edges of the box, and the charts between them its faces. Lengths on the sphere guide the paths and
// the first map of the charts, as long thin parts of the surface are compact there. The last step lowers the distortion of
// the map from the surface itself.
inline Error_code map_sphere_to_box_3(const Boundary_mesh_3& mesh, const std::vector<Vector_3>& sphere,
                                      const Vector_3& half_lengths, const Box_paths_3& paths,
                                      std::vector<Vector_3>& images, const Budget& budget)
{
  Boundary_mesh_3 sphere_mesh = mesh;
  set_points(sphere_mesh, sphere);
  images.assign(sphere.size(), Vector_3::Zero());
  for(int k = 0; k < 8; ++k)
    for(int axis = 0; axis < 3; ++axis)
      images[paths.corners[k]][axis] = side_of_corner(k, axis) * half_lengths[axis];
  std::vector<bool> is_on_path(mesh.number_of_edges(), false), is_held(mesh.number_of_vertices(), false);
  for(std::size_t i = 0; i < 12; ++i)
  {
    const std::vector<int>& path = paths.paths[i];
    map_path_to_segment_3(sphere_mesh, path, paths.edges[i].axis, images);
    for(const int v : path)
      is_held[v] = true;
    for(std::size_t k = 1; k < path.size(); ++k)
      is_on_path[mesh.edge(mesh.halfedge(Boundary_mesh_3::Vertex_index(path[k - 1]),
                                         Boundary_mesh_3::Vertex_index(path[k])))] = true;
  }
  if(!map_charts_to_box(sphere_mesh, is_on_path, is_held, images, budget))
    return ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;

  const std::vector<Vector_3> points = unit_points(mesh);
  const Box_boundary_3 domain = { half_lengths };
  Radial_map_3<Box_boundary_3>(Vertex_rings_3(mesh), points, images, domain, budget).relax(100, 1e-4);
  return is_radially_bijective_3(mesh, images) ? OK : ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
}

// Maps a surface with a known image on the unit sphere to a box by the shortest paths, and by paths that prefer sharp edges if
// these differ. Takes the map of less distortion, and its paths.
inline Error_code map_mesh_to_box_3(const Boundary_mesh_3& mesh, const std::vector<Vector_3>& sphere,
                                    const Sorted_edges& sharp_edges, const Vector_3& half_lengths,
                                    const std::optional<std::array<int, 8> >& given_corners, std::vector<Vector_3>& images,
                                    Box_paths_3& paths, const Budget& budget)
{
  if(mesh.number_of_vertices() < 8)
    return ERROR_BOUNDARY_TOO_COARSE;
  const std::vector<Vector_3> points = unit_points(mesh);
  const std::array<int, 8> corners = given_corners ? *given_corners : cube_corners_3(points, sphere, half_lengths);
  const Vertex_rings_3 rings(mesh);
  Cube_edge_router_3 router(rings, sphere, corners, {}, budget), along_edges(rings, sphere, corners, sharp_edges, budget);
  const auto map = [&](const Cube_edge_router_3& found, std::vector<Vector_3>& result)
  { return map_sphere_to_box_3(mesh, sphere, half_lengths, found.paths(), result, budget); };
  const Error_code status = router.run() ? map(router, images)
    : Cube_edge_router_3(rings, sphere, mirrored(corners), {}, budget).run() ? ERROR_MIRRORED_CORNERS : ERROR_BOUNDARY_TOO_COARSE;
  paths = router.paths();
  std::vector<Vector_3> others;
  if(sharp_edges.empty() || !along_edges.run() || along_edges.has_paths_of(router) || map(along_edges, others) != OK)
    return status;
  std::vector<std::array<Boundary_mesh_3::Vertex_index, 3> > facets;
  for(const auto f : mesh.faces())
    facets.push_back(vertices_of_face(mesh, f));
  const auto distortion = [&](const std::vector<Vector_3>& of_vertices)
  { return facet_distortion_3(facets, [&](const auto v) { return points[v]; }, [&](const auto v) { return of_vertices[v]; }); };
  if(status == OK && distortion(images) <= distortion(others))
    return status;
  images = std::move(others);
  paths = along_edges.paths();
  return OK;
}

// Splits edges whose images on the sphere are longer than a bound, the longest first. Vertices come to the middle of arcs.
inline void split_long_arcs_3(Boundary_mesh_3& mesh, std::vector<Vector_3>& sphere, const double bound,
                              std::vector<std::array<std::size_t, 2> >& splits)
{
  std::priority_queue<std::pair<double, Boundary_mesh_3::Edge_index> > queue;
  const auto length = [&](const auto e) { return (sphere[mesh.vertex(e, 0)] - sphere[mesh.vertex(e, 1)]).norm(); };
  const auto add = [&](const auto e)
  {
    if(length(e) > bound)
      queue.push({ length(e), e });
  };
  for(const auto e : mesh.edges())
    add(e);
  while(!queue.empty())
  {
    const auto [length_then, e] = queue.top();
    queue.pop();
    if(length(e) != length_then) // it has been split since
      continue;
    splits.push_back(split_edge_3(mesh, e));
    sphere.push_back((sphere[splits.back()[0]] + sphere[splits.back()[1]]).normalized());
    for(const auto h : CGAL::halfedges_around_target(vertex_index(sphere.size() - 1), mesh))
      add(mesh.edge(h));
  }
}

// Returns which vertices of a surface remain if only the splits are made that paths need: those of their vertices and of edges
// that join two of these, and all splits whose vertices these have around them. So each edge of the paths remains.
inline std::vector<bool> vertices_with_splits_of_paths_3(Boundary_mesh_3 mesh,
                                                         const std::vector<std::array<std::size_t, 2> >& splits, Box_paths_3 paths)
{
  const std::size_t n = mesh.number_of_vertices();
  std::vector<bool> is_on_path(n + splits.size(), false), remains(n + splits.size(), false);
  paths.for_each_vertex([&](const int v) { is_on_path[v] = true; });
  std::fill_n(remains.begin(), n, true);
  std::vector<std::array<std::size_t, 2> > apexes;
  for(const auto& [v, w] : splits)
  {
    const auto h = mesh.halfedge(vertex_index(v), vertex_index(w));
    apexes.push_back({ mesh.target(mesh.next(h)), mesh.target(mesh.next(mesh.opposite(h))) });
    split_edge_3(mesh, mesh.edge(h));
  }
  for(std::size_t i = splits.size(); i-- > 0; )
    if(const auto& [v, w] = splits[i]; remains[n + i] || is_on_path[n + i] || (is_on_path[v] && is_on_path[w]))
      for(const std::size_t u : { n + i, v, w, apexes[i][0], apexes[i][1] })
        remains[u] = true;
  return remains;
}

// Maps a surface with splits to a box again, without the splits that its paths do not need, if that is possible.
inline void leave_out_splits_3(Boundary_mesh_3 mesh, const std::vector<Vector_3>& sphere, const Vector_3& half_lengths,
                               Box_paths_3 paths, std::vector<Vector_3>& images,
                               std::vector<std::array<std::size_t, 2> >& splits, const Budget& budget)
{
  const std::size_t n = mesh.number_of_vertices();
  const std::vector<bool> remains = vertices_with_splits_of_paths_3(mesh, splits, paths);
  std::vector<std::size_t> numbers; // of all vertices among those that remain
  std::vector<Vector_3> fewer_on_sphere, fewer_images;
  std::vector<std::array<std::size_t, 2> > fewer_splits;
  for(std::size_t v = 0; v < remains.size(); ++v)
  {
    numbers.push_back(fewer_on_sphere.size());
    if(!remains[v])
      continue;
    fewer_on_sphere.push_back(sphere[v]);
    if(v < n)
      continue;
    fewer_splits.push_back({ numbers[splits[v - n][0]], numbers[splits[v - n][1]] });
    split_edge_3(mesh, mesh.edge(mesh.halfedge(vertex_index(fewer_splits.back()[0]), vertex_index(fewer_splits.back()[1]))));
  }
  paths.for_each_vertex([&](int& v) { v = static_cast<int>(numbers[v]); });
  if(map_sphere_to_box_3(mesh, fewer_on_sphere, half_lengths, paths, fewer_images, budget) != OK)
    return;
  images = std::move(fewer_images);
  splits = std::move(fewer_splits);
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Error_code map_to_box_3(const Numbered_surface_3& surface, const Vector_3& half_lengths,
                        const std::optional<std::array<int, 8> >& corners, std::vector<Vector_3>& images,
                        const Budget& budget, std::vector<std::array<std::size_t, 2> >* const splits)
{
  constexpr std::array<double, 3> bounds = { 0.5, 0.25, 0.125 }; // guesses; edges of a cube in the unit sphere have length 1.15
  Boundary_mesh_3 mesh;
  Error_code status = build_boundary_mesh_3(surface, mesh);
  std::vector<Vector_3> sphere;
  if(status == OK)
    status = map_mesh_to_sphere_3(mesh, sphere, budget);
  if(status != OK)
    return status;
  Box_paths_3 paths = {};
  const auto map = [&]
  { return map_mesh_to_box_3(mesh, sphere, surface.sharp_edges, half_lengths, corners, images, paths, budget); };
  status = map();
  for(auto bound = bounds.begin(); splits != nullptr && status == ERROR_BOUNDARY_TOO_COARSE && bound != bounds.end(); ++bound)
  {
    split_long_arcs_3(mesh, sphere, *bound, *splits);
    status = map();
  }
  if(status == OK && splits != nullptr && !splits->empty())
  {
    Boundary_mesh_3 unrefined;
    build_boundary_mesh_3(surface, unrefined);
    leave_out_splits_3(std::move(unrefined), sphere, half_lengths, std::move(paths), images, *splits, budget);
  }
  return status;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOX_MAP_TO_BOX_3_IMPL_H
