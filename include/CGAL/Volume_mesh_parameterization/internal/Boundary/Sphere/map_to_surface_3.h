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

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Surface_on_sphere_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/map_to_sphere_3_impl.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <Eigen/Eigenvalues>

#include <map>
#include <optional>

namespace CGAL::Volume_mesh_parameterization::internal {

inline Eigen::Vector3d normal_of(const std::array<std::size_t, 3>& facet, const std::vector<Eigen::Vector3d>& points)
{ return (points[facet[1]] - points[facet[0]]).cross(points[facet[2]] - points[facet[0]]); }

inline double area_of(const Numbered_surface_3& surface)
{
  double result = 0;
  for(const std::array<std::size_t, 3>& facet : surface.facets)
    result += normal_of(facet, surface.points).norm() / 2;
  return result;
}

// Map of a triangulated sphere onto another one, by directions in the sphere that both are mapped to. There, each triangle is
// positive. Its edges can be split.
class Surface_map_3
{
public:
  using Edge = std::array<std::size_t, 2>;

  Surface_map_3(const Numbered_surface_3& surface, const Surface_on_sphere_3& target, std::vector<Eigen::Vector3d> directions)
    : m_target(&target), m_directions(std::move(directions))
  {
    for(const Facet& facet : surface.facets)
      set_facet(m_facets.size(), facet);
    for(const Eigen::Vector3d& d : m_directions)
      m_images.push_back(target.point_in_direction(d));
  }

  const std::vector<Eigen::Vector3d>& images() const { return m_images; }
  const std::vector<Edge>& splits() const { return m_splits; }

  // Returns the mean symmetric Dirichlet energy of the map of the surface, scaled to the area of the target. Triangles count
  // up to a bound, because images may be flat.
  double distortion(const Numbered_surface_3& surface, const double scale) const
  {
    constexpr double bound = 1000; // a guess
    double sum = 0, area = 0;
    for(const Facet& facet : surface.facets)
    {
      const double a = normal_of(facet, surface.points).norm(), b = normal_of(facet, m_images).norm() / scale;
      double dirichlet = 0;
      for(int i = 0; i < 3; ++i)
      {
        const std::size_t u = facet[i], v = facet[(i + 1) % 3], w = facet[(i + 2) % 3];
        dirichlet += (surface.points[v] - surface.points[u]).dot(surface.points[w] - surface.points[u]) / (a * scale)
                   * (m_images[v] - m_images[w]).squaredNorm();
      }
      const double energy = dirichlet * (1 + a * a / (b * b));
      sum += energy < bound * a ? energy : bound * a;
      area += a;
    }
    return sum / area;
  }

  // Returns the facets that intersect others, or whose normals are opposite to that of the target.
  std::vector<std::size_t> bad_facets() const
  {
    Numbered_surface_3 surface;
    surface.points = m_images;
    surface.facets = m_facets;
    Boundary_mesh_3 image;
    build_boundary_mesh_3(surface, image);
    std::vector<std::pair<Boundary_mesh_3::Face_index, Boundary_mesh_3::Face_index> > pairs;
    Polygon_mesh_processing::self_intersections(image, std::back_inserter(pairs));
    std::vector<bool> is_bad(m_facets.size(), false);
    for(const auto& [f, g] : pairs)
      is_bad[f] = is_bad[g] = true;
    std::vector<std::size_t> result;
    for(std::size_t f = 0; f < m_facets.size(); ++f)
      if(is_bad[f] || is_turned(m_facets[f]))
        result.push_back(f);
    return result;
  }

