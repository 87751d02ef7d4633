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

#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_point_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refinement/Simplex_3.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <iterator>
#include <unordered_set>

namespace CGAL::Volume_mesh_parameterization::internal {

// The vertices of the boundary of a complex, and those that `is_constrained` tells.
template <typename C3t3, typename VertexIsConstrainedMap>
std::unordered_set<typename C3t3::Vertex_handle> prescribed_vertices(const C3t3& c3t3,
                                                                     const VertexIsConstrainedMap is_constrained)
{
  std::unordered_set<typename C3t3::Vertex_handle> vertices;
  boundary_vertices(c3t3, std::inserter(vertices, vertices.end()));
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
  Prescribed_simplices_3(const C3t3& c3t3, const VertexIsConstrainedMap is_constrained)
    : m_vertices(prescribed_vertices(c3t3, is_constrained))
  {}

  bool operator()(const Simplex_3<VertexHandle>& simplex) const
  {
    return std::all_of(simplex.begin(), simplex.end(), [&](const VertexHandle v) { return m_vertices.count(v) != 0; });
  }

private:
  std::unordered_set<VertexHandle> m_vertices;
};

// The prescribed simplices whose image, the hull of the targets of their vertices, is degenerate, or inverted for a cell.
// With a coordinate that is no number there is no image.
template <typename VertexHandle, typename BoundaryMap>
class Degenerate_simplices_3
{
public:
  template <typename C3t3, typename VertexIsConstrainedMap>
  Degenerate_simplices_3(const C3t3& c3t3, const VertexIsConstrainedMap is_constrained, const BoundaryMap target)
    : m_is_prescribed(c3t3, is_constrained), m_target(target)
  {}

  bool operator()(const Simplex_3<VertexHandle>& simplex) const
  {
    if(!m_is_prescribed(simplex))
      return false;
    boost::container::static_vector<Exact_point_3, 4> points;
    for(const VertexHandle v : simplex)
      points.push_back(exact_point(get(m_target, v)));
    if(!std::all_of(points.begin(), points.end(), is_finite_point))
      return false;

    switch(points.size())
    {
      case 2: return points[0] == points[1];
      case 3: return CGAL::collinear(points[0], points[1], points[2]);
      default: return CGAL::orientation(points[0], points[1], points[2], points[3]) != CGAL::POSITIVE;
    }
  }

private:
  Prescribed_simplices_3<VertexHandle> m_is_prescribed;
  BoundaryMap m_target;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_DEGENERATE_SIMPLICES_3_H
