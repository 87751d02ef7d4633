// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_COORDINATES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_COORDINATES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_planes_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/ordered_coordinates_3.h>
#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

using Boundary_polygon_2 = std::vector<Boundary_point_2>;

// Returns whether an axis-parallel polygon turns left more often than right, as around a face and not around a hole. Its edges may
// intersect, while the function of CGAL asks for simple polygons.
inline bool is_outer(const Boundary_polygon_2& p)
{
  int left_turns = 0; // less those to the right
  for(std::size_t i = 0; i < p.size(); ++i)
    left_turns += CGAL::orientation(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]);
  return left_turns > 0;
}

// Returns whether disjoint polygons are an outer one and its holes, which lead clockwise inside of it and outside of each other.
inline bool are_nested(std::vector<Boundary_polygon_2> polygons)
{
  const auto is_inside = [](const Boundary_polygon_2& inner, const Boundary_polygon_2& outer)
  { return CGAL::bounded_side_2(outer.begin(), outer.end(), inner.front()) == ON_BOUNDED_SIDE; };
  const auto first_hole = std::partition(polygons.begin(), polygons.end(), is_outer);
  const auto is_hole = [&](const Boundary_polygon_2& p)
  {
    return is_inside(p, polygons.front()) && std::none_of(first_hole, polygons.end(), [&](const Boundary_polygon_2& other)
                                                          { return &other != &p && is_inside(p, other); });
  };
  return first_hole - polygons.begin() == 1 && std::all_of(first_hole, polygons.end(), is_hole);
}

// Finds the coordinates of the planes of a polycube, along their axes, that minimize
//   sum over planes p of area(p) (x(p) - wanted coordinate of p)^2
// such that each edge of the polycube has at least a part of the length of its chain. Each axis has a quadratic program. Edges of
// a face that intersect then get the order that their chains have on the surface, too, if the other orders allow this.
class Polycube_coordinates_3
{
public:
  Polycube_coordinates_3(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts, const Polycube_planes_3& planes,
                         const Plane_grid_3& grid, const Budget& budget)
    : m_mesh(mesh), m_charts(charts), m_planes(planes), m_grid(grid), m_budget(budget),
      m_coordinate(planes.size()), m_borders(charts.borders()), m_order(planes.size())
  {}

  // Finds the coordinates that are closest to the wanted ones of the planes. Returns whether there are any.
  bool run(const std::vector<double>& wanted)
  {
    for(const Polycube_chain_3& chain : m_charts.chains())
      m_edges.emplace_back(chain, *this);
    for(const Edge& edge : m_edges)
      add_order({ edge.lowest[edge.axis], edge.highest[edge.axis], smallest_part * edge.length });
    do
      for(int axis = 0; axis < 3; ++axis)
        if(m_budget.is_exhausted() || (!m_is_solved[axis] && !solve(axis, wanted)))
          return false;
    while(enclose_holes() || separate_intersecting_edges());
    join_equal_coordinates();
    return m_is_separable && are_faces_polygons_with_holes();
  }

  // Returns the coordinate of the plane of each chart.
  std::vector<double> of_charts() const
  {
    std::vector<double> result;
    for(std::size_t c = 0; c < m_charts.number_of_charts(); ++c)
      result.push_back(m_coordinate[m_planes[c]]);
    return result;
  }

  // Returns the grid that the coordinates are on, which run() may have moved.
  const Plane_grid_3& grid() const { return m_grid; }

private:
  using Border = std::vector<Polycube_charts_3::Vertex>;

  // Edge of the polycube, with the box and the length of its chain on the surface.
  struct Edge
  {
    int axis;
    std::array<std::size_t, 2> charts;
    std::array<std::size_t, 3> lowest, highest; // planes at the ends that are lowest and highest along the edge, by axis
    Box_3 box;
    double length;

    Edge(const Polycube_chain_3& chain, const Polycube_coordinates_3& coordinates)
      : axis(chain.axis), charts(chain.charts)
    {
      const std::vector<Polycube_charts_3::Vertex> path = coordinates.m_charts.vertices(chain);
      lowest = coordinates.m_planes.at(path.front());
      highest = coordinates.m_planes.at(path.back());
      if(chain.sign < 0)
        lowest.swap(highest);
      for(const Polycube_charts_3::Vertex v : path)
        box.extend(to_vector(coordinates.m_mesh.point(v)));
      length = arc_lengths(coordinates.m_mesh, path).back();
    }

