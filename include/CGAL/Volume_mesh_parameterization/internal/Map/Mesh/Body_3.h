// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Vertex_condition_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/ranges.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/arguments.h>

#include <CGAL/property_map.h>

#include <boost/container/static_vector.hpp>
#include <boost/type_traits/is_detected.hpp>

#include <iterator>
#include <unordered_map>

namespace CGAL::Volume_mesh_parameterization::internal {

// Which points are vertices of facets or cells?
template <typename Simplices>
std::vector<bool> used_points(const Simplices& simplices, const std::size_t number_of_points)
{
  std::vector<bool> result(number_of_points, false);
  for(const auto& simplex : simplices)
    for(const std::size_t v : simplex)
      result[v] = true;
  return result;
}

// Some points with numbers of their own, in the order in which simplices have them.
struct Numbered_points
{
  std::vector<std::size_t> points;
  std::vector<int> numbers; // of all points, -1 for those without one

  template <typename Simplices>
  Numbered_points(const Simplices& simplices, const std::size_t number_of_points) : numbers(number_of_points, -1)
  {
    for(const auto& simplex : simplices)
      for(const std::size_t p : simplex)
        if(numbers[p] == -1)
        {
          numbers[p] = static_cast<int>(points.size());
          points.push_back(p);
        }
  }
};

// An edge, facet or cell, given by its two, three or four points. Those of a cell are in its order.
using Simplex_3 = boost::container::static_vector<std::size_t, 4>;

// A body as arrays: what complexes, and ranges of any types, become on their way to all algorithms.
struct Body_3
{
  Tetrahedron_soup_3 soup;
  std::vector<std::array<std::size_t, 3> > boundary; // the facets of one cell only
  std::vector<std::size_t> sides;                    // which sides these are, before any refinement
  Coordinate_type point_type;                        // in which the user stores the points, also those of refinement
  Coordinate_type image_type;                        // and the images
};

// A point that was made a vertex of an edge, facet or cell, and the cells around this, by their numbers then.
struct Insertion_3
{
  std::size_t point;
  Simplex_3 simplex;
  std::vector<std::size_t> cells;
};

// The vertices of sides of cells, counterclockwise seen from outside. Side `4 * c + i` is opposite to vertex i of cell c.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
std::vector<std::array<std::size_t, 3> > facets_of_sides(const std::vector<std::array<std::size_t, 4> >& cells,
                                                         const std::vector<std::size_t>& sides);

// Throws `Input_error` if indices are wrong, or facets have more than two cells or two on the same side.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE Body_3 body_of(Tetrahedron_soup_3 soup, bool is_parallel = false);

template <typename T>
constexpr bool is_soup = std::is_same<std::remove_const_t<T>, Tetrahedron_soup_3>::value;

template <typename Soup>
using If_soup = std::enable_if_t<is_soup<Soup> >;

template <typename PointRange, typename CellRange>
Body_3 body_of(const PointRange& points, const CellRange& cells) { return body_of(soup_of(points, cells)); }

template <typename C3t3>
using Edges_of_complex = decltype(std::declval<const C3t3&>().edges_in_complex_begin());

// No function of the concept: the number of feature edges, which saves a traversal of all edges.
template <typename C3t3>
using Number_of_edges = decltype(std::declval<const C3t3&>().number_of_edges_in_complex());

template <typename C3t3>
bool may_have_edges(const C3t3& c3t3)
{
  if constexpr(boost::is_detected<Number_of_edges, C3t3>::value)
    return c3t3.number_of_edges_in_complex() > 0;
  return true;
}

template <typename C3t3>
using Corners_of_complex = decltype(std::declval<const C3t3&>().vertices_in_complex_begin());

// Marks the edges of the 1-dimensional features of a complex, if it knows any, by the indices of the points of its vertices.
template <typename C3t3, typename Indices>
void mark_edges(const C3t3& c3t3, const Indices& indices, Tetrahedron_soup_3& soup)
{
  if constexpr(boost::is_detected<Edges_of_complex, C3t3>::value)
    if(may_have_edges(c3t3))
      for(auto it = c3t3.edges_in_complex_begin(); it != c3t3.edges_in_complex_end(); ++it)
      {
        const auto v = indices.find(it->first->vertex(it->second)), w = indices.find(it->first->vertex(it->third));
        if(v == indices.end() || w == indices.end())
          continue;
        soup.edges.push_back({ v->second, w->second });
        if constexpr(std::is_integral<typename C3t3::Curve_index>::value)
          soup.edge_references.push_back(static_cast<int>(c3t3.curve_index(*it)));
        else
          soup.edge_references.push_back(1);
      }
}

// Marks the 0-dimensional features, likewise.
template <typename C3t3, typename Indices>
void mark_corners(const C3t3& c3t3, const Indices& indices, Tetrahedron_soup_3& soup)
{
  if constexpr(boost::is_detected<Corners_of_complex, C3t3>::value)
  {
    std::vector<bool> is_corner(soup.points.size(), false); // the complex has corners in the order of their addresses
    for(auto it = c3t3.vertices_in_complex_begin(); it != c3t3.vertices_in_complex_end(); ++it)
      if(const auto v = indices.find(it); v != indices.end())
        is_corner[v->second] = true;
    for(std::size_t v = 0; v < is_corner.size(); ++v)
      if(is_corner[v])
        soup.corners.push_back(v);
  }
}

// The body of a complex, with its features as marked edges and corners, with references of cells 0, and the way back.
template <typename C3t3>
struct Body_of_complex_3 : Body_3
{
  static_assert(!is_periodic<typename C3t3::Triangulation>,
                "c3t3 must not be periodic: a vertex of a periodic triangulation has several points, and so several images.");
  using Vertex_handle = typename C3t3::Vertex_handle;

