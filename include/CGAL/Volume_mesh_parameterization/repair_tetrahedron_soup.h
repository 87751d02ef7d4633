// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_REPAIR_TETRAHEDRON_SOUP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_REPAIR_TETRAHEDRON_SOUP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Soups/insert_points.h>
#include <CGAL/Volume_mesh_parameterization/internal/Soups/nearby_points.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <iterator>
#include <map>
#include <numeric>
#include <set>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

// The corners of cells, where corner 4 c + i is vertex i of cell c. Facets join corners at the same vertex to fans.
inline Disjoint_sets fans_of_corners(const Tetrahedron_soup_3& soup)
{
  const Facet_matching_3 matching(soup.cells);
  Disjoint_sets fans(4 * soup.cells.size());
  for(std::size_t side = 0; side < 4 * soup.cells.size(); ++side)
    if(matching.mirror(side) < side)
      for(const int i : facets_of_cell[side % 4])
        for(const int j : facets_of_cell[matching.mirror(side) % 4])
          if(soup.cells[side / 4][i] == soup.cells[matching.mirror(side) / 4][j])
            fans.unite(side / 4 * 4 + i, matching.mirror(side) / 4 * 4 + j);
  return fans;
}

// Lets the marked facets follow the cells, which had the vertices `before`.
inline void renumber_facets(const std::vector<std::array<std::size_t, 4> >& before, Tetrahedron_soup_3& soup)
{
  std::map<std::array<std::size_t, 3>, std::array<std::size_t, 3> > moved;
  for(std::size_t c = 0; c < before.size(); ++c)
    for(const auto& [i, j, k] : facets_of_cell)
      if(before[c] != soup.cells[c])
        moved.emplace(sorted(std::array{ before[c][i], before[c][j], before[c][k] }),
                      std::array{ soup.cells[c][i], soup.cells[c][j], soup.cells[c][k] });
  for(std::array<std::size_t, 3>& facet : soup.facets)
  {
    const auto found = moved.find(sorted(facet));
    facet = found == moved.end() ? facet : found->second;
  }
}

// Lets the marked edges follow the cells, which had the vertices `before`. An edge in several fans is appended for each of
// the others.
inline void renumber_edges(const std::vector<std::array<std::size_t, 4> >& before, Tetrahedron_soup_3& soup)
{
  using Edge = std::array<std::size_t, 2>;
  std::map<Edge, std::set<Edge> > edges_of_fans;
  for(const Edge& edge : soup.edges)
    edges_of_fans[sorted(edge)];
  for(std::size_t c = 0; c < before.size(); ++c)
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < i; ++j)
        if(const auto found = edges_of_fans.find(sorted(Edge{ before[c][i], before[c][j] })); found != edges_of_fans.end())
          found->second.insert(sorted(Edge{ soup.cells[c][i], soup.cells[c][j] }));
  for(std::size_t e = 0, n = soup.edges.size(); e < n; ++e)
  {
    const std::set<Edge>& edges = edges_of_fans[sorted(soup.edges[e])];
    if(edges.empty())
      continue;
    if(sorted(soup.edges[e]) != *edges.begin())
      soup.edges[e] = *edges.begin();
    for(auto edge = std::next(edges.begin()); edge != edges.end(); ++edge)
    {
      soup.edges.push_back(*edge);
      soup.edge_references.push_back(int(soup.edge_references[e]));
      copy_data(e, soup.edge_data);
    }
  }
}

// Returns, for each point, the first one with its coordinates.
inline std::vector<std::size_t> first_coinciding_points(const std::vector<std::array<double, 3> >& points)
{
  std::vector<std::size_t> order(points.size()), result(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](const std::size_t v, const std::size_t w) { return points[v] < points[w]; });
  for(std::size_t i = 0; i < order.size(); ++i)
    result[order[i]] = i > 0 && points[order[i]] == points[order[i - 1]] ? result[order[i - 1]] : order[i];
  return result;
}

