// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_SURFACE_RELAXATION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_SURFACE_RELAXATION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/Radial_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/matched_features_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Map of a triangulated sphere onto another one. Vertices move on the target to lower the distortion of their triangles, and
// towards their goals. In the sphere that both surfaces are mapped to, triangles remain positive. Vertices of features go to these
// as soon as this allows it, and others to their regions.
//
// The distortion of a triangle is Q (1 + 1 / X^2), with its Dirichlet energy Q. X is the ratio of the areas, made positive as for
// untangling, X = (D + sqrt(D^2 + e^2)) / 2. D is negative where the image is turned over.
class Surface_relaxation_3
{
public:
  Surface_relaxation_3(const std::vector<Vector_3>& points, const Vertex_rings_3& rings, const Surface_on_sphere_3& target,
                       const std::vector<Vector_3>& directions, const double epsilon, const Goals_3& goals,
                       const Held_features_3& held)
    : m_points(points), m_rings(rings), m_target(target), m_epsilon(epsilon), m_goals(goals), m_held(held)
  {
    for(const Vector_3& d : directions)
      m_positions.push_back(target.position_in_direction(d));
  }

  void relax(const int number_of_sweeps, const Budget& budget)
  {
    for(int i = 0; i < number_of_sweeps && budget.may_begin_round(Phase::BOUNDARY, "relaxation on a surface"); ++i)
      for(int v = 0; v < m_rings.number_of_vertices(); ++v)
        relax(v);
  }

  double distortion() const
  {
    double result = 0;
    for(int v = 0; v < m_rings.number_of_vertices(); ++v)
      result += distortion(v, m_positions[v]);
    return result;
  }

  const std::vector<Surface_position_3>& positions() const { return m_positions; }

private:
  template <typename Function>
  void for_each_triangle(const int v, const Function& function) const
  {
    const std::vector<int>& ring = m_rings[v];
    for(std::size_t i = 0; i < ring.size(); ++i)
      function(ring[i], ring[(i + 1) % ring.size()]);
  }

  // Returns twice the area of an image, negative if it is turned over against the normals at its vertices.
  static double double_area(const Surface_position_3& a, const Surface_position_3& b, const Surface_position_3& c)
  { return (a.normal + b.normal + c.normal).normalized().dot((b.point - a.point).cross(c.point - a.point)); }

  bool is_admissible(const int v, const Vector_3& direction) const
  {
    bool result = true;
    for_each_triangle(v, [&](const int b, const int c)
    {
      result = result && radial_orientation(direction, m_positions[b].direction, m_positions[c].direction) == POSITIVE;
    });
    return result;
  }

  bool move(const int v, const Surface_position_3& position)
  {
    const bool result = is_admissible(v, position.direction);
    if(result)
      m_positions[v] = position;
    return result;
  }

  // Returns the part of the target in which a vertex stays. A vertex outside of it goes to the mean of its neighbors first.
  const Surface_on_sphere_3& target_of(const int v)
  {
    constexpr double rounding = 1e-9; // the target has about the size 1
    const Surface_on_sphere_3* const region = m_held.region(v);
    if(region == nullptr || (region->nearest_position(m_positions[v].point).point - m_positions[v].point).norm() < rounding)
      return region == nullptr ? m_target : *region;
    Vector_3 sum = Vector_3::Zero();
    for(const int w : m_rings[v])
      sum += m_positions[w].point;
    return move(v, region->nearest_position(sum / static_cast<double>(m_rings[v].size()))) ? *region : m_target;
  }

  void relax(const int v)
  {
    if(const Surface_position_3* const held = m_held.position(v))
    {
      move(v, *held);
      return;
    }
    const Surface_on_sphere_3& target = target_of(v);
    Vector_3 gradient = Vector_3::Zero();
    Matrix_3 hessian = Matrix_3::Zero();
    const double before = distortion(v, m_positions[v], &gradient, &hessian);
    const Vector_3 normal = m_positions[v].normal;
    const Matrix_3 along = Matrix_3::outer_product(normal, normal), in_plane = Matrix_3::Identity() - along;
    const Vector_3 step = -((in_plane * hessian * in_plane + hessian.trace() * along).inverse() * (in_plane * gradient));
    if(!step.allFinite())
      return;
    constexpr double smallest = 0.01; // a guess
    for(double length = 1; length > smallest; length /= 3)
    {
      const Surface_position_3 candidate = target.nearest_position(m_positions[v].point + length * step);
      if(distortion(v, candidate) < before && move(v, candidate))
        return;
    }
  }