    bool has_corner_with(const Edge& other) const
    { return lowest == other.lowest || lowest == other.highest || highest == other.lowest || highest == other.highest; }
  };

  // Finds the coordinates along an axis by its quadratic program for the orders so far. Returns whether there are any.
  bool solve(const int axis, const std::vector<double>& wanted)
  {
    std::vector<std::size_t> planes, variables(m_planes.size());
    std::vector<double> areas, moments;
    for(std::size_t p = 0; p < m_planes.size(); ++p)
      if(m_planes.axis(p) == axis)
      {
        variables[p] = planes.size();
        planes.push_back(p);
        areas.push_back(m_planes.areas()[p]);
        moments.push_back(areas.back() * wanted[p]);
      }
    std::vector<Order_of_coordinates> orders;
    for(const auto& [first, second, distance] : m_orders)
      if(m_planes.axis(first) == axis)
        orders.push_back({ variables[first], variables[second], distance });
    const std::optional<Ordered_coordinates> coordinates = ordered_coordinates_3(areas, moments, orders, m_grid, axis);
    if(!coordinates)
      return false;
    for(std::size_t i = 0; i < planes.size(); ++i)
      m_coordinate[planes[i]] = coordinates->values[i];
    m_grid.origin[axis] = coordinates->origin;
    m_is_solved[axis] = true;
    return true;
  }