// Returns for each point the first one of those that it is joined to, if points with the same coordinates are joined, and then
// points of the boundary up to a distance. Throws if a cell would lose a vertex.
inline std::vector<std::size_t> first_points_at_tears(const Tetrahedron_soup_3& soup, const std::vector<std::size_t>& coinciding,
                                                      const double distance)
{
  std::vector<std::array<std::size_t, 4> > cells = soup.cells;
  for(auto& cell : cells)
    for(std::size_t& v : cell)
      v = coinciding[v];
  const std::vector<std::size_t> boundary = boundary_vertices(soup.points, cells),
    nearby = first_nearby_points(soup.points, std::set<std::size_t>(boundary.begin(), boundary.end()), distance);
  for(std::size_t c = 0; c < cells.size(); ++c)
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < i; ++j)
        if(nearby[cells[c][i]] == nearby[cells[c][j]])
          throw Input_error(sentence("the distance ", distance, " joins the vertices ", soup.cells[c][j], " and ",
                                     soup.cells[c][i], " of cell ", c, " (counted from 0). Use a smaller one"));
  std::vector<std::size_t> result;
  for(const std::size_t v : coinciding)
    result.push_back(nearby[v]);
  return result;
}

// Returns, for each cell, the first one with its four vertices.
inline std::vector<std::size_t> first_coinciding_cells(const std::vector<std::array<std::size_t, 4> >& cells,
                                                       const bool is_parallel)
{
  std::vector<std::size_t> result(cells.size());
  for_each_group(cells.size(), [&](const std::size_t c) { return std::make_pair(sorted(cells[c]), c); },
                 [&](const auto begin, const auto end)
  {
    for(auto it = begin; it != end; ++it)
      result[it->second] = begin->second;
  }, is_parallel);
  return result;
}

// Returns the orientations of the facets of a flat cell in its plane: opposite ones on both sides, 0 if vertices are collinear.
inline std::array<int, 4> orientations_in_plane(const std::array<Exact_point_3, 4>& p)
{
  std::array<int, 4> result = {};
  for(int axis = 0; axis < 3 && result == std::array<int, 4>{}; ++axis) // along which the plane is projected
  {
    const auto point = [&](const int i)
    { return Exact_predicates_inexact_constructions_kernel::Point_2(p[i][(axis + 1) % 3], p[i][(axis + 2) % 3]); };
    for(std::size_t side = 0; side < 4; ++side)
    {
      const auto& [i, j, k] = facets_of_cell[side];
      result[side] = CGAL::orientation(point(i), point(j), point(k));
    }
  }
  return result;
}

// Flat cells whose facets on the boundary cover the same points as the other ones, which are on the boundary without them.
class Flat_boundary_cells_3
{
public:
  explicit Flat_boundary_cells_3(const Tetrahedron_soup_3& soup) : m_soup(soup)
  {
    const std::vector<Orientation> orientations = orientations_of_cells(soup, false);
    for(std::size_t c = 0; c < soup.cells.size(); ++c)
      if(orientations[c] == CGAL::COPLANAR)
      {
        m_orientations.emplace(c, orientations_in_plane(cell_points(soup, c)));
        for(std::size_t side = 0; side < 4; ++side)
          m_numbers_of_cells[facet(c, side)] = 0;
      }
    for(std::size_t c = 0; c < soup.cells.size() && !m_orientations.empty(); ++c)
      for(std::size_t side = 0; side < 4; ++side)
        if(const auto found = m_numbers_of_cells.find(facet(c, side)); found != m_numbers_of_cells.end())
          ++found->second;
  }

  // Removes cells one after the other, as long as there are such ones, and returns them.
  std::set<std::size_t> run()
  {
    std::set<std::size_t> result;
    for(std::size_t before = 1; before != result.size(); )
    {
      before = result.size();
      for(const auto& [c, orientations] : m_orientations)
        if(result.count(c) == 0 && can_be_removed(c, orientations))
        {
          result.insert(c);
          for(std::size_t side = 0; side < 4; ++side)
            --m_numbers_of_cells[facet(c, side)];
        }
    }
    return result;
  }

