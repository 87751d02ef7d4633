// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_POLYCUBE_3_IMPL_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_POLYCUBE_3_IMPL_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Order_of_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Search_for_polycube_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Unit_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/map_to_voxels_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/frames_of_normals_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/map_to_polycube_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Box/map_to_box_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <cmath>
#include <iterator>
#include <limits>

namespace CGAL::Polycube_meshing_3::internal {

// Body that shares no point with the other bodies of a surface, and the numbers of its vertices on the whole surface.
struct Separate_body_3
{
  Numbered_surface_3 surface;
  std::vector<std::array<std::size_t, 4> > cells;
  std::vector<std::size_t> vertices;
};

inline std::vector<Separate_body_3> separate_bodies_3(const Numbered_surface_3& whole)
{
  std::size_t number_of_points = 0;
  for(const std::array<std::size_t, 4>& cell : *whole.cells)
    number_of_points = (std::max)(number_of_points, *std::max_element(cell.begin(), cell.end()) + 1);
  const std::size_t n = whole.cells->size();
  Disjoint_sets sets(n + number_of_points); // cells, and points behind them
  for(std::size_t c = 0; c < n; ++c)
    for(const std::size_t v : (*whole.cells)[c])
      sets.unite(c, n + v);
  const std::vector<std::size_t> numbers = sets.numbers();
  const auto number_of_body = [&](const std::size_t point) { return numbers[n + point]; };

  std::vector<Separate_body_3> bodies(1 + *std::max_element(numbers.begin(), numbers.begin() + n));
  for(std::size_t c = 0; c < n; ++c)
    bodies[numbers[c]].cells.push_back((*whole.cells)[c]);
  std::vector<std::size_t> number(whole.vertices.size());
  for(std::size_t v = 0; v < number.size(); ++v)
  {
    Separate_body_3& body = bodies[number_of_body(whole.vertices[v])];
    number[v] = body.vertices.size();
    body.vertices.push_back(v);
    body.surface.points.push_back(whole.points[v]);
    body.surface.vertices.push_back(whole.vertices[v]);
  }
  for(const auto& [a, b, c] : whole.facets)
    bodies[number_of_body(whole.vertices[a])].surface.facets.push_back({ number[a], number[b], number[c] });
  for(const auto& [a, b] : whole.sharp_edges)
    bodies[number_of_body(whole.vertices[a])].surface.sharp_edges.push_back({ number[a], number[b] });
  return bodies;
}

// Moves points by a distance in units of the spacing, if there is one: multiples of it stay multiples, bit by bit.
inline void move_along_x(const double distance, const double spacing, std::vector<Vector_3>& points)
{
  const double unit = spacing > 0 ? spacing : 1;
  for(Vector_3& p : points)
  {
    const double multiple = std::round(p.x() / unit);
    p[0] = spacing > 0 && p.x() == spacing * multiple ? spacing * (multiple + distance) : p.x() + unit * distance;
  }
}

// Maps several bodies, each for itself. A polycube that would touch earlier ones is moved to the right of them all, as that of
// a ring linked with another one must be. A body with cavities is refused.
inline Surface_map_3 map_bodies_apart_3(const Numbered_surface_3& whole, const double spacing, const Budget& budget)
{
  std::vector<Separate_body_3> bodies = separate_bodies_3(whole);
  if(bodies.size() == 1)
    return { ERROR_SEVERAL_BOUNDARY_COMPONENTS };
  Surface_map_3 result = { OK, std::vector<Vector_3>(whole.points.size()) };
  std::vector<Box_3> boxes;
  double right = -(std::numeric_limits<double>::infinity)(); // of them all
  for(Separate_body_3& body : bodies)
  {
    body.surface.cells = &body.cells;
    Found_polycube_3 found = map_to_polycube_3({ body.surface, {}, spacing }, budget);
    if(found.status != OK)
      return { found.status };
    std::vector<Vector_3>& part = found.images;
    const Box_3 box = bounding_box(part);
    const auto meets = [&](const Box_3& other)
    { return (box.smallest.cwiseMax(other.smallest) - box.largest.cwiseMin(other.largest)).maxCoeff() <= 0; };
    if(std::any_of(boxes.begin(), boxes.end(), meets))
    {
      const double distance = right - box.smallest.x();
      move_along_x(spacing > 0 ? std::ceil(distance / spacing + 1) : distance + box.diagonal().x() / 8, spacing, part);
    }
    boxes.push_back(bounding_box(part));
    right = (std::max)(right, boxes.back().largest.x());
    for(std::size_t v = 0; v < part.size(); ++v)
      result.images[body.vertices[v]] = part[v];
  }
  return result;
}

// Adds a polycube of voxels, for which edges are split, to a bad polycube or none. It must be far less distorted, as it needs far
// more facets.
inline Found_polycube_3 with_voxels_3(const Turned_surface_3& turned, Surface_map_3 map, const bool may_split,
                                      const Budget& budget)
{
  constexpr double enough = 0.75, usual = 0.6; // a guess, and about the least distortion of voxels that was seen on such bodies
  Surface_map_3 of_voxels;
  if(may_split && enough * map.distortion >= usual)
    of_voxels = map_to_voxels_3(turned, budget);
  if(of_voxels.status != OK || of_voxels.distortion > enough * map.distortion)
    return { map.status, turned.rotation, std::move(map.images) };
  return { OK, turned.rotation, std::move(map.images), std::move(of_voxels.splits), std::move(of_voxels.images) };
}

// Maps a topological sphere to the polycube of six charts, a box close to its bounding box.
inline Surface_map_3 map_to_bounding_box(const Turned_surface_3& turned, const Budget& budget)
{
  const double spacing = turned.spacing;
  Vector_3 lower = turned.box.smallest, upper = turned.box.largest;
  if(spacing > 0)
  {
    const auto rounded = [](const Vector_3& v) { return v.unaryExpr([](const double x) { return std::round(x); }); };
    const Vector_3 first = rounded(lower / spacing);
    lower = spacing * first;
    upper = spacing * (first + Vector_3::Ones()).cwiseMax(rounded(upper / spacing));
  }
  const double size = (upper - lower).maxCoeff();
  const Vector_3 half_lengths = (upper - lower) / (2 * size);
  Numbered_surface_3 unit_surface = turned.surface;
  unit_surface.sharp_edges.clear();
  unit_surface.points = points_of(turned.mesh);
  Surface_map_3 result;
  result.status = map_to_box_3(unit_surface, half_lengths, std::nullopt, result.images, budget);
  if(result.status != OK)
    return result;
  for(Vector_3& image : result.images)
    for(int axis = 0; axis < 3; ++axis)
      image[axis] = (image[axis] == half_lengths[axis]) ? upper[axis] : (image[axis] == -half_lengths[axis]) ? lower[axis]
        : (lower[axis] + upper[axis]) / 2 + size * image[axis];
  Boundary_mesh_3 image = turned.mesh;
  set_points(image, result.images);
  if(Polygon_mesh_processing::does_self_intersect(image))
    result.status = ERROR_BOUNDARY_MAP_NOT_BIJECTIVE;
  return result;
}

// Maps a surface for which no labels of a polycube are found. The polycube is not moved.
inline Found_polycube_3 map_to_any_box_3(Turned_surface_3 turned, const bool may_split, const Budget& budget)
{
  turned.may_move = false;
  const Error_code kind = check_sphere(turned.mesh);
  if(kind != OK && kind != ERROR_SEVERAL_BOUNDARY_COMPONENTS)
    return with_voxels_3(turned, {}, may_split, budget);
  Surface_map_3 map = kind == OK ? map_to_bounding_box(turned, budget)
                                 : map_bodies_apart_3(turned.surface, turned.spacing, budget);
  return { map.status, turned.rotation, std::move(map.images) };
}

inline Found_polycube_3 map_to_labelled_polycube_3(const Turned_surface_3& turned, const std::vector<std::size_t>& labels,
                                                   const Budget& budget)
{
  Polycube_map_3 map(turned, labels);
  if(const Error_code status = map.start_close_to_surface(budget); status != OK)
    return { status };
  Surface_map_3 finished = finished_map_3(map, budget);
  return { finished.status, turned.rotation, std::move(finished.images) };
}

// Takes the frame with the least distortion; if there is no polycube in any, the first one.
inline Found_polycube_3 map_in_frames_3(const std::vector<Turned_surface_3>& frames, const bool may_split, const Budget& budget)
{
  const double factor = frames.size() > 2 ? 2 : std::sqrt(2.); // guesses; three frames have enough candidates with fewer of each
  Surface_map_3 best;
  const Turned_surface_3* frame = &frames.front();
  for(const Turned_surface_3& turned : frames)
    if(Surface_map_3 map = Search_for_polycube_3(turned, factor, budget).run();
       map.status == OK && (best.status != OK || map.distortion < best.distortion))
    {
      best = std::move(map);
      frame = &turned;
    }
  if(budget.is_exhausted())
    return { best.status, frame->rotation, std::move(best.images) };
  return best.status == OK ? with_voxels_3(*frame, std::move(best), may_split, budget)
                           : map_to_any_box_3(*frame, may_split, budget);
}

// Returns the surface as it is, or turned by each rotation that brings its normals close to the axes.
inline std::vector<Turned_surface_3> frames_of_surface_3(const Polycube_problem_3& problem, const Boundary_mesh_3& mesh)
{
  const bool do_find_axes = problem.do_find_axes && problem.labels.empty();
  const Turned_surface_3 unturned(problem.surface, mesh, Matrix_3::Identity());
  std::vector<Turned_surface_3> result;
  for(const Matrix_3& rotation : do_find_axes ? frames_of_normals_3(unturned.mesh) : std::vector<Matrix_3>{ unturned.rotation })
  {
    result.emplace_back(problem.surface, mesh, rotation);
    result.back().spacing = problem.spacing;
    result.back().may_move = do_find_axes;
  }
  return result;
}

// Maps a surface whose order is that of the search. If there is no polycube with the spacing, tells whether there is one without.
inline Found_polycube_3 map_ordered_surface_3(const Polycube_problem_3& problem, const Budget& budget)
{
  constexpr double largest_spacing = 1e60; // cubes of longer edges overflow
  if(problem.spacing > largest_spacing)
    return { ERROR_SPACING_TOO_COARSE };
  Boundary_mesh_3 mesh;
  if(const Error_code status = build_boundary_mesh_3(problem.surface, mesh); status != OK)
    return { status };
  const std::vector<Turned_surface_3> frames = frames_of_surface_3(problem, mesh);
  Found_polycube_3 found = problem.labels.empty() ? map_in_frames_3(frames, problem.may_split, budget)
                                                  : map_to_labelled_polycube_3(frames.front(), problem.labels, budget);
  if(found.status != OK && problem.spacing > 0)
  {
    Polycube_problem_3 without_spacing = problem;
    without_spacing.spacing = 0;
    without_spacing.may_split = false;
    if(map_ordered_surface_3(without_spacing, budget).status == OK)
      found.status = ERROR_SPACING_TOO_COARSE;
  }
  return found;
}

CGAL_POLYCUBE_MESHING_3_INLINE
Found_polycube_3 map_to_polycube_3(const Polycube_problem_3& problem, const Budget& budget)
{
  const Order_of_surface_3 order(problem.surface);
  Polycube_problem_3 ordered = problem;
  ordered.surface = order.surface();
  ordered.labels = order.of_facets(problem.labels);
  Found_polycube_3 found = map_ordered_surface_3(ordered, budget);
  if(found.status != OK)
    return { found.status };
  found.images = order.back(found.images);
  found.images_with_splits = order.back(found.images_with_splits);
  for(auto& [v, w] : found.splits)
  {
    v = order.point(v);
    w = order.point(w);
  }
  return found;
}
} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_POLYCUBE_3_IMPL_H
