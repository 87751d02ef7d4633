// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_BODY_SURFACE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_BODY_SURFACE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Bbox_3.h>

#include <Eigen/Dense>

#include <cmath>
#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Freedom of a vertex: anywhere, on the surface, along a line, or not at all.
enum class Freedom_3 { SPACE, SURFACE, LINE, NONE };

// Boundary of a body that is mapped to a domain whose facets are orthogonal to the axes, and its lines: the sharp edges that
// are mapped to edges of the domain.
class Body_surface_3
{
public:
  Body_surface_3(const std::vector<std::array<double, 3> >& points, const std::vector<std::array<std::size_t, 4> >& cells,
                 const std::vector<std::array<double, 3> >& images)
    : m_facets(boundary_facets_3(cells))
  {
    std::vector<std::array<std::size_t, 2> > lines;
    for_each_edge(m_facets, [&](const auto begin, const auto end)
    {
      const std::array<std::size_t, 3>&f = m_facets[begin->second[0] / 3], &g = m_facets[(end - 1)->second[0] / 3];
      if(is_sharp(points, f, g) && is_sharp(images, f, g))
        lines.push_back(begin->first);
    });
    build(points, lines);
  }

  // Takes any facets, and edges as lines.
  Body_surface_3(const std::vector<std::array<double, 3> >& points, std::vector<std::array<std::size_t, 3> > facets,
                 const std::vector<std::array<std::size_t, 2> >& lines)
    : m_facets(std::move(facets))
  { build(points, lines); }

  // Tells whether the edge between two facets that are oriented alike is sharp.
  static bool is_sharp(const std::vector<std::array<double, 3> >& points, const std::array<std::size_t, 3>& f,
                       const std::array<std::size_t, 3>& g)
  {
    constexpr double cosine_of_sharp_edge = 0.5; // a guess; 60 degrees between normals
    return normal(triangle(points, f)).dot(normal(triangle(points, g))) < cosine_of_sharp_edge;
  }

  const std::vector<Eigen::Vector3d>& vertices() const { return m_vertices; }

  // Returns the freedom of a vertex by the number of planes of the boundary of the domain that its image is on. The image may be
  // on an edge or in a corner: the vertex is held there only if the body has a line there, too.
  Freedom_3 freedom(const Eigen::Vector3d& p, const int number_of_planes) const
  {
    if(number_of_planes == 0)
      return Freedom_3::SPACE;
    return number_of_planes == 1 || !is_on_line(p) ? Freedom_3::SURFACE : number_of_planes == 2 ? Freedom_3::LINE : Freedom_3::NONE;
  }

  bool is_on_line(const Eigen::Vector3d& p) const
  { return !m_segments.empty() && m_lines.squared_distance(exact_point(p)) <= m_rounding * m_rounding; }

  bool has_lines() const { return !m_segments.empty(); }

  // Returns the point nearest to p among those where a vertex may be.
  Eigen::Vector3d nearest(const Eigen::Vector3d& p, const Freedom_3 freedom) const
  {
    return freedom == Freedom_3::SURFACE ? to_vector(m_surface.closest_point(exact_point(p)))
         : freedom == Freedom_3::LINE ? to_vector(m_lines.closest_point(exact_point(p))) : p;
  }

  // Returns the vertices of the facet nearest to a point.
  const std::array<std::size_t, 3>& nearest_facet(const Eigen::Vector3d& p) const
  { return m_facets[m_surface.closest_point_and_primitive(exact_point(p)).second - m_triangles.begin()]; }

  // Returns the normal of the facet nearest to a point.
  Eigen::Vector3d normal(const Eigen::Vector3d& p) const
  { return normal(*m_surface.closest_point_and_primitive(exact_point(p)).second); }

  // Returns the distance of a point from the box around the surface, a bound of that from the surface.
  double distance_of_box(const Eigen::Vector3d& p) const
  {
    const Bbox_3 box = m_surface.bbox();
    return (Eigen::Vector3d(box.xmin(), box.ymin(), box.zmin()) - p).cwiseMax(p - Eigen::Vector3d(box.xmax(), box.ymax(), box.zmax()))
           .cwiseMax(0).norm();
  }

  // Returns the projector onto the directions in which a vertex may move from a point where it may be.
  Eigen::Matrix3d projector(const Eigen::Vector3d& p, const Freedom_3 freedom) const
  {
    if(freedom == Freedom_3::SURFACE)
    {
      const Eigen::Vector3d n = normal(p);
      return Eigen::Matrix3d::Identity() - n * n.transpose();
    }
    if(freedom == Freedom_3::LINE)
    {
      const Eigen::Vector3d d
        = to_vector(m_lines.closest_point_and_primitive(exact_point(p)).second->to_vector()).stableNormalized();
      return d * d.transpose();
    }
    return Eigen::Matrix3d::Identity() * (freedom == Freedom_3::SPACE ? 1 : 0);
  }

private:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Segments = std::vector<Kernel::Segment_3>;
  template <typename Primitive>
  using Tree = AABB_tree<AABB_traits<Kernel, Primitive> >;

  void build(const std::vector<std::array<double, 3> >& points, const std::vector<std::array<std::size_t, 2> >& lines)
  {
    std::set<std::size_t> vertices;
    for(const std::array<std::size_t, 3>& facet : m_facets)
    {
      m_triangles.push_back(triangle(points, facet));
      vertices.insert(facet.begin(), facet.end());
    }
    for(const std::size_t v : vertices)
      m_vertices.push_back(to_vector(points[v]));
    for(const auto& [v, w] : lines)
      m_segments.emplace_back(exact_point(points[v]), exact_point(points[w]));
    m_surface.rebuild(m_triangles.begin(), m_triangles.end());
    m_surface.accelerate_distance_queries();
    m_lines.rebuild(m_segments.begin(), m_segments.end());
    const Bbox_3 box = m_surface.bbox();
    m_rounding = 1e-9 * std::hypot(box.x_span(), box.y_span(), box.z_span());
  }

  static Kernel::Triangle_3 triangle(const std::vector<std::array<double, 3> >& points, const std::array<std::size_t, 3>& facet)
  {
    const auto& [a, b, c] = facet;
    return Kernel::Triangle_3(exact_point(points[a]), exact_point(points[b]), exact_point(points[c]));
  }

  static Eigen::Vector3d normal(const Kernel::Triangle_3& triangle)
  {
    return to_vector(triangle[1] - triangle[0]).cross(to_vector(triangle[2] - triangle[0])).stableNormalized();
  }

  std::vector<std::array<std::size_t, 3> > m_facets;
  std::vector<Eigen::Vector3d> m_vertices;
  Triangles m_triangles; // of the facets
  Segments m_segments;
  double m_rounding; // distance of points on lines from the lines, by rounding
  Tree<AABB_triangle_primitive<Kernel, Triangles::const_iterator> > m_surface;
  Tree<AABB_segment_primitive<Kernel, Segments::const_iterator> > m_lines;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_BODY_SURFACE_3_H