  // Splits an edge of each of these facets if there is a vertex of the target inside, or an edge of the target that one of its
  // edges crosses. The new vertex is put there. Parts of facets that are in one triangle of the target are neither turned nor
  // intersected. Returns whether any edge is split.
  bool split(const std::vector<std::size_t>& facets)
  {
    const std::vector<Facet> before = m_facets;
    const std::size_t number_of_splits = m_splits.size();
    for(const std::size_t f : facets)
      if(m_facets[f] == before[f] && !split_at_vertex(m_facets[f]))
        split_at_edge(m_facets[f]);
    return m_splits.size() > number_of_splits;
  }

private:
  using Facet = std::array<std::size_t, 3>;

  bool is_turned(const Facet& facet) const
  {
    const Eigen::Vector3d center = m_directions[facet[0]] + m_directions[facet[1]] + m_directions[facet[2]];
    return m_target->normal_in_direction(center).dot(normal_of(facet, m_images)) <= 0;
  }

  bool split_at_vertex(const Facet& facet)
  {
    const Eigen::Vector3d &a = m_directions[facet[0]], &b = m_directions[facet[1]], &c = m_directions[facet[2]];
    for(const Eigen::Vector3d& d : m_target->directions())
      if(d.dot(a.cross(b)) > 0 && d.dot(b.cross(c)) > 0 && d.dot(c.cross(a)) > 0)
        for(const Edge& edge : edges_by_length(facet))
          if(split(edge, d))
            return true;
    return false;
  }

  bool split_at_edge(const Facet& facet)
  {
    for(const Edge& edge : edges_by_length(facet))
      if(const std::optional<Eigen::Vector3d> crossing = middle_crossing(edge); crossing && split(edge, *crossing))
        return true;
    return false;
  }

  // Returns the edges of a facet, the ones with the longest images first.
  std::array<Edge, 3> edges_by_length(const Facet& facet) const
  {
    std::array<Edge, 3> result = {{ { facet[0], facet[1] }, { facet[1], facet[2] }, { facet[2], facet[0] } }};
    const auto length = [&](const Edge& e) { return (m_images[e[0]] - m_images[e[1]]).squaredNorm(); };
    std::sort(result.begin(), result.end(), [&](const Edge& d, const Edge& e) { return length(d) > length(e); });
    return result;
  }

  // Returns the crossing with an edge of the target that is next to the middle, and not almost at an end.
  std::optional<Eigen::Vector3d> middle_crossing(const Edge& edge) const
  {
    constexpr double smallest_part = 1e-3, smallest_distance = 1e-10; // guesses
    const Eigen::Vector3d &p = m_directions[edge[0]], &q = m_directions[edge[1]], normal = p.cross(q);
    std::optional<Eigen::Vector3d> result;
    double best = smallest_part;
    for(const auto& [a, b] : m_target->edges())
    {
      const double above = normal.dot(a), below = normal.dot(b);
      const bool ends_on_edge = (std::min)(std::abs(above), std::abs(below)) < smallest_distance * normal.norm();
      if((above > 0) == (below > 0) || ends_on_edge) // rounding decides on which side such an end is
        continue;
      const Eigen::Vector3d crossing = ((above * b - below * a) / (above - below)).normalized();
      const Eigen::Vector3d across = normal.cross(p), along = q.cross(normal);
      const double from_p = across.dot(crossing), from_q = along.dot(crossing); // proportional to the sines of the distances
      const double part = (std::min)(from_p, from_q) / (from_p + from_q);
      if(crossing.dot(p + q) > 0 && from_p > 0 && from_q > 0 && part > best)
      {
        best = part;
        result = crossing;
      }
    }
    return result;
  }

