// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_DEGENERATE_SIMPLICES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_DEGENERATE_SIMPLICES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Complex/Boundary_facets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_point_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refinement/Simplex_3.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The vertices of the boundary of a complex, and those that `is_constrained` tells.
template <typename C3t3, typename VertexIsConstrainedMap>
std::unordered_set<typename C3t3::Vertex_handle> prescribed_vertices(const C3t3& c3t3,
                                                                     const Boundary_facets<C3t3>& boundary,
                                                                     const VertexIsConstrainedMap is_constrained)
{
  std::unordered_set<typename C3t3::Vertex_handle> vertices(boundary.vertices.begin(), boundary.vertices.end());
  for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    for(int i = 0; i < 4; ++i)
      if(get(is_constrained, it->vertex(i)))
        vertices.insert(it->vertex(i));
  return vertices;
}

// The simplices all of whose vertices are prescribed.
template <typename VertexHandle>
class Prescribed_simplices_3
{
public:
  template <typename C3t3, typename VertexIsConstrainedMap>
  Prescribed_simplices_3(const C3t3& c3t3, const Boundary_facets<C3t3>& boundary,
                         const VertexIsConstrainedMap is_constrained)
    : m_vertices(prescribed_vertices(c3t3, boundary, is_constrained))
  {}

  bool operator()(const Simplex_3<VertexHandle>& simplex) const
  {
    return std::all_of(simplex.begin(), simplex.end(), [&](const VertexHandle v) { return m_vertices.count(v) != 0; });
  }

private:
  std::unordered_set<VertexHandle> m_vertices;
};

// The prescribed simplices that no map with these images of its boundary can map well: their image, the
// hull of the targets of their vertices, is degenerate, or inverted for a cell; or it begins in the image of the boundary,
// as an edge does between two vertices of a side of a cube, though cells lie all around the simplex. With a coordinate that
// is no number there is no image.
template <typename VertexHandle, typename BoundaryMap>
class Degenerate_simplices_3
{
public:
  template <typename C3t3, typename VertexIsConstrainedMap>
  Degenerate_simplices_3(const C3t3& c3t3, const Boundary_facets<C3t3>& boundary,
                         const VertexIsConstrainedMap is_constrained, const BoundaryMap target)
    : m_is_prescribed(c3t3, boundary, is_constrained), m_target(target)
  {
    for(const auto& facet : boundary.facets)
      for(int i = 0; i < 3; ++i)
        m_links[boundary.vertices[facet[i]]].push_back({ boundary.vertices[facet[(i + 1) % 3]],
                                                         boundary.vertices[facet[(i + 2) % 3]] });
  }

  bool operator()(const Simplex_3<VertexHandle>& simplex) const
  {
    if(!m_is_prescribed(simplex))
      return false;
    boost::container::static_vector<Exact_point_3, 4> points;
    for(const VertexHandle v : simplex)
      points.push_back(target(v));
    if(!std::all_of(points.begin(), points.end(), is_finite_point))
      return false;

    switch(points.size())
    {
      case 2: return points[0] == points[1] || begins_in_boundary(simplex);
      case 3: return CGAL::collinear(points[0], points[1], points[2]) || begins_in_boundary(simplex);
      default: return CGAL::orientation(points[0], points[1], points[2], points[3]) != CGAL::POSITIVE;
    }
  }

private:
  Exact_point_3 target(const VertexHandle v) const { return exact_point(get(m_target, v)); }

  // At one of the vertices, if it is no simplex of the boundary itself.
  bool begins_in_boundary(const Simplex_3<VertexHandle>& simplex) const
  {
    return std::any_of(simplex.begin(), simplex.end(), [&](const VertexHandle v)
    {
      const auto link = m_links.find(v);
      if(link == m_links.end()) // constrained, but inside
        return false;
      Simplex_3<VertexHandle> others;
      std::copy_if(simplex.begin(), simplex.end(), std::back_inserter(others), [v](const VertexHandle w) { return w != v; });
      const auto is_face = [&](const Simplex_3<VertexHandle>& edge) { return contains(edge, others); };
      return std::none_of(link->second.begin(), link->second.end(), is_face)
        && std::any_of(link->second.begin(), link->second.end(), [&](const Simplex_3<VertexHandle>& edge)
      {
        return others.size() == 1 ? is_in_angle(v, edge, others[0])
                                  : is_in_angle(v, others, edge[0]) && is_in_angle(v, others, edge[1]);
      });
    });
  }

  // Does the half-line from v to w run in the angle at v of the triangle of v and an edge?
  bool is_in_angle(const VertexHandle v, const Simplex_3<VertexHandle>& edge, const VertexHandle w) const
  {
    const Exact_point_3 p = target(v), q = target(edge[0]), r = target(edge[1]), s = target(w);
    return is_finite_point(q) && is_finite_point(r) && is_finite_point(s) && CGAL::coplanar(p, q, r, s)
      && !CGAL::collinear(p, q, r) && CGAL::coplanar_orientation(p, q, r, s) != CGAL::NEGATIVE
      && CGAL::coplanar_orientation(p, r, q, s) != CGAL::NEGATIVE;
  }

  Prescribed_simplices_3<VertexHandle> m_is_prescribed;
  BoundaryMap m_target;
  std::unordered_map<VertexHandle, std::vector<Simplex_3<VertexHandle> > > m_links; // in the boundary, as edges
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_DEGENERATE_SIMPLICES_3_H