  // Returns whether all cells with a facet have been removed.
  bool has_lost_cells(const std::array<std::size_t, 3>& facet) const
  {
    const auto found = m_numbers_of_cells.find(sorted(facet));
    return found != m_numbers_of_cells.end() && found->second == 0;
  }

private:
  std::array<std::size_t, 3> facet(const std::size_t c, const std::size_t side) const
  {
    const auto& [i, j, k] = facets_of_cell[side];
    return sorted(std::array{ m_soup.cells[c][i], m_soup.cells[c][j], m_soup.cells[c][k] });
  }

  bool can_be_removed(const std::size_t c, const std::array<int, 4>& orientations) const
  {
    bool has_boundary = false;
    std::set<int> signs; // of facets on the boundary, and the opposite ones of the others
    for(std::size_t side = 0; side < 4; ++side)
    {
      const bool is_on_boundary = m_numbers_of_cells.at(facet(c, side)) == 1;
      has_boundary = has_boundary || is_on_boundary;
      signs.insert(is_on_boundary ? orientations[side] : -orientations[side]);
    }
    return has_boundary && signs.size() - signs.count(0) <= 1;
  }

  const Tetrahedron_soup_3& m_soup;
  std::map<std::size_t, std::array<int, 4> > m_orientations; // of the facets of each flat cell
  std::map<std::array<std::size_t, 3>, int> m_numbers_of_cells; // at each facet of flat cells
};

// The cell data with the reference number `i` of cells in several groups.
inline std::string name_of_reference(const std::size_t i) { return "reference_" + std::to_string(i); }

// Returns the numbers of sharp edges at vertices that have any: of the marked edges, or of those of the shape if none is marked.
inline std::map<std::size_t, std::size_t> numbers_of_sharp_edges(const Tetrahedron_soup_3& soup,
                                                                 const std::vector<std::array<std::size_t, 3> >& facets,
                                                                 const std::vector<std::array<std::size_t, 2> >& marked)
{
  std::map<std::size_t, std::size_t> result;
  for(const auto& [v, w] : sharp_edges_3(facets, marked, [&](const std::size_t p) { return to_vector(soup.points[p]); }))
  {
    ++result[v];
    ++result[w];
  }
  return result;
}

