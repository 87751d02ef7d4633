// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_BODY_SURFACE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_BODY_SURFACE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Mapped_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/AABB_trees_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <CGAL/Bbox_3.h>

#include <set>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the triangle of three of the points as a CGAL triangle, for searches and distances.
inline AABB_trees_3::Kernel::Triangle_3 triangle_of(const std::vector<Vector_3>& points,
                                                    const std::array<std::size_t, 3>& vertices)
{ return { exact_point(points[vertices[0]]), exact_point(points[vertices[1]]), exact_point(points[vertices[2]]) }; }

// Freedom of a vertex: anywhere, on the surface, along a line, or not at all.
enum class Freedom_3 { SPACE, SURFACE, LINE, NONE };

// Surface with lines, for nearest points on both: the boundary of a body that is mapped to a domain, or some of its patches.
class Body_surface_3
{
public:
  // Takes the boundary of the body. Its lines are the sharp edges whose images are along an axis: they are edges of the domain, or
  // in a face of it. Marked corners of the body stay wherever they are.
  explicit Body_surface_3(const Mapped_soup_3& soup)
    : m_facets(boundary_facets_3(soup.cells))
  {
    const std::vector<Vector_3> points = vectors_of(soup.points);
    for(const auto& [v, w] : sharp_edges_3(m_facets, soup.edges, [&](const std::size_t v) { return points[v]; }))
      if(leads_along_axis(to_vector(soup.images[v]), to_vector(soup.images[w])))
        m_edges_of_lines.push_back({ v, w });
    build(points, m_edges_of_lines);
    find_ends(points);
    find_corners(soup.corners, points);
  }

  // Takes any facets, and edges as lines. Such a surface has neither marked corners nor ends of lines, nor edges_of_lines().
  Body_surface_3(const std::vector<Vector_3>& points, std::vector<std::array<std::size_t, 3> > facets,
                 const std::vector<std::array<std::size_t, 2> >& lines = {})
    : m_facets(std::move(facets))
  { build(points, lines); }

  // Returns the points of the vertices of all facets.
  const std::vector<Vector_3>& vertices() const { return m_vertices; }

  // Returns the edges of the lines, with indices of points of the body.
  const std::vector<std::array<std::size_t, 2> >& edges_of_lines() const { return m_edges_of_lines; }

  // Returns the marked corners on the boundary, as indices of points of the body.
  const std::set<std::size_t>& corners() const { return m_corners; }

  // Returns the freedom of a vertex of the boundary at p: NONE in marked corners and where lines end, turn or meet, LINE on other
  // points of lines, and SURFACE elsewhere, even if the image of the vertex is on an edge or in a corner of the domain.
  Freedom_3 freedom(const Vector_3& p) const
  {
    const bool is_end = std::any_of(m_ends.begin(), m_ends.end(), [&](const Vector_3& end) { return are_equal(end, p); });
    return is_end ? Freedom_3::NONE : is_on_line(p) ? Freedom_3::LINE : Freedom_3::SURFACE;
  }

  // Returns whether two points are the same up to rounding.
  bool are_equal(const Vector_3& p, const Vector_3& q) const { return (p - q).norm() <= m_rounding; }

  bool is_on_line(const Vector_3& p) const
  { return !m_segments.empty() && m_lines.squared_distance(exact_point(p)) <= m_rounding * m_rounding; }

  bool has_lines() const { return !m_segments.empty(); }

  // Returns the point nearest to p among those where a vertex of this freedom may be: p itself for SPACE and NONE.
  Vector_3 nearest(const Vector_3& p, const Freedom_3 freedom) const
  {
    return freedom == Freedom_3::SURFACE ? to_vector(m_surface.closest_point(exact_point(p)))
         : freedom == Freedom_3::LINE ? to_vector(m_lines.closest_point(exact_point(p))) : p;
  }

  // Returns the point of the surface nearest to p, with the normal there, or for LINE that of the lines, with their direction.
  Surface_point_3 nearest_with_direction(const Vector_3& p, const Freedom_3 freedom) const
  {
    if(freedom == Freedom_3::LINE)
    {
      const auto [point, segment] = m_lines.closest_point_and_primitive(exact_point(p));
      return { coordinates(to_vector(point)), coordinates(to_vector(segment->to_vector())) };
    }
    const auto [point, triangle] = m_surface.closest_point_and_primitive(exact_point(p));
    return { coordinates(to_vector(point)), coordinates(normal(*triangle)) };
  }

  // Returns p, put exactly on each plane that is normal to an axis, holds a facet, and holds p up to rounding.
  Vector_3 put_on_planes(Vector_3 p) const
  {
    for(int axis = 0; axis < 3; ++axis)
      if(const auto plane = m_planes[axis].lower_bound(p[axis] - m_rounding_of_planes);
         plane != m_planes[axis].end() && *plane <= p[axis] + m_rounding_of_planes)
        p[axis] = *plane;
    return p;
  }

