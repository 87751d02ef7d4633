// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_SURFACE_ON_SPHERE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_SURFACE_ON_SPHERE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/AABB_trees_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

inline Vector_3 normal_of(const std::array<std::size_t, 3>& facet, const std::vector<Vector_3>& points)
{ return (points[facet[1]] - points[facet[0]]).cross(points[facet[2]] - points[facet[0]]); }

// Point of a surface, with its direction in the sphere and a normal. Normals are continuous over the surface.
struct Surface_position_3
{
  Vector_3 point, direction, normal;
};

// Triangulated surface, or a part of it, with a map onto the unit sphere around the origin. The map is one to one.
class Surface_on_sphere_3
{
public:
  using Facets = std::vector<std::array<std::size_t, 3> >;

  Surface_on_sphere_3(const std::vector<Vector_3>& points, const Facets& facets, const std::vector<Vector_3>& directions)
    : m_points(points), m_directions(directions), m_normals(points.size(), Vector_3::Zero()), m_facets(facets)
  {
    for(const auto& facet : facets)
    {
      const Vector_3 normal = normal_of(facet, points);
      for(const std::size_t v : facet)
        m_normals[v] += normal;
      m_triangles_in_sphere.push_back(triangle(facet, directions));
      if(const Kernel::Triangle_3 t = triangle(facet, points); !t.is_degenerate())
      {
        m_triangles.push_back(t);
        m_facets_with_area.push_back(facet);
      }
    }
    for(Vector_3& normal : m_normals)
      normal = normal.normalized();
    m_tree.rebuild(m_triangles.cbegin(), m_triangles.cend());
    m_tree.accelerate_distance_queries();
    m_tree_in_sphere.rebuild(m_triangles_in_sphere.cbegin(), m_triangles_in_sphere.cend());
  }

  // Takes some facets of a whole surface. Normals at their border are those of these facets.
  Surface_on_sphere_3(const Surface_on_sphere_3& whole, const Facets& facets)
    : Surface_on_sphere_3(whole.m_points, facets, whole.m_directions)
  {}

  Surface_on_sphere_3(const Surface_on_sphere_3&) = delete; // the trees refer to the triangles
  Surface_on_sphere_3& operator=(const Surface_on_sphere_3&) = delete;

  Surface_position_3 nearest_position(const Vector_3& p) const
  {
    const auto [nearest, primitive] = m_tree.closest_point_and_primitive(kernel_point(p));
    const Facet& facet = m_facets_with_area[static_cast<std::size_t>(primitive - m_triangles.cbegin())];
    const Vector_3 q(nearest.x(), nearest.y(), nearest.z()), normal = normal_of(facet, m_points);
    return position(facet, m_points, [&](const Vector_3& a, const Vector_3& b)
    { return (a - q).cross(b - q).dot(normal); });
  }

  // The predicates of the tree are exact, and a ray from inside the polyhedron meets it.
  std::size_t facet_in_direction(const Vector_3& d) const
  {
    const auto primitive = m_tree_in_sphere.any_intersected_primitive(Kernel::Ray_3(kernel_point({ 0, 0, 0 }), kernel_point(d)));
    return static_cast<std::size_t>(*primitive - m_triangles_in_sphere.cbegin());
  }

  Surface_position_3 position_in_direction(const Vector_3& d) const
  {
    return position(m_facets[facet_in_direction(d)], m_directions,
                    [&](const Vector_3& a, const Vector_3& b) { return a.cross(b).dot(d); });
  }

private:
  using Kernel = AABB_trees_3::Kernel;
  using Facet = std::array<std::size_t, 3>;

  static Kernel::Point_3 kernel_point(const Vector_3& p) { return Kernel::Point_3(p[0], p[1], p[2]); }

  static Kernel::Triangle_3 triangle(const Facet& facet, const std::vector<Vector_3>& points)
  { return Kernel::Triangle_3(kernel_point(points[facet[0]]), kernel_point(points[facet[1]]), kernel_point(points[facet[2]])); }

  // Returns the mean of the corners, each weighted by the area opposite to it. Rounding can make areas negative.
  template <typename Area>
  Surface_position_3 position(const Facet& facet, const std::vector<Vector_3>& points, const Area& area) const
  {
    Vector_3 weights;
    for(int i = 0; i < 3; ++i)
      weights[i] = (std::max)(area(points[facet[(i + 1) % 3]], points[facet[(i + 2) % 3]]), 0.);
    weights = weights.sum() > 0 ? weights / weights.sum() : Vector_3::Unit(0);
    const auto mean = [&](const std::vector<Vector_3>& values)
    { return weights[0] * values[facet[0]] + weights[1] * values[facet[1]] + weights[2] * values[facet[2]]; };
    return { mean(m_points), mean(m_directions).normalized(), mean(m_normals).normalized() };
  }

  const std::vector<Vector_3>& m_points;
  const std::vector<Vector_3>& m_directions;
  std::vector<Vector_3> m_normals;
  Facets m_facets, m_facets_with_area;
  AABB_trees_3::Triangles m_triangles, m_triangles_in_sphere;
  AABB_trees_3::Of_triangles m_tree, m_tree_in_sphere;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_SURFACE_ON_SPHERE_3_H
