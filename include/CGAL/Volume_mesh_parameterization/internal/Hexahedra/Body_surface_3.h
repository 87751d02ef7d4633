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
    constexpr double cosine_of_sharp_edge = 0.5; // a guess; 60 degrees between normals
    const std::vector<std::array<std::size_t, 3> >& facets = m_facets;
    const auto triangle = [&](const std::size_t f, const std::vector<std::array<double, 3> >& positions)
    {
      const auto& [a, b, c] = facets[f];
      return Kernel::Triangle_3(exact_point(positions[a]), exact_point(positions[b]), exact_point(positions[c]));
    };
    std::set<std::size_t> vertices;
    for(std::size_t f = 0; f < facets.size(); ++f)
    {
      m_triangles.push_back(triangle(f, points));
      vertices.insert(facets[f].begin(), facets[f].end());
    }
    for(const std::size_t v : vertices)
      m_vertices.push_back(to_vector(points[v]));
    for_each_edge(facets, [&](const auto begin, const auto end)
    {
      const std::size_t f = begin->second[0] / 3, g = (end - 1)->second[0] / 3;
      if(normal(m_triangles[f]).dot(normal(m_triangles[g])) < cosine_of_sharp_edge
         && normal(triangle(f, images)).dot(normal(triangle(g, images))) < cosine_of_sharp_edge)
        m_segments.emplace_back(exact_point(points[begin->first[0]]), exact_point(points[begin->first[1]]));
    });
    m_surface.rebuild(m_triangles.begin(), m_triangles.end());
    m_surface.accelerate_distance_queries();
    m_lines.rebuild(m_segments.begin(), m_segments.end());
    const Bbox_3 box = m_surface.bbox();
    m_rounding = 1e-9 * std::hypot(box.x_span(), box.y_span(), box.z_span());
  }

  const std::vector<Eigen::Vector3d>& vertices() const { return m_vertices; }

  // Returns the freedom of a vertex by the number of planes of the boundary of the domain that its image is on. The image may be
  // on an edge or in a corner: the vertex is held there only if the body has a line there, too.
  Freedom_3 freedom(const Eigen::Vector3d& p, const int number_of_planes) const
  {
    if(number_of_planes == 0)
      return Freedom_3::SPACE;
    const bool is_on_line = number_of_planes > 1 && !m_segments.empty()
      && m_lines.squared_distance(exact_point(p)) <= m_rounding * m_rounding;
    return !is_on_line ? Freedom_3::SURFACE : number_of_planes == 2 ? Freedom_3::LINE : Freedom_3::NONE;
  }

  // Returns the point nearest to p among those where a vertex may be.
  Eigen::Vector3d nearest(const Eigen::Vector3d& p, const Freedom_3 freedom) const
  {
    return freedom == Freedom_3::SURFACE ? to_vector(m_surface.closest_point(exact_point(p)))
         : freedom == Freedom_3::LINE ? to_vector(m_lines.closest_point(exact_point(p))) : p;
  }

  // Returns the vertices of the facet nearest to a point.
  const std::array<std::size_t, 3>& nearest_facet(const Eigen::Vector3d& p) const
  { return m_facets[m_surface.closest_point_and_primitive(exact_point(p)).second - m_triangles.begin()]; }

  // Returns the projector onto the directions in which a vertex may move from a point where it may be.
  Eigen::Matrix3d projector(const Eigen::Vector3d& p, const Freedom_3 freedom) const
  {
    if(freedom == Freedom_3::SURFACE)
    {
      const Eigen::Vector3d n = normal(*m_surface.closest_point_and_primitive(exact_point(p)).second);
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
