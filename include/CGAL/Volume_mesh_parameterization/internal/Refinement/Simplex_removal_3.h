// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_SIMPLEX_REMOVAL_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_SIMPLEX_REMOVAL_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refinement/Refinement_3.h>

#include <boost/container/static_vector.hpp>

#include <queue>
#include <tuple>
#include <unordered_set>

namespace CGAL::Volume_mesh_parameterization::internal {

// The vertices on the boundary, and those that `is_constrained` tells.
template <typename C3t3, typename VertexIsConstrainedMap>
std::unordered_set<typename C3t3::Vertex_handle>
prescribed_vertices(const C3t3& c3t3, const Boundary_facets<C3t3>& boundary, const VertexIsConstrainedMap is_constrained)
{
  std::unordered_set<typename C3t3::Vertex_handle> result(boundary.vertices.begin(), boundary.vertices.end());
  for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    for(int i = 0; i < 4; ++i)
      if(get(is_constrained, it->vertex(i)))
        result.insert(it->vertex(i));
  return result;
}

template <typename VertexHandle>
bool contains(const std::unordered_set<VertexHandle>& vertices, const Simplex_3<VertexHandle>& simplex)
{
  return std::all_of(simplex.begin(), simplex.end(), [&](const VertexHandle v) { return vertices.count(v) != 0; });
}

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
    : m_prescribed(prescribed_vertices(c3t3, boundary, is_constrained)), m_target(target)
  {
    for(const auto& facet : boundary.facets)
      for(int i = 0; i < 3; ++i)
        m_links[boundary.vertices[facet[i]]].push_back({ boundary.vertices[facet[(i + 1) % 3]],
                                                         boundary.vertices[facet[(i + 2) % 3]] });
  }

  bool operator()(const Simplex_3<VertexHandle>& simplex) const
  {
    if(!contains(m_prescribed, simplex))
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

  std::unordered_set<VertexHandle> m_prescribed;
  BoundaryMap m_target;
  std::unordered_map<VertexHandle, std::vector<Simplex_3<VertexHandle> > > m_links; // in the boundary, as edges
};

// Removes bad interior edges, facets and cells from a complex by the insertion of few vertices.
//
// A vertex inserted into a simplex removes all bad simplices that contain it. IsBad(simplex) is a condition on old
// vertices, which a simplex with a new vertex does not fulfil: no insertion makes anything bad. So the numbers of bad
// simplices around the candidates only fall, and it suffices to update the one at the top of the queue.
template <typename C3t3, typename IsBad>
class Simplex_removal_3
{
  using Vertex_handle = typename C3t3::Vertex_handle;
  using Cell_handle = typename C3t3::Cell_handle;
  using Simplex = Simplex_3<Vertex_handle>;

public:
  Simplex_removal_3(C3t3& c3t3, const IsBad& is_bad) : m_c3t3(c3t3), m_is_bad(is_bad), m_refinement(c3t3) {}

  // Writes an `Inserted_vertex_3` for each insertion and returns their number. If the budget does not suffice to find all
  // bad simplices, nothing is inserted.
  template <typename OutputIterator>
  std::size_t run(OutputIterator out, const Budget& budget)
  {
    for(auto it = m_c3t3.cells_in_complex_begin(); it != m_c3t3.cells_in_complex_end() && !budget.is_exhausted(); ++it)
      collect_candidates(it);

    std::size_t number_of_insertions = 0;
    while(!m_queue.empty() && !budget.is_exhausted())
    {
      Candidate candidate = m_queue.top();
      m_queue.pop();
      const std::size_t number_of_bad = count_bad(candidate.simplex);
      if(number_of_bad == 0)
        continue;
      if(number_of_bad < candidate.number_of_bad)
      {
        candidate.number_of_bad = number_of_bad;
        m_queue.push(candidate);
        continue;
      }
      const Vertex_handle v = m_refinement.insert(candidate.simplex);
      if(v == Vertex_handle())
        continue;
      *out++ = Inserted_vertex_3<Vertex_handle>{ v, { candidate.simplex.begin(), candidate.simplex.end() } };
      ++number_of_insertions;
    }
    return number_of_insertions;
  }

private:
  struct Candidate
  {
    Simplex simplex;
    bool is_bad_edge;
    std::size_t number_of_bad;
    double size;
    std::size_t number;

    // Edges come first, bad ones before others, then those of many bad simplices, then the longest.
    bool operator<(const Candidate& other) const
    {
      return std::make_tuple(other.simplex.size(), is_bad_edge, number_of_bad, size, other.number)
           < std::make_tuple(simplex.size(), other.is_bad_edge, other.number_of_bad, other.size, number);
    }
  };

  void collect_candidates(const Cell_handle c)
  {
    for_each_face(vertices_of_cell(c), [&](const Simplex& simplex)
    {
      if(m_is_bad(simplex) && is_interior(m_c3t3, simplex, c))
        for_each_face(simplex, [&](const Simplex& face) { add_candidate(face, c); });
    });
  }

  void add_candidate(const Simplex& simplex, const Cell_handle c)
  {
    if(!m_refinement.choose(simplex, c) || !is_interior(m_c3t3, simplex, c))
      return;
    const bool is_bad_edge = simplex.size() == 2 && m_is_bad(simplex);
    m_queue.push({ simplex, is_bad_edge, count_bad(simplex), squared_size(m_c3t3.triangulation(), simplex),
                   m_number_of_candidates++ });
  }

  // The number of bad simplices that contain a candidate, counted in each cell around it.
  std::size_t count_bad(const Simplex& simplex) const
  {
    const Cell_handle c = m_refinement.cell(simplex);
    if(c == Cell_handle())
      return 0;
    std::size_t count = 0;
    for(const Cell_handle around : cells_around(m_c3t3.triangulation(), simplex, c))
      for_each_face(vertices_of_cell(around), [&](const Simplex& face)
      {
        if(contains(face, simplex) && m_is_bad(face))
          ++count;
      });
    return count;
  }

  C3t3& m_c3t3;
  const IsBad& m_is_bad;
  Refinement_3<C3t3> m_refinement;
  std::priority_queue<Candidate> m_queue;
  std::size_t m_number_of_candidates = 0;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINEMENT_SIMPLEX_REMOVAL_3_H