  // Splits an edge with the new vertex in a direction, unless a triangle would not be positive.
  bool split(const Edge& edge, const Eigen::Vector3d& direction)
  {
    const auto [u, v] = edge;
    const std::size_t m = m_directions.size(), f = m_facet_of_edge.at({ u, v }), g = m_facet_of_edge.at({ v, u });
    const std::size_t x = opposite_vertex(f, edge), y = opposite_vertex(g, edge);
    const std::array<Facet, 4> facets = {{ { u, m, x }, { m, v, x }, { m, u, y }, { v, m, y } }};
    m_directions.push_back(direction);
    if(!std::all_of(facets.begin(), facets.end(), [&](const Facet& t)
       { return radial_orientation(m_directions[t[0]], m_directions[t[1]], m_directions[t[2]]) == POSITIVE; }))
    {
      m_directions.pop_back();
      return false;
    }
    m_images.push_back(m_target->point_in_direction(direction));
    m_splits.push_back(edge);
    m_facet_of_edge.erase({ u, v });
    m_facet_of_edge.erase({ v, u });
    set_facet(f, facets[0]);
    set_facet(g, facets[2]);
    set_facet(m_facets.size(), facets[1]);
    set_facet(m_facets.size(), facets[3]);
    return true;
  }

  std::size_t opposite_vertex(const std::size_t facet, const Edge& edge) const
  {
    const auto& [a, b, c] = m_facets[facet];
    return a + b + c - edge[0] - edge[1];
  }

  void set_facet(const std::size_t f, const Facet& facet)
  {
    if(f == m_facets.size())
      m_facets.push_back(facet);
    m_facets[f] = facet;
    for(int i = 0; i < 3; ++i)
      m_facet_of_edge[{ facet[i], facet[(i + 1) % 3] }] = f;
  }

  std::vector<Facet> m_facets;
  std::map<Edge, std::size_t> m_facet_of_edge; // on its left, as seen from outside
  const Surface_on_sphere_3* m_target;
  std::vector<Eigen::Vector3d> m_directions, m_images;
  std::vector<Edge> m_splits;
};

// Center, size and principal axes of the body that a surface encloses.
struct Moments_3
{
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double size = 0;
  Eigen::Matrix3d axes; // columns of a rotation, by ascending moments

  explicit Moments_3(const Numbered_surface_3& surface)
  {
    const Eigen::Vector3d origin = surface.points[0];
    double volume = 0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for(const auto& facet : surface.facets)
    {
      const Eigen::Vector3d a = surface.points[facet[0]] - origin, b = surface.points[facet[1]] - origin,
                            c = surface.points[facet[2]] - origin, sum = a + b + c;
      const double part = a.dot(b.cross(c)) / 6;
      volume += part;
      first += part * sum / 4;
      second += part / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
    }
    first /= volume;
    center = origin + first;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second / volume - first * first.transpose());
    axes = solver.eigenvectors();
    axes.col(2) *= axes.determinant() < 0 ? -1 : 1;
    size = std::sqrt(solver.eigenvalues().sum());
  }
};

inline int nearest_vertex(const Numbered_surface_3& surface, const Eigen::Vector3d& p)
{
  const auto nearest = std::min_element(surface.points.begin(), surface.points.end(), [&](const auto& q, const auto& r)
  { return (q - p).squaredNorm() < (r - p).squaredNorm(); });
  return static_cast<int>(nearest - surface.points.begin());
}

// Turns of the sphere of a body that may fit the body to a target: principal axes are put on principal axes, whose signs are
// open. In each of them, the direction of a vertex is turned close to that of the nearest point of the target.
inline std::vector<std::vector<Eigen::Vector3d> > turned_by_moments_3(const Numbered_surface_3& surface,
                                                                      const std::vector<Eigen::Vector3d>& directions,
                                                                      const Numbered_surface_3& target,
                                                                      const Surface_on_sphere_3& on_sphere)
{
  const Moments_3 of_surface(surface), of_target(target);
  std::vector<std::vector<Eigen::Vector3d> > result;
  for(const auto& [x, y] : { std::pair(1, 1), { 1, -1 }, { -1, 1 }, { -1, -1 } })
  {
    const Eigen::Matrix3d turn = of_target.axes * Eigen::Vector3d(x, y, x * y).asDiagonal() * of_surface.axes.transpose()
                               * (of_target.size / of_surface.size);
    std::vector<std::pair<int, Eigen::Vector3d> > pairs;
    for(std::size_t v = 0; v < surface.points.size(); ++v)
    {
      const Eigen::Vector3d p = of_target.center + turn * (surface.points[v] - of_surface.center);
      pairs.emplace_back(static_cast<int>(v), on_sphere.direction_of_nearest_point(p));
    }
    result.push_back(directions);
    turn_to_landmarks_3(pairs, result.back());
  }
  return result;
}


