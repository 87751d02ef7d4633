// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_REFINEMENT_SIMPLEX_REMOVAL_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_REFINEMENT_SIMPLEX_REMOVAL_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/projector_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Refinement_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <queue>
#include <tuple>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns whether all vertices are prescribed. New points are not.
inline bool is_prescribed_simplex(const std::vector<bool>& is_prescribed, const Simplex_3& simplex)
{
  return std::all_of(simplex.begin(), simplex.end(), [&](const std::size_t v)
  { return v < is_prescribed.size() && is_prescribed[v]; });
}

// Tells which simplices inside no map with these targets can map well. There are three kinds:
// - conditions keep the vertices of a cell in a plane, or those of an edge or facet in the plane of a facet of the boundary;
// - the image, the hull of the targets of the vertices, is degenerate, or inverted for a cell;
// - the image begins in that of the boundary though cells lie all around the simplex, as an edge between two vertices of a side of
//   a cube.
// A simplex with a coordinate that is not a number has no image, and is not of these kinds.
class Degenerate_simplices_3
{
public:
  Degenerate_simplices_3(const Body_3& body, const std::vector<bool>& is_prescribed,
                         const std::vector<std::array<double, 3> >& targets,
                         const std::vector<Vertex_condition_3>& conditions)
    : m_is_prescribed(is_prescribed), m_targets(targets), m_conditions(conditions), m_boundary(body),
      m_is_one_moving(std::any_of(conditions.begin(), conditions.end(), [](const Vertex_condition_3& condition)
      { return condition.dimension() < 3 && !is_at_target_first(condition); }))
  {}

  bool operator()(const Simplex_3& simplex) const
  {
    if(is_kept_in_plane(simplex) && (simplex.size() == 4 || is_in_plane_of_boundary(simplex)))
      return true;
    if(!is_prescribed_simplex(m_is_prescribed, simplex))
      return false;
    boost::container::static_vector<Exact_point_3, 4> points;
    for(const std::size_t v : simplex)
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
  Exact_point_3 target(const std::size_t v) const { return exact_point(m_targets[v]); }

  template <typename Points>
  bool is_kept_in_plane(const Points& points) const
  {
    return m_is_one_moving
      && std::all_of(points.begin(), points.end(), [&](const std::size_t v) { return v < m_conditions.size(); })
      && are_kept_in_one_plane(points, [&](const std::size_t v) { return projector_3(m_conditions[v]); },
                               [&](const std::size_t v) { return to_vector(m_targets[v]); });
  }

  // Do the conditions keep a facet of the boundary at one of the vertices in the same plane?
  bool is_in_plane_of_boundary(const Simplex_3& simplex) const
  {
    return std::any_of(simplex.begin(), simplex.end(), [&](const std::size_t v)
    {
      return m_boundary.any_of_link(v, [&](const Simplex_3& edge)
      {
        boost::container::static_vector<std::size_t, 5> points(simplex.begin(), simplex.end());
        points.insert(points.end(), edge.begin(), edge.end());
        return is_kept_in_plane(points);
      });
    });
  }

  // Returns whether the image begins in that of the boundary at one of the vertices.
  bool begins_in_boundary(const Simplex_3& simplex) const
  {
    return std::any_of(simplex.begin(), simplex.end(), [&](const std::size_t v)
    {
      Simplex_3 other_points;
      std::copy_if(simplex.begin(), simplex.end(), std::back_inserter(other_points), [v](const std::size_t w) { return w != v; });
      return m_boundary.any_of_link(v, [&](const Simplex_3& edge) // none if it is constrained, but inside
      {
        return other_points.size() == 1 ? is_in_angle(v, edge, other_points[0])
                                        : is_in_angle(v, other_points, edge[0]) && is_in_angle(v, other_points, edge[1]);
      });
    });
  }

  // Does the half-line from v to w run in the angle at v of the triangle of v and an edge?
  bool is_in_angle(const std::size_t v, const Simplex_3& edge, const std::size_t w) const
  {
    const Exact_point_3 p = target(v), q = target(edge[0]), r = target(edge[1]), s = target(w);
    return is_finite_point(q) && is_finite_point(r) && is_finite_point(s) && !is_clearly_outside(p, q, r, s)
      && CGAL::coplanar(p, q, r, s) && !CGAL::collinear(p, q, r) && CGAL::coplanar_orientation(p, q, r, s) != CGAL::NEGATIVE
      && CGAL::coplanar_orientation(p, r, q, s) != CGAL::NEGATIVE;
  }

  // Spares exact arithmetic where rounding cannot matter.
  static bool is_clearly_outside(const Exact_point_3& p, const Exact_point_3& q, const Exact_point_3& r, const Exact_point_3& s)
  {
    constexpr double rounding = 1e-20; // the square of a bound far above the errors of the products
    const auto vector = [&](const Exact_point_3& to) { return Vector_3(to.x() - p.x(), to.y() - p.y(), to.z() - p.z()); };
    const Vector_3 a = vector(q), b = vector(r), c = vector(s), n = a.cross(b);
    const auto is_clear = [&](const double x, const double square) { return x * x > rounding * square * n.squaredNorm(); };
    const auto is_behind = [&](const Vector_3& x, const Vector_3& y)
    {
      const double product = x.cross(y).dot(n);
      return product < 0 && is_clear(product, x.squaredNorm() * y.squaredNorm());
    };
    return is_clear(c.dot(n), c.squaredNorm()) || is_behind(a, c) || is_behind(c, b);
  }

  const std::vector<bool>& m_is_prescribed;
  const std::vector<std::array<double, 3> >& m_targets;
  const std::vector<Vertex_condition_3>& m_conditions;
  Boundary_links_3 m_boundary;
  bool m_is_one_moving; // Does a condition let a point move in a plane or on a line?
};

// Removes bad interior edges, facets and cells from a body by the insertion of few points.
//
// A point inserted into a simplex removes all bad simplices that contain it. IsBad(simplex) is a condition on old
// points, which a simplex with a new one does not fulfil: no insertion makes anything bad. So the numbers of bad
// simplices around the candidates only fall, and it suffices to update the one at the top of the queue. All bad edges are split
// in any case, the longest first: those of many bad simplices first leave meshes in which maps are hard to find.
template <typename IsBad>
class Simplex_removal_3
{
public:
  Simplex_removal_3(Body_3& body, const IsBad& is_bad) : m_body(body), m_is_bad(is_bad) {}

