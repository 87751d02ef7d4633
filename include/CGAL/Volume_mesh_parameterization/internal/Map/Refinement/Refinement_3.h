// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_REFINEMENT_REFINEMENT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_REFINEMENT_REFINEMENT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Compressed_rows.h>

#include <optional>
#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Does a simplex, as a range of its vertices, have a vertex, or all those of a face?
template <typename Simplex>
bool contains(const Simplex& simplex, const typename Simplex::value_type& v)
{ return std::find(simplex.begin(), simplex.end(), v) != simplex.end(); }

template <typename Simplex>
bool contains(const Simplex& simplex, const Simplex_3& face)
{ return std::all_of(face.begin(), face.end(), [&](const std::size_t v) { return contains(simplex, v); }); }

// Calls f for the edges, facets and cells that are faces of the simplex, itself included.
template <typename Function>
void for_each_face(const Simplex_3& simplex, const Function& f)
{
  for(unsigned int subset = 0; subset < (1u << simplex.size()); ++subset)
  {
    Simplex_3 face;
    for(unsigned int i = 0; i < simplex.size(); ++i)
      if(subset & (1u << i))
        face.push_back(simplex[i]);
    if(face.size() >= 2)
      f(face);
  }
}

// The facets of the boundary at each point. Splits inside leave them as they are.
class Boundary_links_3
{
public:
  explicit Boundary_links_3(const Body_3& body)
    : m_facets(body.boundary), m_rows(body.points.size(), m_facets.size(), [&](const std::size_t f, const auto& add)
      { std::for_each(m_facets[f].begin(), m_facets[f].end(), add); })
  {}

  // Does `f(edge)` hold for one of the edges that are opposite to a point in its facets?
  template <typename Function>
  bool any_of_link(const std::size_t v, const Function& f) const
  {
    return any_of_facets(v, [&](const auto& facet)
    {
      const auto& [p, q, r] = facet;
      return f(v == p ? Simplex_3{ q, r } : v == q ? Simplex_3{ r, p } : Simplex_3{ p, q });
    });
  }

  // Is an edge or facet on the boundary?
  bool has(const Simplex_3& simplex) const
  { return any_of_facets(simplex[0], [&](const auto& facet) { return contains(facet, simplex); }); }

private:
  template <typename Function>
  bool any_of_facets(const std::size_t v, const Function& f) const
  {
    if(v + 2 >= m_rows.begin.size())
      return false; // a new point
    for(std::size_t i = m_rows.begin[v]; i < m_rows.begin[v + 1]; ++i)
      if(f(m_facets[m_rows.items[i]]))
        return true;
    return false;
  }

  const std::vector<std::array<std::size_t, 3> >& m_facets;
  Compressed_rows<std::size_t> m_rows;
};

// Calls f for the edges, facets and cells inside that have marked points only, once for each of their cells.
template <typename Function>
void for_each_simplex_inside(const Body_3& body, const std::vector<bool>& is_marked, const Budget& budget, const Function& f)
{
  const Boundary_links_3 boundary(body);
  for(const std::array<std::size_t, 4>& cell : body.cells)
  {
    Simplex_3 marked;
    std::copy_if(cell.begin(), cell.end(), std::back_inserter(marked), [&](const std::size_t v) { return is_marked[v]; });
    if(marked.size() < 2)
      continue;
    if(budget.is_exhausted())
      return;
    for_each_face(marked, [&](const Simplex_3& simplex)
    {
      if(!boundary.has(simplex))
        f(simplex);
    });
  }
}

// Simplices of one dimension, and which of them have a point.
template <std::size_t N>
class Incident_simplices_3
{
public:
  Incident_simplices_3(std::vector<std::array<std::size_t, N> >& simplices, const std::size_t number_of_points)
    : m_simplices(simplices), m_incident(number_of_points)
  {
    for(std::size_t s = 0; s < simplices.size(); ++s)
      for(const std::size_t v : simplices[s])
        m_incident[v].push_back(s);
  }

  // Returns the simplices that contain a face.
  std::vector<std::size_t> around(const Simplex_3& face) const
  {
    std::vector<std::size_t> result;
    for(const std::size_t s : m_incident[face[0]])
      if(contains(m_simplices[s], face))
        result.push_back(s);
    return result;
  }

