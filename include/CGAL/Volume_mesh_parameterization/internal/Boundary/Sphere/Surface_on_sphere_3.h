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

// Triangulated surface with a map onto the unit sphere around the origin. The map is one to one.
class Surface_on_sphere_3
{
public:
  Surface_on_sphere_3(const Numbered_surface_3& surface, const std::vector<Eigen::Vector3d>& directions)
    : m_surface(surface), m_directions(directions), m_triangles(triangles(surface.points)),
      m_triangles_in_sphere(triangles(directions)), m_tree(m_triangles.cbegin(), m_triangles.cend()),
      m_tree_in_sphere(m_triangles_in_sphere.cbegin(), m_triangles_in_sphere.cend())
  {
    m_tree.accelerate_distance_queries();
    for(const auto& [a, b, c] : surface.facets)
      for(const auto& [v, w] : { std::pair(a, b), { b, c }, { c, a } })
        if(v < w)
          m_edges.push_back({ directions[v], directions[w] });
  }

  Surface_on_sphere_3(const Surface_on_sphere_3&) = delete; // the trees refer to the triangles
  Surface_on_sphere_3& operator=(const Surface_on_sphere_3&) = delete;

  const std::vector<Eigen::Vector3d>& directions() const { return m_directions; } // of the vertices

  // Edges by the directions of their ends, each once.
  const std::vector<std::array<Eigen::Vector3d, 2> >& edges() const { return m_edges; }

  Eigen::Vector3d direction_of_nearest_point(const Eigen::Vector3d& p) const
  {
    const auto [nearest, primitive] = m_tree.closest_point_and_primitive(kernel_point(p));
    const std::size_t facet = static_cast<std::size_t>(primitive - m_triangles.cbegin());
    const auto [a, b, c] = corners(facet, m_surface.points);
    const Eigen::Vector3d q(nearest.x(), nearest.y(), nearest.z()), normal = (b - a).cross(c - a);
    return mean(facet, { (b - q).cross(c - q).dot(normal), (c - q).cross(a - q).dot(normal), (a - q).cross(b - q).dot(normal) },
                m_directions).normalized();
  }

  Eigen::Vector3d point_in_direction(const Eigen::Vector3d& d) const
  {
    const std::size_t facet = facet_in_direction(d);
    const auto [a, b, c] = corners(facet, m_directions);
    return mean(facet, { d.dot(b.cross(c)), d.dot(c.cross(a)), d.dot(a.cross(b)) }, m_surface.points);
  }

  Eigen::Vector3d normal_in_direction(const Eigen::Vector3d& d) const
  {
    const auto [a, b, c] = corners(facet_in_direction(d), m_surface.points);
    return (b - a).cross(c - a);
  }

private:
  using Kernel = AABB_trees_3::Kernel;
  using Triangles = AABB_trees_3::Triangles;

  static Kernel::Point_3 kernel_point(const Eigen::Vector3d& p) { return Kernel::Point_3(p[0], p[1], p[2]); }

  std::array<Eigen::Vector3d, 3> corners(const std::size_t facet, const std::vector<Eigen::Vector3d>& points) const
  {
    const auto& [a, b, c] = m_surface.facets[facet];
    return { points[a], points[b], points[c] };
  }

  Triangles triangles(const std::vector<Eigen::Vector3d>& points) const
  {
    Triangles result;
    for(std::size_t f = 0; f < m_surface.facets.size(); ++f)
    {
      const auto [a, b, c] = corners(f, points);
      result.emplace_back(kernel_point(a), kernel_point(b), kernel_point(c));
    }
    return result;
  }

  // The predicates of the tree are exact, and a ray from inside the polyhedron meets it.
  std::size_t facet_in_direction(const Eigen::Vector3d& d) const
  {
    const auto primitive = m_tree_in_sphere.any_intersected_primitive(Kernel::Ray_3(Kernel::Point_3(0, 0, 0), kernel_point(d)));
    return static_cast<std::size_t>(*primitive - m_triangles_in_sphere.cbegin());
  }

  // Returns the mean of the corners of a facet. Rounding can make weights negative.
  Eigen::Vector3d mean(const std::size_t facet, const std::array<double, 3>& weights,
                       const std::vector<Eigen::Vector3d>& points) const
  {
    const std::array<Eigen::Vector3d, 3> corner = corners(facet, points);
    double sum = 0;
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for(int i = 0; i < 3; ++i)
    {
      sum += (std::max)(weights[i], 0.);
      result += (std::max)(weights[i], 0.) * corner[i];
    }
    return sum > 0 ? Eigen::Vector3d(result / sum) : corner[0];
  }

  const Numbered_surface_3& m_surface;
  const std::vector<Eigen::Vector3d>& m_directions;
  std::vector<std::array<Eigen::Vector3d, 2> > m_edges;
  Triangles m_triangles, m_triangles_in_sphere;
  AABB_trees_3::Of_triangles m_tree, m_tree_in_sphere;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_SPHERE_SURFACE_ON_SPHERE_3_H
