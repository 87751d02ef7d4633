// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_SMOOTH_HEXAHEDRA_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_SMOOTH_HEXAHEDRA_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Best_hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Corners_of_hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Covered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <algorithm>
#include <limits>

namespace CGAL::Polycube_meshing_3::internal {

using Corners_of_vertex = std::vector<std::array<std::size_t, 4> >;    // corners that have the vertex
using Hexahedra_of_vertex = std::vector<std::array<std::size_t, 8> >; // hexahedra that have the vertex and are watched all over

constexpr double shortest_edge = 0.01; // whose direction counts fully, relative to the mean edge; a guess

// Returns the sum of squares of what scaled Jacobians lack to the target, or, if the sum reaches the bound, a part of the sum.
inline double shortage(const std::vector<Vector_3>& positions, const Corners_of_vertex& corners, const double mean_edge,
                       const double target, const double bound = (std::numeric_limits<double>::infinity)())
{
  double sum = 0;
  for(auto corner = corners.begin(); corner != corners.end() && sum < bound; ++corner)
    sum += std::pow((std::max)(0., target - scaled_jacobian(edge_matrix(positions, *corner), shortest_edge * mean_edge)), 2);
  return sum;
}

// Returns the sum of squares of what coefficients of Jacobian determinants lack to the bound of flat corners. Each coefficient is
// divided by the mean lengths of edges along the three axes. If all coefficients are positive, the determinants are, too.
inline double shortage_inside(const std::vector<Vector_3>& positions, const Hexahedra_of_vertex& hexahedra)
{
  double sum = 0;
  for(const std::array<std::size_t, 8>& hexahedron : hexahedra)
  {
    std::array<double, 3> lengths = {};
    for(const std::array<std::size_t, 4>& corner : corners_of_hexahedron)
      for(std::size_t i = 1; i < 4; ++i)
        lengths[axis_of_edge(corner[0], corner[i])]
          += (positions[hexahedron[corner[i]]] - positions[hexahedron[corner[0]]]).norm() / 8;
    const double volume = lengths[0] * lengths[1] * lengths[2];
    for(const double coefficient : jacobian_coefficients_3(points_of_hexahedron(positions, hexahedron)))
      sum += std::pow((std::max)(0., flat_scaled_jacobian - (volume > 0 ? coefficient / volume : 0)), 2);
  }
  return sum;
}

inline double least_scaled_jacobian(const std::vector<Vector_3>& positions, const Corners_of_vertex& corners)
{
  double least = 1;
  for(const std::array<std::size_t, 4>& corner : corners)
    least = (std::min)(least, scaled_jacobian(edge_matrix(positions, corner)));
  return least;
}

// Returns for each vertex its hexahedra that are not positive, or share a vertex with one that is not.
inline std::vector<Hexahedra_of_vertex> watched_hexahedra_3(const std::vector<Vector_3>& positions,
                                                            const std::vector<std::array<std::size_t, 8> >& hexahedra)
{
  std::vector<bool> is_at_inverted(positions.size(), false);
  for(const std::array<std::size_t, 8>& hexahedron : hexahedra)
    if(!is_positive_hexahedron(positions, hexahedron))
      for(const std::size_t v : hexahedron)
        is_at_inverted[v] = true;
  std::vector<Hexahedra_of_vertex> result(positions.size());
  for(const std::array<std::size_t, 8>& hexahedron : hexahedra)
    if(std::any_of(hexahedron.begin(), hexahedron.end(), [&](const std::size_t v) { return is_at_inverted[v]; }))
      for(const std::size_t v : hexahedron)
        result[v].push_back(hexahedron);
  return result;
}

// Returns for each vertex its positive hexahedra if all corners are positive, and none otherwise.
inline std::vector<Hexahedra_of_vertex> guarded_hexahedra_3(const Hexahedra_3& mesh, const Corners_of_vertex& corners)
{
  std::vector<Hexahedra_of_vertex> result(mesh.points.size());
  if(std::all_of(corners.begin(), corners.end(), [&](const auto& corner) { return is_positive_corner(mesh.points, corner); }))
    for(const std::array<std::size_t, 8>& hexahedron : mesh.cells)
      if(is_positive_hexahedron(mesh.points, hexahedron))
        for(const std::size_t v : hexahedron)
          result[v].push_back(hexahedron);
  return result;
}

// Returns the mean length of the edges of corners. An edge counts once for each of these corners that has it.
inline double mean_length_of_edges(const std::vector<Vector_3>& positions, const Corners_of_vertex& corners)
{
  double sum = 0;
  for(const std::array<std::size_t, 4>& corner : corners)
  {
    const Matrix_3 edges = edge_matrix(positions, corner);
    sum += edges.col(0).norm() + (edges.col(1).norm() + edges.col(2).norm());
  }
  return sum / (3. * static_cast<double>(corners.size()));
}

// Costs of the positions of vertices: the shortage at their corners to a goal, and the rest, which is the shortage inside of
// hexahedra and the price of uncovered points of the surfaces. Once all corners are positive, no hexahedron may become inverted
// inside. Refers to the points of the mesh, and follows their moves.
class Costs_of_positions_3
{
public:
  Costs_of_positions_3(const Corners_of_hexahedra_3& corners, const std::vector<Covered_surface_3>& covered,
                       const double price_of_uncovered, const Hexahedra_3& mesh)
    : m_points(mesh.points), m_corners(m_points.size()), m_hexahedra(watched_hexahedra_3(m_points, mesh.cells)),
      m_guarded(guarded_hexahedra_3(mesh, corners.corners())), m_covers(m_points.size()),
      m_edge(mean_length_of_edges(m_points, corners.corners())), m_price(price_of_uncovered)
  {
    for(const std::array<std::size_t, 4>& corner : corners.corners())
      for(const std::size_t v : corner)
        m_corners[v].push_back(corner);
    for(const Covered_surface_3& surface : covered)
      add_covers_3(surface, m_points, tolerance * m_edge, m_covers);
  }