  // Joins coordinates that differ by rounding alone. Bodies side by side may have such planes, and hexahedra between them would be
  // slivers.
  void join_equal_coordinates()
  {
    constexpr double rounding = 1e-12;               // the longest side of the body is 1
    std::vector<std::size_t> order(m_planes.size()); // of planes, by axis and coordinate
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [this](const std::size_t p, const std::size_t q)
    { return std::pair(m_planes.axis(p), m_coordinate[p]) < std::pair(m_planes.axis(q), m_coordinate[q]); });
    for(std::size_t i = 1; i < order.size(); ++i)
      if(const double previous = m_coordinate[order[i - 1]];
         m_planes.axis(order[i]) == m_planes.axis(order[i - 1]) && m_coordinate[order[i]] - previous < rounding)
        m_coordinate[order[i]] = previous;
  }

  // Adds an order of two planes. Their axis must be solved again.
  void add_order(const Order_of_coordinates& order)
  {
    m_orders.push_back(order);
    m_is_solved[m_planes.axis(order.first)] = false;
    m_order.add(order.first, order.second);
  }

  // Adds orders that keep holes of faces between the lowest and the highest edges of the outer polygons. Returns whether there are
  // any new ones, all of them possible.
  bool enclose_holes()
  {
    const std::size_t n = m_orders.size();
    for(std::size_t c = 0; c < m_borders.size(); ++c)
    {
      const std::vector<Border>& borders = m_borders[c];
      if(borders.size() < 2)
        continue;
      const auto outer = std::find_if(borders.begin(), borders.end(), [&](const Border& border)
                                      { return is_outer(image(border, m_charts.plane_axes(c))); });
      for(auto hole = borders.begin(); hole != borders.end() && outer != borders.end(); ++hole)
        for(const int axis : m_charts.plane_axes(c))
          if(hole != outer)
            enclose(extent(*hole, axis), extent(*outer, axis), c);
    }
    return m_is_separable && m_orders.size() > n;
  }

  using Extent = std::array<std::size_t, 2>; // planes with the lowest and the highest coordinate

  Extent extent(const Border& border, const int axis) const
  {
    const auto [lowest, highest] = std::minmax_element(border.begin(), border.end(), [&](const auto v, const auto w)
    { return m_coordinate[m_planes.at(v)[axis]] < m_coordinate[m_planes.at(w)[axis]]; });
    return { m_planes.at(*lowest)[axis], m_planes.at(*highest)[axis] };
  }

  double length_of_shortest_chain(const std::size_t chart) const
  {
    double result = (std::numeric_limits<double>::infinity)();
    for(const Edge& edge : m_edges)
      if(edge.charts[0] == chart || edge.charts[1] == chart)
        result = (std::min)(result, edge.length);
    return result;
  }

  // Adds the orders that the extents of a hole and of the outer border do not have yet.
  void enclose(const Extent& hole, const Extent& outer, const std::size_t chart)
  {
    for(const auto& [low, high] : { std::pair(outer[0], hole[0]), std::pair(hole[1], outer[1]) })
      if(m_is_separable && !(m_coordinate[low] < m_coordinate[high]))
      {
        m_is_separable = m_order.may_precede(low, high);
        add_order({ low, high, smallest_part * length_of_shortest_chain(chart) });
      }
  }

  // Adds orders for edges of a face that intersect. Returns whether there are any new ones, all of them possible.
  bool separate_intersecting_edges()
  {
    const std::size_t n = m_orders.size();
    for(std::size_t i = 0; i < m_edges.size(); ++i)
      for(std::size_t k = 0; k < i && m_is_separable; ++k)
        for(const std::size_t c : m_edges[i].charts)
          if((c == m_edges[k].charts[0] || c == m_edges[k].charts[1]) && do_intersect(m_edges[i], m_edges[k]))
            separate(m_edges[i], m_edges[k], c);
    return m_is_separable && m_orders.size() > n;
  }

  // Returns whether the images of two edges without a common corner intersect.
  bool do_intersect(const Edge& a, const Edge& b) const
  {
    for(int axis = 0; axis < 3; ++axis)
      if(m_coordinate[a.highest[axis]] < m_coordinate[b.lowest[axis]]
         || m_coordinate[b.highest[axis]] < m_coordinate[a.lowest[axis]])
        return false;
    return !a.has_corner_with(b);
  }

  // Adds the order of two edges of a face that is still possible and in which the gap between their chains is largest.
  void separate(const Edge& a, const Edge& b, const std::size_t chart)
  {
    Order_of_coordinates order = {};
    double largest_gap = -(std::numeric_limits<double>::infinity)();
    for(const int axis : m_charts.plane_axes(chart))
      for(const auto& [low, high] : { std::tie(a, b), std::tie(b, a) })
        if(const double gap = high.box.smallest[axis] - low.box.largest[axis];
           gap > largest_gap && m_order.may_precede(low.highest[axis], high.lowest[axis]))
        {
          largest_gap = gap;
          order = { low.highest[axis], high.lowest[axis], smallest_part * (std::min)(a.length, b.length) };
        }
    m_is_separable = std::isfinite(largest_gap);
    if(m_is_separable)
      add_order(order);
  }

  // Returns whether each face has one outer polygon, with its other polygons inside.
  bool are_faces_polygons_with_holes() const
  {
    for(std::size_t c = 0; c < m_borders.size(); ++c)
    {
      std::vector<Boundary_polygon_2> polygons;
      for(const Border& border : m_borders[c])
        polygons.push_back(image(border, m_charts.plane_axes(c)));
      if(!are_nested(std::move(polygons)))
        return false;
    }
    return true;
  }

  // Returns the polygon on the polycube that a border is mapped to, in the plane of two axes.
  Boundary_polygon_2 image(const Border& border, const std::array<int, 2>& axes) const
  {
    Boundary_polygon_2 result;
    for(const auto v : border)
    {
      const std::array<std::size_t, 3> planes = m_planes.at(v);
      result.emplace_back(m_coordinate[planes[axes[0]]], m_coordinate[planes[axes[1]]]);
    }
    return result;
  }

  static constexpr double smallest_part = 0.2; // a guess; length of an edge of the polycube, relative to its chain

  const Boundary_mesh_3& m_mesh;
  const Polycube_charts_3& m_charts;
  const Polycube_planes_3& m_planes;
  Plane_grid_3 m_grid;
  const Budget& m_budget;
  std::vector<double> m_coordinate; // by plane
  std::array<bool, 3> m_is_solved = {}; // by axis: do the coordinates fulfil all orders?
  const std::vector<std::vector<Border> > m_borders; // of the charts
  std::vector<Edge> m_edges;
  std::vector<Order_of_coordinates> m_orders;
  Order_of_elements m_order;  // of the planes
  bool m_is_separable = true; // false once planes cannot get an order that they need
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_POLYCUBE_COORDINATES_3_H
