// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SURFACE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SURFACE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Split_fit_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/map_to_sphere_3_impl.h>

#include <Eigen/Eigenvalues>

namespace CGAL::Volume_mesh_parameterization::internal {

// Points of a body, each with the point of a target that it should be near to.
using Point_pair_3 = std::pair<Vector_3, Vector_3>;
using Point_pairs_3 = std::vector<Point_pair_3>;

// Area, center and principal axes of a surface.
struct Moments_3
{
  double area = 0;
  Vector_3 center = Vector_3::Zero();
  Matrix_3 axes; // columns of a rotation, by ascending moments

  explicit Moments_3(const Numbered_surface_3& surface)
  {
    const Vector_3 origin = surface.points[0];
    Matrix_3 second = Matrix_3::Zero();
    for(const auto& facet : surface.facets)
    {
      const double part = normal_of(facet, surface.points).norm() / 2;
      Vector_3 sum = Vector_3::Zero();
      for(const std::size_t v : facet)
      {
        const Vector_3 p = surface.points[v] - origin;
        sum += p;
        second += part / 12 * Matrix_3::outer_product(p, p);
      }
      area += part;
      center += part / 3 * sum;
      second += part / 12 * Matrix_3::outer_product(sum, sum);
    }
    center = center / area;
    const Eigen::Matrix3d central = second / area - Matrix_3::outer_product(center, center);
    axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(central).eigenvectors();
    axes.col(2) = (axes.determinant() < 0 ? -1 : 1) * axes.col(2);
    center += origin;
  }
};

inline int nearest_vertex(const Numbered_surface_3& surface, const Vector_3& p)
{
  const auto nearest = std::min_element(surface.points.begin(), surface.points.end(), [&](const auto& q, const auto& r)
  { return (q - p).squaredNorm() < (r - p).squaredNorm(); });
  return static_cast<int>(nearest - surface.points.begin());
}

// Returns vertices of a body with the directions that they should have, in one or several ways. Without landmarks, principal axes
// are put on principal axes, whose signs are open, and each vertex should have the direction of the nearest point of the target.
// Bodies with sharp edges often have their axes already.
inline std::vector<std::vector<std::pair<int, Vector_3> > > wanted_directions_3(
  const Numbered_surface_3& surface, const Numbered_surface_3& target, const Surface_on_sphere_3& on_sphere,
  const Point_pairs_3& landmarks, const bool have_features)
{
  std::vector<std::vector<std::pair<int, Vector_3> > > result;
  if(!landmarks.empty())
  {
    result.resize(1);
    for(const auto& [p, q] : landmarks)
      result[0].emplace_back(nearest_vertex(surface, p), on_sphere.nearest_position(q).direction);
    return result;
  }
  const Moments_3 of_surface(surface), of_target(target);
  std::vector<Matrix_3> turns(have_features ? 1 : 0, Matrix_3::Identity());
  for(const auto& signs : { Vector_3(1, 1, 1), { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } })
    turns.push_back(of_target.axes * Matrix_3::diagonal(signs) * of_surface.axes.transpose());
  for(const Matrix_3& turn : turns)
  {
    result.emplace_back();
    for(std::size_t v = 0; v < surface.points.size(); ++v)
      result.back().emplace_back(static_cast<int>(v), on_sphere.nearest_position(
        of_target.center + turn * (surface.points[v] - of_surface.center)).direction);
  }
  return result;
}

// Returns a size, a power of two, by which coordinates are divided without a loss of digits.
inline double size_of(const Numbered_surface_3& surface)
{ return std::exp2(std::ilogb(bounding_box(surface.points).diagonal().maxCoeff())); }

// Divides the coordinates of a surface and of its side of the landmarks.
inline void divide(Numbered_surface_3& surface, Point_pairs_3& landmarks, Vector_3 Point_pair_3::* const side, const double size)
{
  for(Vector_3& p : surface.points)
    p = p / size;
  for(Point_pair_3& pair : landmarks)
    pair.*side = pair.*side / size;
}

// Curves of sharp edges of a surface and of its target.
using Curves_of_pair_3 = std::array<std::vector<Feature_curve_3>, 2>;

// Returns lists of curves that may be alike. Edges of a target are sharp by their angles, those of a surface may be marked.
// A coarse circle may turn sharply, or not.
inline std::vector<Curves_of_pair_3> curves_of_pair_3(const Numbered_surface_3& surface, const Numbered_surface_3& target)
{
  const Sorted_edges by_angle = sharp_edges_by_angle(surface), of_target = sharp_edges_by_angle(target);
  std::vector<Sorted_edges> lists = { surface.sharp_edges };
  if(by_angle != surface.sharp_edges)
    lists.push_back(by_angle);
  std::vector<Curves_of_pair_3> result;
  for(const Sorted_edges& edges : lists)
    for(const bool do_end_at_turns : { true, false })
      if(!edges.empty() && !of_target.empty())
        result.push_back({ feature_curves_3(surface, edges, do_end_at_turns),
                           feature_curves_3(target, of_target, do_end_at_turns) });
  return result;
}

// Returns the ways in which landmarks or axes turn the surface of a pair, each with the features that it meets, by the first of
// several lists of curves, or by one by which all are met. These ways, and then those with the least distortion, come first.
inline std::vector<Surface_pair_3> sorted_ways(const Surface_pair_3& pair, const Point_pairs_3& landmarks,
                                               const std::vector<Curves_of_pair_3>& curves, const double epsilon,
                                               const Budget& budget)
{
  constexpr int number_of_sweeps = 5; // a guess
  const Surface_on_sphere_3 on_sphere(pair.target.surface->points, pair.target.surface->facets, pair.target.directions);
  std::vector<Surface_pair_3> result;
  for(const auto& wanted : wanted_directions_3(*pair.surface.surface, *pair.target.surface, on_sphere, landmarks, !curves.empty()))
  {
    Surface_pair_3& turned = result.emplace_back(pair);
    turn_to_landmarks_3(wanted, turned.surface.directions);
    turned.relax(number_of_sweeps, epsilon, budget);
    for(std::size_t i = 0; i < curves.size() && !turned.features.are_complete; ++i)
      if(auto found = matched_features_3(curves[i][0], curves[i][1], *pair.target.surface, turned.images);
         i == 0 || found.are_complete)
        turned.features = std::move(found);
    turned.relax_to_goals(epsilon, budget);
  }
  std::stable_sort(result.begin(), result.end(), [](const Surface_pair_3& a, const Surface_pair_3& b)
  { return std::make_pair(!a.features.are_complete, a.distortion) < std::make_pair(!b.features.are_complete, b.distortion); });
  return result;
}

// Moves vertices until the images are fitted, and remain so with less smoothing. Returns no images if they are never fitted.
template <typename IsFitted>
Surface_pair_3 fitted_pair(Surface_pair_3 pair, const double smooth, const IsFitted& is_fitted, const Budget& budget)
{
  constexpr int number_of_rounds = 40, sweeps_of_round = 3; // guesses
  Surface_pair_3 result = { pair.surface, pair.target };
  for(int round = 0; round <= number_of_rounds && !budget.is_exhausted(); ++round)
  {
    if(round > 0)
      pair.relax_both(sweeps_of_round, smooth, budget);
    if(!is_fitted(pair))
      continue;
    result = pair;
    Surface_pair_3 relaxed = pair;
    relaxed.sharpen(budget);
    if(is_fitted(relaxed))
      return relaxed;
  }
  return result;
}

// Moves the vertices of a fitted surface such that features are met. Facets may be turned over.
inline Surface_pair_3 met_features(Surface_pair_3 pair, const Budget& budget)
{
  if(pair.features.points.empty())
    return pair;
  pair.holds_features = true;
  pair.sharpen(budget);
  for(const auto& [v, point] : pair.features.points)
    pair.images[v] = point;
  return pair;
}

// Fits a pair in one of several ways, if possible such that features are met. Returns no images if it is never fitted.
template <typename IsFitted>
Surface_pair_3 best_fitted_pair(const std::vector<Surface_pair_3>& ways, const double smooth, const IsFitted& is_fitted,
                                const Budget& budget)
{
  Surface_pair_3 best = { ways[0].surface, ways[0].target };
  for(const Surface_pair_3& turned : ways)
    if(Surface_pair_3 fitted = fitted_pair(turned, smooth, is_fitted, budget); !fitted.images.empty())
    {
      if(const Surface_pair_3 met = met_features(fitted, budget); is_fitted(met))
        fitted = met;
      if(best.images.empty() || fitted.holds_features)
        best = std::move(fitted);
      if(best.holds_features || !turned.features.are_complete)
        break;
    }
  return best;
}

// Images of the vertices of a surface on another one, after edges of the surface are split one after the other. New vertices come
// behind all others.
struct Fitted_surface_3
{
  std::vector<Vector_3> images = {};
  std::vector<std::array<std::size_t, 2> > splits = {};
  bool is_complete = true; // or were the splits ended?
};

// Maps a triangulated sphere onto another one, such that no facet intersects another one or is turned over. Splits edges where the
// images are farther than a tolerance from the target.
inline Error_code map_to_surface_3(Numbered_surface_3 surface, Numbered_surface_3 target, Point_pairs_3 landmarks,
                                   const double tolerance, Fitted_surface_3& result, const Budget& budget)
{
  if(!std::all_of(landmarks.begin(), landmarks.end(), [](const auto& pair) { return (pair.first + pair.second).allFinite(); }))
    return ERROR_INVALID_LANDMARK;
  std::vector<Vector_3> directions, directions_of_target;
  if(const Error_code status = map_to_sphere_3(surface, Landmarks_3(), directions, budget); status != OK)
    return status;
  if(map_to_sphere_3(target, Landmarks_3(), directions_of_target, budget) != OK)
    return ERROR_TARGET_NOT_A_SPHERE;

  const double size = size_of(target);
  divide(target, landmarks, &Point_pair_3::second, size);
  divide(surface, landmarks, &Point_pair_3::first, size_of(surface));
  const double area = Moments_3(target).area;
  if(!(area > 0))
    return ERROR_TARGET_NOT_A_SPHERE;
  divide(surface, landmarks, &Point_pair_3::first, std::sqrt(Moments_3(surface).area / area));

  Boundary_mesh_3 mesh, mesh_of_target;
  build_boundary_mesh_3(surface, mesh);
  build_boundary_mesh_3(target, mesh_of_target);
  const Vertex_rings_3 rings(mesh), rings_of_target(mesh_of_target);
  const Triangulated_surface_3 triangulated(arrays_of(target.points), target.facets);
  const auto is_fitted = [&](const Surface_pair_3& pair)
  {
    set_points(mesh, pair.images);
    return turned_facets(mesh, triangulated).empty() && !Polygon_mesh_processing::does_self_intersect(mesh);
  };
  constexpr double smooth = 0.1; // a guess for e
  Surface_pair_3 pair = { { &surface, &rings, directions }, { &target, &rings_of_target, directions_of_target } };
  for(const auto& [p, q] : landmarks)
    pair.goals.emplace(nearest_vertex(surface, p), to_vector(triangulated.nearest_point(coordinates(q)).point));
  const std::vector<Curves_of_pair_3> curves = curves_of_pair_3(surface, target);
  Surface_pair_3 best = { pair.surface, pair.target };
  const std::vector<Surface_pair_3> ways = sorted_ways(pair, landmarks, curves, smooth, budget);
  const bool have_features
    = std::any_of(ways.begin(), ways.end(), [](const Surface_pair_3& way) { return !way.features.points.empty(); });
  // features that are alike by chance may be in the way, and without features, the axes as they are may help
  for(const bool with_curves : { have_features, !have_features })
    if(best.images.empty())
      best = best_fitted_pair(with_curves ? ways : sorted_ways(pair, landmarks, {}, smooth, budget), smooth, is_fitted, budget);
  if(best.images.empty())
    return ERROR_BOUNDARY_NOT_FITTED;
  Split_fit_3 fit(best, mesh, triangulated);
  const Budget budget_of_splits = budget.of_phase(Phase::SPLITS, 0.5); // a guess; the map needs time, too
  result.is_complete = !std::isfinite(tolerance) || fit.split(tolerance / size, budget_of_splits);
  if(!result.is_complete && !budget_of_splits.is_exhausted())
    return ERROR_FIT_TOLERANCE_NOT_REACHED;
  for(const Vector_3& p : fit.images())
    result.images.push_back(size * p);
  result.splits = fit.splits();
  return OK;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SURFACE_3_H