// Points of a body, each with the point of a target that it should be near to.
using Point_pairs_3 = std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d> >;

// Returns the sphere of a body, turned in one or several ways that may fit the body to a target.
inline std::vector<std::vector<Eigen::Vector3d> > turned_spheres_3(const Numbered_surface_3& surface,
                                                                   const std::vector<Eigen::Vector3d>& directions,
                                                                   const Numbered_surface_3& target,
                                                                   const Surface_on_sphere_3& on_sphere,
                                                                   const Point_pairs_3& landmarks)
{
  if(landmarks.empty())
    return turned_by_moments_3(surface, directions, target, on_sphere);
  std::vector<std::pair<int, Eigen::Vector3d> > pairs;
  for(const auto& [p, q] : landmarks)
    pairs.emplace_back(nearest_vertex(surface, p), on_sphere.direction_of_nearest_point(q));
  std::vector<Eigen::Vector3d> turned = directions;
  turn_to_landmarks_3(pairs, turned);
  return { turned };
}

// Images of a surface, with edges of it split one after the other. They lie on the target.
struct Surface_images_3
{
  Error_code status = OK;
  std::vector<Surface_map_3::Edge> splits = {};
  std::vector<Eigen::Vector3d> images = {};
};

// Splits edges until no facet intersects another one, and none is turned over. Returns false if this needs too many splits.
inline bool split_until_embedded_3(Surface_map_3& map, const std::size_t maximum_number_of_splits, const Budget& budget)
{
  for(;;)
  {
    const std::vector<std::size_t> bad = map.bad_facets();
    if(bad.empty())
      return true;
    if(!budget.may_begin_round(Phase::BOUNDARY, "splits on a surface") || map.splits().size() > maximum_number_of_splits
       || !map.split(bad))
      return false;
  }
}

// Maps a triangulated sphere onto another one. If edges may be split, no facet intersects another one, and none is turned over.
inline Surface_images_3 map_to_surface_3(const Numbered_surface_3& surface, const Numbered_surface_3& target,
                                         const Point_pairs_3& landmarks, const bool may_split, const Budget& budget)
{
  for(const auto& [p, q] : landmarks)
    if(!p.allFinite() || !q.allFinite())
      return { ERROR_INVALID_LANDMARK };
  std::vector<Eigen::Vector3d> directions, directions_of_target;
  if(const Error_code status = map_to_sphere_3(surface, {}, directions, budget); status != OK)
    return { status };
  if(map_to_sphere_3(target, {}, directions_of_target, budget) != OK)
    return { ERROR_TARGET_NOT_A_SPHERE };
  const Surface_on_sphere_3 on_sphere(target, directions_of_target);
  const double scale = area_of(target) / area_of(surface);
  std::optional<Surface_map_3> map;
  for(std::vector<Eigen::Vector3d>& turned : turned_spheres_3(surface, directions, target, on_sphere, landmarks))
  {
    Surface_map_3 candidate(surface, on_sphere, std::move(turned));
    if(!map || candidate.distortion(surface, scale) < map->distortion(surface, scale))
      map = std::move(candidate);
  }
  constexpr std::size_t splits_per_vertex = 4; // a guess
  if(may_split && !split_until_embedded_3(*map, splits_per_vertex * (surface.points.size() + target.points.size()), budget))
    return { ERROR_BOUNDARY_TOO_COARSE };
  return { OK, map->splits(), map->images() };
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_MAP_TO_SURFACE_3_H