  // All points of bad simplices are marked. If the budget does not suffice to find all of these, nothing is inserted.
  std::vector<Insertion_3> run(const std::vector<bool>& is_marked, const Budget& budget)
  {
    std::vector<Simplex_3> bad;
    for_each_simplex_inside(m_body, is_marked, budget, [&](const Simplex_3& simplex)
    {
      if(m_is_bad(simplex))
        bad.push_back(simplex);
    });
    std::vector<Insertion_3> result;
    if(bad.empty())
      return result;
    m_refinement.emplace(m_body);
    for(const Simplex_3& simplex : bad)
      for_each_face(simplex, [&](const Simplex_3& face) { add_candidate(face); });
    while(!m_queue.empty() && !budget.is_exhausted())
    {
      Candidate candidate = m_queue.top();
      m_queue.pop();
      const std::size_t number_of_bad = count_bad(candidate.simplex, candidate.is_bad_edge);
      if(number_of_bad == 0)
        continue;
      if(number_of_bad < candidate.number_of_bad)
      {
        candidate.number_of_bad = number_of_bad;
        m_queue.push(candidate);
        continue;
      }
      if(const std::optional<Insertion_3> insertion = m_refinement->insert(candidate.simplex))
        result.push_back(*insertion);
    }
    return result;
  }

private:
  struct Candidate
  {
    Simplex_3 simplex;
    bool is_bad_edge;
    std::size_t number_of_bad; // 1 for a bad edge
    double size;
    std::size_t number;

    // Edges come first, bad ones before others, then other simplices of many bad ones, then the longest.
    bool operator<(const Candidate& other) const
    {
      return std::make_tuple(other.simplex.size(), is_bad_edge, number_of_bad, size, other.number)
           < std::make_tuple(simplex.size(), other.is_bad_edge, other.number_of_bad, other.size, number);
    }
  };

  void add_candidate(const Simplex_3& simplex)
  {
    Simplex_3 sorted = simplex;
    std::sort(sorted.begin(), sorted.end());
    if(!m_known.insert(sorted).second || !m_refinement->is_interior(simplex, m_refinement->cells_around(simplex)))
      return;
    const bool is_bad_edge = simplex.size() == 2 && m_is_bad(simplex);
    m_queue.push({ simplex, is_bad_edge, count_bad(simplex, is_bad_edge), m_refinement->squared_size(simplex), m_queue.size() });
  }

  // The number of bad simplices that contain a candidate, counted in each cell around it. It does not matter for bad edges.
  std::size_t count_bad(const Simplex_3& simplex, const bool is_bad_edge) const
  {
    if(is_bad_edge)
      return 1;
    std::size_t count = 0;
    for(const std::size_t c : m_refinement->cells_around(simplex))
      for_each_face(m_refinement->cell(c), [&](const Simplex_3& face)
      {
        if(contains(face, simplex) && m_is_bad(face))
          ++count;
      });
    return count;
  }

  Body_3& m_body;
  const IsBad& m_is_bad;
  std::optional<Refinement_3> m_refinement; // only if there are bad simplices
  std::set<Simplex_3> m_known; // all that ever were candidates, so that none comes twice
  std::priority_queue<Candidate> m_queue;
};

// Removes the simplices that the targets make degenerate whatever the map is.
inline std::vector<Insertion_3> remove_degenerate_simplices(Body_3& body, const Prescription_3& prescription,
                                                            const Budget& budget)
{
  const std::vector<bool> is_fixed = prescription.fixed_points();
  const Degenerate_simplices_3 is_bad(body, is_fixed, prescription.targets, prescription.conditions);
  return Simplex_removal_3(body, is_bad).run(prescription.prescribed_points(), budget);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_REFINEMENT_SIMPLEX_REMOVAL_3_H