  // Returns the vertices of the facet nearest to a point.
  const std::array<std::size_t, 3>& nearest_facet(const Vector_3& p) const
  { return m_facets[m_surface.closest_point_and_primitive(exact_point(p)).second - m_triangles.begin()]; }

  // Returns the unit normal of the facet nearest to a point.
  Vector_3 normal(const Vector_3& p) const
  { return normal(*m_surface.closest_point_and_primitive(exact_point(p)).second); }

  // Returns the distance of a point from the box around the surface, a lower bound of the distance from the surface.
  double distance_from_bbox(const Vector_3& p) const
  {
    const Bbox_3 box = m_surface.bbox();
    const Vector_3 lower(box.xmin(), box.ymin(), box.zmin()), upper(box.xmax(), box.ymax(), box.zmax());
    return (lower - p).cwiseMax(p - upper).cwiseMax(Vector_3::Zero()).norm();
  }

  // Returns the projector onto the directions in which a vertex of this freedom may move at p, which is on its surface or line.
  Matrix_3 projector(const Vector_3& p, const Freedom_3 freedom) const
  {
    if(freedom == Freedom_3::SPACE || freedom == Freedom_3::NONE)
      return freedom == Freedom_3::SPACE ? Matrix_3::Identity() : Matrix_3::Zero();
    const Vector_3 d = to_vector(nearest_with_direction(p, freedom).direction).stableNormalized();
    const Matrix_3 along = Matrix_3::outer_product(d, d);
    return freedom == Freedom_3::LINE ? along : Matrix_3::Identity() - along;
  }

private:
  // Finds the points where lines end or turn, or more than two edges of them meet.
  void find_ends(const std::vector<Vector_3>& points)
  {
    const auto point = [&](const std::size_t v) { return points[v]; };
    for(const std::size_t v : corners_of_curves(neighbors_along_edges(m_edges_of_lines), point))
      m_ends.push_back(points[v]);
  }

  // Finds the marked corners on the boundary. No vertex moves away from them, as from ends of lines.
  void find_corners(const std::vector<std::size_t>& marked, const std::vector<Vector_3>& points)
  {
    const std::vector<bool> is_on_boundary = used_points(m_facets, points.size());
    for(const std::size_t v : marked)
      if(is_on_boundary[v] && m_corners.insert(v).second)
        m_ends.push_back(points[v]);
  }

  // Collects what nearest points and planes are found by, and sets the bounds of rounding. Takes the edges of the lines.
  void build(const std::vector<Vector_3>& points, const std::vector<std::array<std::size_t, 2> >& lines)
  {
    std::set<std::size_t> vertices;
    for(const std::array<std::size_t, 3>& facet : m_facets)
    {
      m_triangles.push_back(triangle_of(points, facet));
      vertices.insert(facet.begin(), facet.end());
      const auto& [a, b, c] = facet;
      for(int axis = 0; axis < 3; ++axis)
        if(points[a][axis] == points[b][axis] && points[a][axis] == points[c][axis])
          m_planes[axis].insert(points[a][axis]);
    }
    for(const std::size_t v : vertices)
      m_vertices.push_back(points[v]);
    for(const auto& [v, w] : lines)
      m_segments.emplace_back(exact_point(points[v]), exact_point(points[w]));
    m_surface.rebuild(m_triangles.begin(), m_triangles.end());
    m_surface.accelerate_distance_queries();
    m_lines.rebuild(m_segments.begin(), m_segments.end());
    const Bbox_3 box = m_surface.bbox();
    m_rounding = 1e-9 * length_3({ box.x_span(), box.y_span(), box.z_span() }); // a guess
    for(const double x : { box.xmin(), box.xmax(), box.ymin(), box.ymax(), box.zmin(), box.zmax() })
      m_rounding_of_planes = (std::max)(m_rounding_of_planes, 1e-13 * std::abs(x)); // a guess
  }

  static Vector_3 normal(const AABB_trees_3::Kernel::Triangle_3& triangle)
  { return to_vector(triangle[1] - triangle[0]).cross(to_vector(triangle[2] - triangle[0])).stableNormalized(); }

  std::vector<std::array<std::size_t, 3> > m_facets;
  std::vector<Vector_3> m_vertices;
  AABB_trees_3::Triangles m_triangles; // of the facets
  std::vector<std::array<std::size_t, 2> > m_edges_of_lines;
  AABB_trees_3::Segments m_segments; // of the lines
  std::vector<Vector_3> m_ends; // of lines, and marked corners
  std::set<std::size_t> m_corners;
  double m_rounding; // largest distance between points that count as equal
  std::array<std::set<double>, 3> m_planes; // the coordinates of facets that are normal to an axis
  double m_rounding_of_planes = 0;
  AABB_trees_3::Of_triangles m_surface;
  AABB_trees_3::Of_segments m_lines;
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_BODY_SURFACE_3_H