  std::vector<Vertex_handle> vertices; // of each point
  std::vector<typename C3t3::Cell_handle> cells;

  explicit Body_of_complex_3(const C3t3& c3t3)
  {
    point_type = coordinate_type<Coordinate_of<typename C3t3::Triangulation::Geom_traits::Point_3> >();
    std::unordered_map<Vertex_handle, std::size_t> indices;
    indices.reserve(c3t3.triangulation().number_of_vertices());
    for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    {
      cells.push_back(it);
      soup.cells.emplace_back();
      for(int i = 0; i < 4; ++i)
      {
        const Vertex_handle v = it->vertex(i);
        const auto [entry, is_new] = indices.emplace(v, vertices.size());
        soup.cells.back()[i] = entry->second;
        if(is_new)
        {
          vertices.push_back(v);
          soup.points.push_back(coordinates(point_of_vertex(c3t3.triangulation(), v)));
        }
        if(!c3t3.is_in_complex(it->neighbor(i)))
          sides.push_back(4 * (cells.size() - 1) + i);
      }
    }
    soup.cell_references.resize(cells.size());
    mark_edges(c3t3, indices, soup);
    mark_corners(c3t3, indices, soup);
    boundary = facets_of_sides(soup.cells, sides);
  }
};

template <typename NamedParameters>
constexpr bool has_conditions = !parameters::is_default_parameter<NamedParameters, internal_np::vertex_condition_t>::value;

// Prescription of the user for the points of a body. Without a target or an initial image, a point has coordinates that are not
// numbers.
struct Prescription_3
{
  std::vector<std::array<double, 3> > targets;
  std::vector<bool> is_constrained;            // inside, as those on the boundary are
  std::vector<Vertex_condition_3> conditions;  // in place of these; if there are no entries, the boundary is at its targets
  std::vector<std::array<double, 3> > initial; // images to start from; none of any point if there are no entries
  std::vector<Linear_constraint_3<std::size_t> > constraints;