  double of_corners(const std::size_t v, const double goal, const double bound = (std::numeric_limits<double>::infinity)()) const
  { return shortage(m_points, m_corners[v], m_edge, goal, bound); }

  double of_rest(const std::size_t v) const
  {
    return shortage_inside(m_points, m_hexahedra[v])
      + m_price * uncovered(m_points, m_covers[v], tolerance * m_edge) / (m_edge * m_edge);
  }

  // Returns whether the guarded hexahedra of a vertex are still positive.
  bool are_guarded_positive(const std::size_t v) const
  {
    return std::all_of(m_guarded[v].begin(), m_guarded[v].end(), [&](const std::array<std::size_t, 8>& hexahedron)
                       { return is_positive_hexahedron(m_points, hexahedron); });
  }

  const Corners_of_vertex& corners(const std::size_t v) const { return m_corners[v]; }

  // Calls f for the vertices whose costs depend on the position of a vertex, for some of them several times.
  template <typename Function>
  void for_each_vertex_near(const std::size_t v, const Function& f) const
  {
    for(const std::array<std::size_t, 4>& corner : m_corners[v])
      std::for_each(corner.begin(), corner.end(), f);
    for(const std::array<std::size_t, 8>& hexahedron : m_hexahedra[v])
      std::for_each(hexahedron.begin(), hexahedron.end(), f);
  }

private:
  static constexpr double tolerance = 0.3; // a guess; relative to the mean edge

  const std::vector<Vector_3>& m_points;
  std::vector<Corners_of_vertex> m_corners;
  const std::vector<Hexahedra_of_vertex> m_hexahedra, m_guarded;
  std::vector<Cover_of_vertex_3> m_covers;
  const double m_edge, m_price;
};

// Moves a vertex, which costs `cost` where it is, to the cheapest of 26 points of a grid around it, put where the vertex may be.
// Returns whether one of these points is cheaper; otherwise, the vertex stays.
inline bool move_to_cheapest_neighbor_3(const std::size_t v, const Position_3& position, const double step, const double goal,
                                        double cost, const Costs_of_positions_3& costs, std::vector<Vector_3>& points)
{
  const Vector_3 here = points[v];
  Vector_3 best = here;
  for(int i = 0; i < 27; ++i)
  {
    points[v] = position.nearest(here + step * Vector_3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
    double next = costs.of_corners(v, goal, cost);
    if(next < cost)
      next += costs.of_rest(v);
    if(next < cost && costs.are_guarded_positive(v))
    {
      cost = next;
      best = points[v];
    }
  }
  points[v] = best;
  return !(best == here);
}

// Moves vertices one after the other such that the scaled Jacobians of their corners come nearer to the target: local
// optimization (Freitag and Ollivier-Gooch 1997) by pattern search (Hooke and Jeeves 1961). Each uncovered point of the surfaces
// costs the price times its squared distance in mean edges; otherwise, vertices would leave tips. Vertices at corners that reach
// the target move for uncovered points alone, as far as the corners stay sufficient. Hexahedra that are not positive all over, and
// their neighbors, are improved inside, too.
inline void smooth_hexahedra_3(const Corners_of_hexahedra_3& corners, const std::vector<Position_3>& positions,
                               const std::vector<Covered_surface_3>& covered, const double target,
                               const double price_of_uncovered, const Budget& budget, Hexahedra_3& mesh)
{
  constexpr int number_of_sweeps = 10;                         // a guess
  constexpr double first_width = 0.25, smallest_width = 0.004; // guesses; relative to the edges
  std::vector<Vector_3>& points = mesh.points;
  const Costs_of_positions_3 costs(corners, covered, price_of_uncovered, mesh);
  std::vector<bool> is_settled(points.size(), false); // costs nothing, until a vertex near it moves
  std::vector<double> widths(points.size(), first_width);
  for(int sweep = 0; sweep < number_of_sweeps; ++sweep)
    for(const std::size_t v : corners.order())
    {
      if(positions[v].freedom == Freedom_3::NONE || widths[v] < smallest_width || is_settled[v] || budget.is_exhausted())
        continue;
      const double of_rest = costs.of_rest(v);
      double of_corners = costs.of_corners(v, target), goal = target;
      is_settled[v] = of_corners == 0 && of_rest == 0;
      if(is_settled[v])
        continue;
      if(of_corners == 0) // only the rest can become cheaper
      {
        goal = (std::max)(target, (std::min)(sufficient_scaled_jacobian, least_scaled_jacobian(points, costs.corners(v))));
        of_corners = costs.of_corners(v, goal);
      }
      const double step = widths[v] * mean_length_of_edges(points, costs.corners(v));
      if(move_to_cheapest_neighbor_3(v, positions[v], step, goal, of_corners + of_rest, costs, points))
        costs.for_each_vertex_near(v, [&](const std::size_t w) { is_settled[w] = false; });
      else
        widths[v] /= 2;
    }
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_SMOOTH_HEXAHEDRA_3_H
