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

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/scaled_jacobians.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Best_hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Covered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <limits>

namespace CGAL::Polycube_meshing_3::internal {

using Corners_of_vertex = std::vector<std::array<int, 4> >;    // corners that have the vertex
using Hexahedra_of_vertex = std::vector<std::array<int, 8> >; // hexahedra that have the vertex and are watched all over

constexpr double shortest_edge = 0.01; // that counts as one, relative to the mean edge; a guess

// Returns the sum of the squares by which scaled Jacobians are below the target, or a part of the sum that reaches the bound.
inline double shortage(const Matrix3Xd& positions, const Corners_of_vertex& corners, const double mean_edge,
                       const double target, const double bound = (std::numeric_limits<double>::infinity)())
{
  double sum = 0;
  for(auto corner = corners.begin(); corner != corners.end() && sum < bound; ++corner)
    sum += std::pow((std::max)(0., target - scaled_jacobian(edge_matrix(positions, *corner), shortest_edge * mean_edge)), 2);
  return sum;
}

// Returns the sum of the squares by which coefficients of the Jacobian determinants of hexahedra, by the mean lengths of their
// edges along the axes, are below the bound of flat ones: if all are positive, the determinants are.
inline double shortage_inside(const Matrix3Xd& positions, const Hexahedra_of_vertex& hexahedra)
{
  double sum = 0;
  for(const std::array<int, 8>& hexahedron : hexahedra)
  {
    std::array<double, 3> lengths = {};
    for(const std::array<std::size_t, 4>& corner : corners_of_hexahedron)
      for(std::size_t i = 1; i < 4; ++i)
        lengths[axis_of_edge(corner[0], corner[i])]
          += (positions.col(hexahedron[corner[i]]) - positions.col(hexahedron[corner[0]])).norm() / 8;
    const double volume = lengths[0] * lengths[1] * lengths[2];
    for(const double coefficient : jacobian_coefficients_3(points_of_hexahedron(positions, hexahedron)))
      sum += std::pow((std::max)(0., flat_scaled_jacobian - (volume > 0 ? coefficient / volume : 0)), 2);
  }
  return sum;
}

inline double least_scaled_jacobian(const Matrix3Xd& positions, const Corners_of_vertex& corners)
{
  double least = 1;
  for(const std::array<int, 4>& corner : corners)
    least = (std::min)(least, scaled_jacobian(edge_matrix(positions, corner)));
  return least;
}

// Returns for each vertex the hexahedra around it, as far as they have a vertex of one that is not positive.
inline std::vector<Hexahedra_of_vertex> watched_hexahedra_3(const Matrix3Xd& positions,
                                                            const std::vector<std::array<int, 8> >& hexahedra)
{
  std::vector<bool> is_at_inverted(positions.cols(), false);
  for(const std::array<int, 8>& hexahedron : hexahedra)
    if(!is_positive_hexahedron_3(points_of_hexahedron(positions, hexahedron)))
      for(const int v : hexahedron)
        is_at_inverted[v] = true;
  std::vector<Hexahedra_of_vertex> result(positions.cols());
  for(const std::array<int, 8>& hexahedron : hexahedra)
    if(std::any_of(hexahedron.begin(), hexahedron.end(), [&](const int v) { return is_at_inverted[v]; }))
      for(const int v : hexahedron)
        result[v].push_back(hexahedron);
  return result;
}

inline double mean_length_of_edges(const Matrix3Xd& positions, const Corners_of_vertex& corners)
{
  double sum = 0;
  for(const std::array<int, 4>& corner : corners)
    sum += Eigen::Matrix3d(edge_matrix(positions, corner)).colwise().norm().sum();
  return sum / (3. * static_cast<double>(corners.size()));
}

// Moves vertices one after the other, each to the best one of its 26 neighbors in a grid, where it may be, such that the
// scaled Jacobians of its corners come nearer to the target: local optimization (Freitag and Ollivier-Gooch 1997) by pattern
// search (Hooke and Jeeves 1961). Uncovered points of the surfaces have a price, or vertices would leave tips: a shortage by the
// root of the price costs as much as a point one mean edge away. Vertices near such points move for their sake alone, too,
// as far as that leaves good corners. Hexahedra that are not positive all over, and their neighbors, are improved inside, too.
inline void smooth_hexahedra_3(const std::vector<std::array<int, 4> >& corners,
                               const std::vector<std::array<int, 8> >& hexahedra, const std::vector<Freedom_3>& freedom,
                               const std::vector<const Body_surface_3*>& surfaces,
                               const std::vector<Covered_surface_3>& covered, const double target, const double price,
                               const Budget& budget, Matrix3Xd& positions)
{
  constexpr int number_of_sweeps = 10;                         // a guess
  constexpr double first_width = 0.25, smallest_width = 0.004; // guesses; relative to the edges
  constexpr double tolerance = 0.3;                            // a guess; relative to the mean edge
  constexpr double good_scaled_jacobian = 0.5;                 // a guess; up to there, corners are not made worse for far points
  std::vector<Corners_of_vertex> corners_of_vertex(freedom.size());
  for(const std::array<int, 4>& corner : corners)
    for(const int v : corner)
      corners_of_vertex[v].push_back(corner);
  const std::vector<Hexahedra_of_vertex> hexahedra_of_vertex = watched_hexahedra_3(positions, hexahedra);
  const double edge = mean_length_of_edges(positions, corners);
  std::vector<Cover_of_vertex_3> covers(freedom.size());
  for(const Covered_surface_3& surface : covered)
    add_covers_3(surface, positions, tolerance * edge, covers);
  const auto price_of_uncovered = [&](const std::size_t v)
  { return price * uncovered(positions, covers[v], tolerance * edge) / (edge * edge); };
  std::vector<double> widths(freedom.size(), first_width);
  for(int sweep = 0; sweep < number_of_sweeps; ++sweep)
    for(std::size_t v = 0; v < freedom.size() && !budget.is_exhausted(); ++v)
    {
      if(freedom[v] == Freedom_3::NONE || widths[v] < smallest_width)
        continue;
      const Corners_of_vertex& around = corners_of_vertex[v];
      const double inside = shortage_inside(positions, hexahedra_of_vertex[v]);
      const double missing = shortage(positions, around, edge, target), paid = inside + price_of_uncovered(v);
      if(missing == 0 && paid == 0)
        continue;
      const double goal
        = missing > 0 ? target : (std::max)(target, (std::min)(good_scaled_jacobian, least_scaled_jacobian(positions, around)));
      double least = (missing > 0 ? missing : shortage(positions, around, edge, goal)) + paid;
      const Eigen::Vector3d here = positions.col(v);
      Eigen::Vector3d best = here;
      const double step = widths[v] * mean_length_of_edges(positions, around);
      for(int i = 0; i < 27; ++i)
      {
        positions.col(v)
          = surfaces[v]->nearest(here + step * Eigen::Vector3d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1), freedom[v]);
        double next = shortage(positions, around, edge, goal, least);
        if(next < least)
          next += shortage_inside(positions, hexahedra_of_vertex[v]) + price_of_uncovered(v);
        if(next < least)
        {
          least = next;
          best = positions.col(v);
        }
      }
      positions.col(v) = best;
      if(best == here)
        widths[v] /= 2;
    }
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_SMOOTH_HEXAHEDRA_3_H