  // Returns the distortion around v with a position of v. Adds the gradient and a positive approximation of the Hessian.
  double distortion(const int v, const Surface_position_3& position, Vector_3* gradient = nullptr,
                    Matrix_3* hessian = nullptr) const
  {
    double result = 0;
    if(const auto goal = m_goals.find(v); goal != m_goals.end())
    {
      constexpr double weight = 100; // a guess; the distortion around a vertex is about as stiff as 10
      const Vector_3 offset = position.point - goal->second;
      result = weight * offset.squaredNorm();
      if(gradient != nullptr)
      {
        *gradient += 2 * weight * offset;
        *hessian += 2 * weight * Matrix_3::Identity();
      }
    }
    for_each_triangle(v, [&](const int j, const int k)
    {
      const Vector_3 &p = m_points[v], &q = m_points[j], &r = m_points[k];
      double pq = (q - p).squaredNorm(), qr = (r - q).squaredNorm(), rp = (p - r).squaredNorm();
      const double regular = 1e-6 * (pq + qr + rp); // gives a flat triangle a positive area; the size is a guess
      pq += regular;
      qr += regular;
      rp += regular;
      const double area = std::sqrt(2 * (pq * qr + qr * rp + rp * pq) - (pq * pq + qr * qr + rp * rp)) / 4;
      const double at_a = (pq + rp - qr) / (4 * area), at_b = (pq + qr - rp) / (4 * area), at_c = (qr + rp - pq) / (4 * area);
      const Vector_3 &a = position.point, &b = m_positions[j].point, &c = m_positions[k].point;
      const double dirichlet = (at_a * (b - c).squaredNorm() + at_b * (a - c).squaredNorm() + at_c * (a - b).squaredNorm()) / 2;
      const double d = double_area(position, m_positions[j], m_positions[k]) / (2 * area);
      const double root = std::sqrt(d * d + m_epsilon * m_epsilon), x = (d + root) / 2, slope = x / root;
      result += dirichlet * (1 + 1 / (x * x));
      if(gradient == nullptr)
        return;
      const Vector_3 normal = (position.normal + m_positions[j].normal + m_positions[k].normal).normalized();
      const Vector_3 x_gradient = slope * normal.cross(c - b) / (2 * area);
      *gradient += (1 + 1 / (x * x)) * (at_b * (a - c) + at_c * (a - b)) - 2 * dirichlet / (x * x * x) * x_gradient;
      *hessian += (1 + 1 / (x * x)) * (at_b + at_c) * Matrix_3::Identity()
                + 6 * dirichlet / (x * x * x * x) * Matrix_3::outer_product(x_gradient, x_gradient);
    });
    return result;
  }

  const std::vector<Vector_3>& m_points;
  const Vertex_rings_3& m_rings;
  const Surface_on_sphere_3& m_target;
  double m_epsilon; // e
  const Goals_3& m_goals;
  const Held_features_3& m_held;
  std::vector<Surface_position_3> m_positions;
};

// A triangulated sphere, mapped one to one to the unit sphere.
struct Surface_in_sphere_3
{
  const Numbered_surface_3* surface;
  const Vertex_rings_3* rings;
  std::vector<Vector_3> directions;
};

// Two surfaces in one sphere. There, each vertex of one surface is in a triangle of the other one, which is its image.
struct Surface_pair_3
{
  Surface_in_sphere_3 surface, target;
  std::vector<Vector_3> images = {}; // of the vertices of `surface`
  double distortion = 0; // of the images
  Goals_3 goals = {}; // of vertices of `surface`
  Matched_features_3 features = {};
  bool holds_features = false; // otherwise, they are goals

  // Moves the vertices of the surface on the target.
  void relax(const int number_of_sweeps, const double epsilon, const Budget& budget)
  {
    const Surface_on_sphere_3 on_sphere(target.surface->points, target.surface->facets, target.directions);
    Goals_3 all_goals = goals;
    all_goals.insert(features.points.begin(), features.points.end());
    const Held_features_3 held(surface.surface->facets, holds_features ? features : Matched_features_3(), target.surface->facets,
                               on_sphere);
    Surface_relaxation_3 map(surface.surface->points, *surface.rings, on_sphere, surface.directions, epsilon, all_goals, held);
    map.relax(number_of_sweeps, budget);
    distortion = map.distortion();
    images.clear();
    surface.directions.clear();
    for(const Surface_position_3& position : map.positions())
    {
      images.push_back(position.point);
      surface.directions.push_back(position.direction);
    }
  }

  // Brings vertices to their goals, if there are any.
  void relax_to_goals(const double epsilon, const Budget& budget)
  {
    constexpr int number_of_sweeps = 20; // a guess
    if(!goals.empty() || !features.points.empty())
      relax(number_of_sweeps, epsilon, budget);
  }

  // Moves the vertices of a fitted surface such that the distortion becomes nearly the true one.
  void sharpen(const Budget& budget)
  {
    constexpr int number_of_sweeps = 15; // a guess
    constexpr double sharp = 0.01;       // a guess for e
    relax(number_of_sweeps, sharp, budget);
  }

  // Moves the vertices of each surface on the other one. Where a few triangles of the surface cover a limb of the target, only the
  // triangles of the limb are distorted: their vertices spread out, such that more vertices of the surface get there.
  void relax_both(const int number_of_sweeps, const double epsilon, const Budget& budget)
  {
    Surface_pair_3 inverse = { target, surface };
    inverse.relax(number_of_sweeps, epsilon, budget);
    target = inverse.surface;
    relax(number_of_sweeps, epsilon, budget);
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_SURFACE_RELAXATION_3_H