// Leaves out marked facets or edges that have a vertex twice, and notes this.
template <typename Simplices>
void remove_collapsed(Simplices& simplices, std::vector<int>& references, std::vector<Data_array_3>& data,
                      const char* const singular, const char* const plural, std::vector<std::string>& notes)
{
  std::vector<std::size_t> kept, collapsed;
  for(std::size_t i = 0; i < simplices.size(); ++i)
  {
    auto vertices = simplices[i];
    std::sort(vertices.begin(), vertices.end());
    (std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end() ? kept : collapsed).push_back(i);
  }
  if(collapsed.empty())
    return;
  notes.push_back(counted(collapsed.size(), singular, plural) + " a vertex twice and "
                  + (collapsed.size() == 1 ? "is" : "are") + " left out. The first one is at the vertex "
                  + std::to_string(simplices[collapsed[0]][0]) + " (counted from 0)");
  keep_elements(kept, simplices);
  keep_elements(kept, references);
  keep_elements(kept, data);
}

} // namespace internal

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// makes cells and marked facets, edges and corners use the first one of points with the same coordinates. The other points
/// stay without cells, and indices do not change.
///
/// \param soup the mesh
/// \param distance if it is not 0, points on the boundary that are at most this far from each other are joined, too
///
/// \return for each point, the first one of those that it is joined to; the point itself, if it has a place of its own
///
/// \exception Input_error as the functions for arrays, and if two vertices of a cell would be joined; the soup is then unchanged.
inline std::vector<std::size_t> merge_coinciding_points(Tetrahedron_soup_3& soup, const double distance = 0)
{
  internal::require(distance >= 0, "distance must not be negative.");
  internal::check_simplices(soup);
  std::vector<std::size_t> first = internal::first_coinciding_points(soup.points);
  if(distance > 0)
    first = internal::first_points_at_tears(soup, first, distance);
  internal::for_each_vertex(soup, [&](std::size_t& v) { v = first[v]; });
  return first;
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// removes each cell with the vertices of an earlier one, and adds a note to the soup. If the references of such cells differ,
/// the other references become the cell data `reference_2`, `reference_3`, ... of the cell that stays. The value 0 stands for
/// none.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, if TBB is linked, `Parallel_tag` or `Parallel_if_available_tag`
///
/// \return for each cell before, the first one with its four vertices
///
/// \exception Input_error as the functions for arrays; the soup is then unchanged.
template <typename ConcurrencyTag = Sequential_tag>
std::vector<std::size_t> merge_coinciding_cells(Tetrahedron_soup_3& soup)
{
  internal::check_simplices(soup);
  const std::vector<std::size_t> first = internal::first_coinciding_cells(soup.cells,
                                                                             internal::is_parallel<ConcurrencyTag>());
  const std::size_t n = soup.cells.size();
  std::vector<std::size_t> kept, repeated;
  for(std::size_t c = 0; c < n; ++c)
    (first[c] == c ? kept : repeated).push_back(c);
  if(repeated.empty())
    return first;
  std::vector<std::set<int> > references(n);
  std::size_t number_of_references = 1;
  for(const std::size_t c : repeated)
  {
    if(soup.cell_references[c] != soup.cell_references[first[c]])
      references[first[c]].insert(soup.cell_references[c]);
    number_of_references = (std::max)(number_of_references, 1 + references[first[c]].size());
  }
  for(std::size_t i = 2; i <= number_of_references; ++i)
  {
    soup.cell_data.push_back({ internal::name_of_reference(i), 1, true, std::vector<double>(n, 0) });
    for(std::size_t c = 0; c < n; ++c)
      if(references[c].size() + 1 >= i)
        soup.cell_data.back().values[c] = *std::next(references[c].begin(), static_cast<std::ptrdiff_t>(i - 2));
  }
  internal::keep_elements(kept, soup.cells);
  internal::keep_elements(kept, soup.cell_references);
  internal::keep_elements(kept, soup.cell_data);
  soup.notes.push_back(internal::counted(repeated.size(), "cell has the vertices of an earlier cell and is",
                                         "cells have the vertices of an earlier cell and are")
    + " left out. For example, cell " + std::to_string(repeated[0]) + " has those of cell "
    + std::to_string(first[repeated[0]]) + " (counted from 0)"
    + (number_of_references == 1 ? "" : ". Their references are the cell data '" + internal::name_of_reference(2)
        + (number_of_references == 2 ? "'" : "' to '" + internal::name_of_reference(number_of_references) + "'")
        + ", which files *.vtu and *.msh contain"));
  return first;
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// removes flat cells at the boundary if the boundary consists of the same points without them, and adds a note to the soup.
/// Delaunay triangulations have such cells where points of the boundary are in a plane or on a line. Flat cells inside stay.
/// Marked facets of cells that go do so, too.
///
/// \return the number of cells that were removed
///
/// \exception Input_error as the functions for arrays; the soup is then unchanged.
inline std::size_t remove_flat_boundary_cells(Tetrahedron_soup_3& soup)
{
  internal::check_simplices(soup);
  internal::Flat_boundary_cells_3 flat_cells(soup);
  const std::set<std::size_t> removed = flat_cells.run();
  if(removed.empty())
    return 0;
  std::vector<std::size_t> kept, kept_facets;
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    if(removed.count(c) == 0)
      kept.push_back(c);
  internal::keep_elements(kept, soup.cells);
  internal::keep_elements(kept, soup.cell_references);
  internal::keep_elements(kept, soup.cell_data);
  for(std::size_t f = 0; f < soup.facets.size(); ++f)
    if(!flat_cells.has_lost_cells(soup.facets[f]))
      kept_facets.push_back(f);
  internal::keep_elements(kept_facets, soup.facets);
  internal::keep_elements(kept_facets, soup.facet_references);
  internal::keep_elements(kept_facets, soup.facet_data);
  soup.notes.push_back(internal::counted(removed.size(), "flat cell at the boundary is", "flat cells at the boundary are")
                       + " left out. The boundary consists of the same points");
  return removed.size();
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// removes marks that contradict the shape of the boundary nearly everywhere, and adds a note to the soup. TetGen makes such
/// marks: it marks all points of its input as corners, and all edges between facets that are not in one plane. Marked facets and
/// edges that have a vertex twice go, too.
///
/// A vertex is no corner of the shape if the normals on both sides make 60 degrees or more at none or two of its edges. If more
/// than half of the vertices of the boundary are marked as corners, but are none, all marks of corners go. If more than half of
/// the vertices with marked edges have three or more of these, but are no corners, all marks of edges go.
///
/// \param soup the mesh, whose cells are all positive or all negative
///
/// \exception Input_error as the functions for arrays; the soup is then unchanged.
inline void remove_false_marks(Tetrahedron_soup_3& soup)
{
  internal::remove_collapsed(soup.facets, soup.facet_references, soup.facet_data, "marked triangle has", "marked triangles have",
                             soup.notes);
  internal::remove_collapsed(soup.edges, soup.edge_references, soup.edge_data, "marked edge has", "marked edges have", soup.notes);
  internal::check_simplices(soup);
  if(soup.corners.empty() && soup.edges.empty())
    return;
  const std::vector<std::array<std::size_t, 3> > facets = internal::boundary_facets_3(soup.cells);
  const std::vector<bool> is_on_boundary = internal::used_points(facets, soup.points.size());
  const auto sharp = internal::numbers_of_sharp_edges(soup, facets, {}),
             marked = internal::numbers_of_sharp_edges(soup, facets, soup.edges);
  const auto is_no_corner = [&](const std::size_t v) { return sharp.count(v) == 0 || sharp.at(v) == 2; };
  const auto are_false = [&](const std::ptrdiff_t number, const std::ptrdiff_t all, const char* marks, const char* what)
  {
    if(2 * number > all)
      soup.notes.push_back(std::to_string(number) + " vertices are " + what + " at places where the boundary has no corner. "
                           "The marks of " + marks + " are left out; TetGen makes such marks");
    return 2 * number > all;
  };
  if(are_false(std::count_if(soup.corners.begin(), soup.corners.end(),
                             [&](const std::size_t v) { return is_on_boundary[v] && is_no_corner(v); }),
               std::count(is_on_boundary.begin(), is_on_boundary.end(), true), "corners", "marked as corners"))
    soup.corners.clear();
  if(are_false(std::count_if(marked.begin(), marked.end(),
                             [&](const auto& vertex) { return vertex.second >= 3 && is_no_corner(vertex.first); }),
               static_cast<std::ptrdiff_t>(marked.size()), "edges", "ends of three or more marked edges"))
  {
    soup.edges.clear();
    soup.edge_references.clear();
    soup.edge_data.clear();
  }
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// separates parts of a body that touch each other at a vertex or an edge only. Each fan of cells that facets at the vertex join
/// gets a vertex of its own. The boundary is a manifold then, except where one fan touches itself. The time is linear in the
/// number of cells, but for those at such vertices.
///
/// \param soup the mesh, whose cells are all positive or all negative. The first fan keeps its vertex; points at the same
///        place for the other ones are appended, with the same data. Marked facets and edges follow their cells. An
///        edge or a corner in several fans becomes one for each.
///
/// \return for each appended point, the vertex that it was
///
/// \exception Input_error as the functions for arrays; the soup is then unchanged.
inline std::vector<std::size_t> separate_pinched_vertices(Tetrahedron_soup_3& soup)
{
  internal::check_simplices(soup);
  internal::Disjoint_sets fans = internal::fans_of_corners(soup);
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> first_fan(soup.points.size(), none), origins;
  std::map<std::size_t, std::size_t> vertex_of_fan;
  const std::vector<std::array<std::size_t, 4> > before = soup.cells;
  for(std::size_t corner = 0; corner < 4 * before.size(); ++corner)
  {
    const std::size_t v = before[corner / 4][corner % 4], fan = fans.find(corner);
    if(first_fan[v] == none)
      first_fan[v] = fan;
    if(first_fan[v] == fan)
      continue;
    const auto [entry, is_new] = vertex_of_fan.emplace(fan, soup.points.size());
    if(is_new)
    {
      origins.push_back(v);
      soup.points.push_back(std::array<double, 3>(soup.points[v]));
      internal::copy_data(v, soup.point_data);
    }
    soup.cells[corner / 4][corner % 4] = entry->second;
  }
  internal::renumber_facets(before, soup);
  if(!origins.empty())
    internal::renumber_edges(before, soup);
  const std::set<std::size_t> corners(soup.corners.begin(), soup.corners.end());
  for(std::size_t i = 0; i < origins.size(); ++i)
    if(corners.count(origins[i]) > 0)
      soup.corners.push_back(soup.points.size() - origins.size() + i);
  return origins;
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// does this for a complex. If there is such a vertex, the complex is built anew. Then handles are invalid, and marked facets
/// are those of the boundary and between subdomains only.
///
/// \tparam C3t3 as for `tetrahedron_soup_to_mesh_complex_3()`
///
/// \return the number of vertices that have been added
template <typename C3t3, typename = typename C3t3::Triangulation>
std::size_t separate_pinched_vertices(C3t3& c3t3)
{
  Tetrahedron_soup_3 soup;
  std::vector<typename C3t3::Triangulation::Vertex_handle> vertices;
  std::vector<typename C3t3::Triangulation::Cell_handle> cells;
  mesh_complex_3_to_tetrahedron_soup(c3t3, soup, vertices);
  const std::size_t number_of_new_vertices = separate_pinched_vertices(soup).size();
  if(number_of_new_vertices > 0)
    tetrahedron_soup_to_mesh_complex_3(soup, c3t3, vertices, cells);
  return number_of_new_vertices;
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// splits edges of the boundary with more than two facets. Gaps between cells touch each other there. Where facets join all cells
/// at both ends, `separate_pinched_vertices()` separates the cells at the new point only.
///
/// \param soup the mesh, whose cells are all positive; midpoints, or points near them, are appended
///
/// \return for each appended point, the ends of the edge
///
/// \exception Input_error as the functions for arrays; the soup is then unchanged.
inline std::vector<std::array<std::size_t, 2> > split_pinched_edges(Tetrahedron_soup_3& soup)
{
  internal::check_simplices(soup);
  internal::Body_3 body = internal::body_of_arrays(soup.points, soup.cells, soup.edges);
  std::vector<std::array<std::size_t, 2> > edges, result;
  internal::for_each_edge(body.boundary, [&](const auto begin, const auto end)
  {
    if(end - begin > 2)
      edges.push_back(begin->first);
  });
  internal::Refinement_3 refinement(body);
  std::vector<internal::Insertion_3> insertions;
  for(const auto& [v, w] : edges)
  {
    const internal::Simplex_3 edge = { v, w };
    if(const auto insertion = refinement.insert(edge, refinement.cells_around(edge)))
    {
      insertions.push_back(*insertion);
      result.push_back({ v, w });
    }
  }
  internal::insert_points(std::move(body), insertions, soup);
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_REPAIR_TETRAHEDRON_SOUP_H