  // Inserts a new point, the next one, into a face. Each simplex around becomes as many parts as the face has vertices; in each of
  // them, the new point replaces one of these. The first part replaces the simplex, the others are appended. Returns, for each of
  // these, the simplex that it comes from.
  std::vector<std::size_t> insert(const Simplex_3& face)
  {
    const std::size_t v = m_incident.size();
    const std::vector<std::size_t> old_ones = around(face);
    std::vector<std::size_t> origins;
    m_incident.emplace_back();
    for(const std::size_t s : old_ones)
    {
      for(std::size_t k = 1; k < face.size(); ++k)
      {
        for(const std::size_t w : replace(m_simplices[s], face[k], v))
          m_incident[w].push_back(m_simplices.size());
        m_simplices.push_back(replace(m_simplices[s], face[k], v));
        origins.push_back(s);
      }
      m_simplices[s] = replace(m_simplices[s], face[0], v);
      m_incident[face[0]].erase(std::find(m_incident[face[0]].begin(), m_incident[face[0]].end(), s));
      m_incident[v].push_back(s);
    }
    return origins;
  }

private:
  static std::array<std::size_t, N> replace(std::array<std::size_t, N> simplex, const std::size_t v, const std::size_t w)
  {
    std::replace(simplex.begin(), simplex.end(), v, w);
    return simplex;
  }

  std::vector<std::array<std::size_t, N> >& m_simplices;
  std::vector<std::vector<std::size_t> > m_incident;
};

// Makes new points vertices of edges, facets and cells of a body, of interior ones unless others are asked for.
class Refinement_3
{
public:
  explicit Refinement_3(Body_3& body)
    : m_body(body), m_cells(body.cells, body.points.size()), m_edges(body.edges, body.points.size()), m_boundary(body)
  {}

  std::vector<std::size_t> cells_around(const Simplex_3& simplex) const { return m_cells.around(simplex); }

  Simplex_3 cell(const std::size_t c) const { return Simplex_3(m_body.cells[c].begin(), m_body.cells[c].end()); }

  // Is a simplex with these cells around it one of the body, and not of its boundary?
  bool is_interior(const Simplex_3& simplex, const std::vector<std::size_t>& cells) const
  {
    switch(simplex.size())
    {
      case 2: return !cells.empty() && !m_boundary.has(simplex);
      case 3: return cells.size() == 2;
      default: return !cells.empty();
    }
  }

  // The squared length of the longest edge.
  double squared_size(const Simplex_3& simplex) const
  {
    double result = 0;
    for(const std::size_t v : simplex)
      for(const std::size_t w : simplex)
        result = (std::max)(result, CGAL::squared_distance(point(v), point(w)));
    return result;
  }

  // Inserts a point into an interior simplex. Returns nothing if the simplex does not exist any more, is not interior, or has no
  // point that makes positive cells after rounding.
  std::optional<Insertion_3> insert(const Simplex_3& simplex)
  {
    const std::vector<std::size_t> cells = cells_around(simplex);
    return is_interior(simplex, cells) ? insert(simplex, cells) : std::nullopt;
  }

  // Makes a point a vertex of a simplex that may belong to the boundary, which changes then.
  std::optional<Insertion_3> insert(const Simplex_3& simplex, const std::vector<std::size_t>& cells)
  {
    Insertion_3 insertion = { m_body.points.size(), simplex, {}, cells };
    if(!set_weights(insertion))
      return std::nullopt;
    m_cells.insert(simplex);
    m_edges.insert(simplex);
    m_body.points.push_back(coordinates(point(insertion)));
    return insertion;
  }

private:
  Exact_point_3 point(const std::size_t v) const { return exact_point(m_body.points[v]); }