  void extend_to(std::size_t number_of_points); // nothing is prescribed for new points
};

// Returns which points are vertices of cells, on the boundary or constrained, not free, and at their targets.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::vector<bool> points_of_cells(const Body_3& body);

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
std::vector<bool> prescribed_points(const Body_3& body, const std::vector<bool>& is_constrained = {});

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
std::vector<bool> prescribed_points(const Body_3& body, const Prescription_3& prescription);

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE std::vector<bool> fixed_points(const Body_3& body, const Prescription_3& prescription);

// Returns the target with 0 in place of missing coordinates that are not prescribed, or the nearest point of the surface.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
std::array<double, 3> completed_target(std::array<double, 3> target, const Vertex_condition_3& condition);

// Reads the named parameters about the vertices of a body. `vertex(p)` is what the user calls the point p of a cell.
template <typename Vertex, typename NamedParameters, typename TargetOfPoint, typename VertexOfPoint>
Prescription_3 prescription_3(const Body_3& body, const NamedParameters& np, const TargetOfPoint& target,
                              const VertexOfPoint& vertex)
{
  const std::size_t number_of_points = body.soup.points.size();
  const std::vector<bool> has_cell = points_of_cells(body);

  Prescription_3 result;
  result.extend_to(number_of_points);
  if constexpr(has_conditions<NamedParameters>)
  {
    const auto conditions = parameters::get_parameter(np, internal_np::vertex_condition_map);
    static_assert(Is_map_of<std::remove_const_t<decltype(conditions)>, Vertex>::value,
                  "vertex_condition_map must be a property map of vertices, whose values are Vertex_condition_3.");
    static_assert(parameters::is_default_parameter<NamedParameters, internal_np::vertex_is_constrained_t>::value
                  && parameters::is_default_parameter<NamedParameters, internal_np::do_slide_boundary_t>::value,
                  "vertex_condition_map replaces vertex_is_constrained_map and do_slide_boundary: pass one of them.");
    result.conditions.resize(number_of_points);
    for(std::size_t p = 0; p < number_of_points; ++p)
      if(has_cell[p])
        result.conditions[p] = get(conditions, vertex(p));
  }
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::vertex_is_constrained_t>::value)
  {
    const auto is_constrained = parameters::get_parameter(np, internal_np::vertex_is_constrained);
    for(std::size_t p = 0; p < number_of_points; ++p)
      if(has_cell[p])
        result.is_constrained[p] = get(is_constrained, vertex(p));
  }
  const std::vector<bool> is_prescribed = prescribed_points(body, result);
  for(std::size_t p = 0; p < number_of_points; ++p)
    if(has_cell[p] && is_prescribed[p])
    {
      const std::array<double, 3> point = coordinates(target(p));
      result.targets[p] = body.image_type.rounded_point(result.conditions.empty() ? point
                                                                                  : completed_target(point, result.conditions[p]));
    }
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::initial_map_t>::value)
  {
    const auto initial_map = parameters::get_parameter(np, internal_np::initial_map);
    static_assert(Is_map_of<std::remove_const_t<decltype(initial_map)>, Vertex>::value,
                  "initial_map must be a property map of vertices: for a container, pass make_vertex_point_map(container).");
    result.initial.resize(number_of_points);
    for(std::size_t p = 0; p < number_of_points; ++p)
      if(has_cell[p])
        result.initial[p] = coordinates(get(initial_map, vertex(p)));
  }
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::positional_constraints_t>::value)
  {
    std::unordered_map<Vertex, std::size_t> points;
    for(std::size_t p = 0; p < number_of_points; ++p)
      if(has_cell[p])
        points.emplace(vertex(p), p);
    const std::vector<Linear_constraint_3<Vertex> >& constraints
      = parameters::get_parameter(np, internal_np::positional_constraints);
    for(const Linear_constraint_3<Vertex>& constraint : constraints)
    {
      result.constraints.push_back({ {}, constraint.value });
      for(const auto& term : constraint.terms)
        result.constraints.back().terms.push_back({ points.at(term.vertex), term.coefficient });
    }
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_3_H