  // Sets weights of a point that can become a vertex, as all cells it makes are positive after rounding: of the centroid, or else
  // of a point up to a third of the way towards a vertex. Returns whether there is such a point.
  bool set_weights(Insertion_3& insertion) const
  {
    for(const double additional_weight : { 0., 0.125, 0.25, 0.5, 1. })
      for(std::size_t preferred = 0; preferred < insertion.simplex.size(); ++preferred)
      {
        insertion.weights.assign(insertion.simplex.size(), 1.);
        insertion.weights[preferred] += additional_weight;
        if(makes_positive_cells(insertion.simplex, insertion.cells, point(insertion)))
          return true;
      }
    return false;
  }

  Exact_point_3 point(const Insertion_3& insertion) const
  {
    const auto coordinate = [&](const int i)
    { return m_body.point_type.rounded(insertion.mean([&](const std::size_t v) { return m_body.points[v][i]; })); };
    return Exact_point_3(coordinate(0), coordinate(1), coordinate(2));
  }

  // Asks for positive parts of positive cells only, as a tangled mesh has others.
  bool makes_positive_cells(const Simplex_3& simplex, const std::vector<std::size_t>& cells, const Exact_point_3& p) const
  {
    for(const std::size_t c : cells)
      for(const std::size_t replaced : simplex)
      {
        const std::array<std::size_t, 4>& cell = m_body.cells[c];
        const auto corner = [&](const int i) { return cell[i] == replaced ? p : point(cell[i]); };
        if(!is_positive_cell({ corner(0), corner(1), corner(2), corner(3) })
           && is_positive_cell({ point(cell[0]), point(cell[1]), point(cell[2]), point(cell[3]) }))
          return false;
      }
    return true;
  }

  Body_3& m_body;
  Incident_simplices_3<4> m_cells;
  Incident_simplices_3<2> m_edges;
  Boundary_links_3 m_boundary;
};

// Splits the interior edges among the given pairs of points, longest first, or in their order. Pairs that are no interior edge are
// ignored. The time is linear in the number of cells.
inline std::vector<Insertion_3> split_edges_3(Body_3& body, const std::vector<std::array<std::size_t, 2> >& edges,
                                              const bool is_longest_first = true)
{
  Refinement_3 refinement(body);
  std::set<std::pair<std::size_t, std::size_t> > known;
  std::vector<std::pair<double, Simplex_3> > sorted;
  for(const auto& [v, w] : edges)
    if(v != w && known.insert((std::minmax)(v, w)).second)
      sorted.emplace_back(refinement.squared_size({ v, w }), Simplex_3{ v, w });
  if(is_longest_first)
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first > b.first; });

  std::vector<Insertion_3> result;
  for(const auto& [size, edge] : sorted)
    if(const std::optional<Insertion_3> insertion = refinement.insert(edge))
      result.push_back(*insertion);
  return result;
}

// Splits the edges inside at all points of the boundary: each gets vertices of its own inside.
inline std::vector<Insertion_3> split_edges_at_boundary_3(Body_3& body)
{
  const std::vector<bool> is_on_boundary = used_points(body.boundary, body.points.size());
  std::vector<std::array<std::size_t, 2> > edges;
  for(const std::array<std::size_t, 4>& cell : body.cells)
    for(const std::size_t v : cell)
      for(const std::size_t w : cell)
        if(v < w && (is_on_boundary[v] || is_on_boundary[w]))
          edges.push_back({ v, w });
  return split_edges_3(body, edges);
}

// Splits edges one after the other, also those of the boundary. Nothing if rounding leaves no point for one.
inline std::optional<std::vector<Insertion_3> > split_any_edges_3(Body_3& body,
                                                                  const std::vector<std::array<std::size_t, 2> >& edges)
{
  std::vector<Insertion_3> result;
  {
    Refinement_3 refinement(body);
    for(const auto& [v, w] : edges)
    {
      const Simplex_3 edge = { v, w };
      const std::optional<Insertion_3> insertion = refinement.insert(edge, refinement.cells_around(edge));
      if(!insertion)
        return std::nullopt;
      result.push_back(*insertion);
    }
  }
  if(!result.empty())
  {
    Body_3 refined = body_of_arrays(std::move(body.points), std::move(body.cells), std::move(body.edges));
    refined.point_type = body.point_type;
    refined.image_type = body.image_type;
    body = std::move(refined);
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_REFINEMENT_REFINEMENT_3_H
