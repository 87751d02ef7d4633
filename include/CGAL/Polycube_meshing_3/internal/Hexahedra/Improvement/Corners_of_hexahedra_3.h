// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_CORNERS_OF_HEXAHEDRA_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_CORNERS_OF_HEXAHEDRA_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/scaled_jacobians.h>
#include <CGAL/Volume_mesh_parameterization/Power_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/minimize_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/minimize_untangling_energy_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// The aims for the corners of hexahedra, and how they are pursued.
struct Corner_goals_3
{
  Conditions_3 conditions;          // of each vertex
  std::vector<Vector_3> edges;      // of each corner: the lengths of its edges where it has right angles
  double mean_edge = 1;
  std::vector<Linear_constraint_3<int> > constraints; // where vertices are wanted, by their numbers
  double weight = 0;                       // of constraints: a residual of one edge costs as much as so many corners
  int exponent = 1;                        // of the energy: the larger, the more the worst corners count
  std::size_t number_of_steps = 1;         // with positive corners
};

// Number of corners per inverted one at which the last inverted corners are left to moves of single vertices: a guess.
constexpr std::size_t corners_per_last_inverted_one = 10000;

// Lengths that edges of a corner should have: their own ones, or the mean ones of the hexahedron along its axes.
enum class Goals_of_edges { OWN_LENGTHS, MEAN_LENGTHS };

// Corners of hexahedra as cells that overlap, with the order of vertices and corners that Newton's method has.
class Corners_of_hexahedra_3
{
public:
  using Corner = std::array<std::size_t, 4>; // its vertex, and the neighbors of this

  // Orders vertices and corners, of which corner k of hexahedron c has the user number 8 c + k. Takes whether each vertex stays.
  Corners_of_hexahedra_3(const Hexahedra_3& mesh, const std::vector<bool>& is_fixed, const bool is_parallel)
  {
    std::vector<std::array<int, 4> > corners;
    for_each_corner(mesh, [&](const Corner& corner)
    {
      corners.emplace_back();
      std::copy(corner.begin(), corner.end(), corners.back().begin());
    });
    Matrix3Xd points(3, mesh.points.size());
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
      points.col(v) = mesh.points[v];
    std::tie(m_numbered, m_order) = ordered_mesh_3(corners, points, is_fixed, is_parallel);
    for(const auto& [i, j, k, l] : m_numbered.cells)
      m_corners.push_back({ m_order[i], m_order[j], m_order[k], m_order[l] });
  }

  const std::vector<std::size_t>& order() const { return m_order; } // of vertices
  const std::vector<Corner>& corners() const { return m_corners; } // in the order that Newton's method has

  // Sets the mean edge, and the goals for edges, none of which is below a part of the mean edge. With own lengths, angles alone
  // count, as they do for scaled Jacobians.
  void set_edges(const std::vector<Vector_3>& points, const Goals_of_edges which, Corner_goals_3& goals) const
  {
    const bool are_own = which == Goals_of_edges::OWN_LENGTHS;
    const double shortest = are_own ? 0.05 : 0.5; // guesses; relative to the mean edge
    std::vector<Vector_3> mean_lengths(m_corners.size() / 8, Vector_3::Zero()); // of hexahedra
    const auto own_length = [&](const std::size_t corner, const int i)
    { return edge_matrix(points, m_corners[corner]).col(i).norm(); };
    const auto mean_length = [&](const std::size_t corner, const int i) -> double&
    {
      const std::array<std::size_t, 4>& vertices = corners_of_hexahedron[m_numbered.user_number(corner) % 8];
      return mean_lengths[m_numbered.user_number(corner) / 8][axis_of_edge(vertices[0], vertices[i + 1])];
    };
    for(std::size_t c = 0; c < m_corners.size(); ++c)
      for(int i = 0; i < 3; ++i)
        mean_length(c, i) += own_length(c, i) / 8; // each of the four edges along an axis has two corners
    goals.mean_edge = 0;
    for(const Vector_3& lengths : mean_lengths)
      goals.mean_edge += (lengths[0] + lengths[1] + lengths[2]) / 3 / static_cast<double>(mean_lengths.size());
    goals.edges.resize(m_corners.size());
    for(std::size_t c = 0; c < m_corners.size(); ++c)
      for(int i = 0; i < 3; ++i)
        goals.edges[c][i] = (std::max)(are_own ? own_length(c, i) : mean_length(c, i), shortest * goals.mean_edge);
  }

  // Returns better points: untangles corners, and if none is inverted then, brings them nearer to corners of boxes, all alike or
  // (with an exponent) the worst ones first. The search ends when only the last inverted corners are left, unless it began with
  // these. An exhausted budget ends it at the next step.
  std::vector<Vector_3> improved(std::vector<Vector_3> points, const Corner_goals_3& goals, Linear_solver_3& solver,
                                 const Budget& budget)
  {
    constexpr double theta = 0.5;                           // a guess; how much volumes count beside shapes
    constexpr std::size_t number_of_steps_to_untangle = 30; // a guess
    Conditions_3 conditions;
    for(const std::size_t v : m_order)
      conditions.push_back(goals.conditions[v]);
    Unknowns_3 unknowns(conditions);
    if(unknowns.size() == 0 || budget.is_exhausted())
      return points;
    m_numbered.target = m_numbered.source;
    for(std::size_t i = 0; i < m_order.size(); ++i)
      m_numbered.target.col(i) = points[m_order[i]];
    Scaled_cells_3 boxes = box_corners(goals);
    const Quadratic_penalty_3 penalty = penalty_of(goals, unknowns, boxes.scale);
    Newton_system_3 system(m_numbered, std::move(boxes), std::move(unknowns), solver, &penalty);
    Progress_3 untangling(budget, number_of_steps_to_untangle), progress(budget, goals.number_of_steps);
    system.step_along_tangents();
    Matrix3Xd positions = m_numbered.target;
    if(const std::size_t number = inverted_cells(m_numbered, positions).number; number > 0)
    {
      const std::size_t last = m_corners.size() / corners_per_last_inverted_one;
      positions = minimize_untangling_energy_3(system, positions, theta, untangling, number > last ? last : 0).positions;
    }
    if(inverted_cells(m_numbered, positions).number == 0)
    {
      const Untangling_energy_3 energy(0, theta); // its barrier: all corners are positive now
      positions = goals.exponent > 1
        ? minimize_energy_3(system, Cell_energy_of<Power_energy_3<Untangling_energy_3> >(Power_energy_3(goals.exponent, energy)),
                            positions, progress).positions
        : minimize_energy_3(system, Cell_energy_of<Untangling_energy_3>(energy), positions, progress).positions;
    }
    for(std::size_t i = 0; i < m_order.size(); ++i)
      points[m_order[i]] = positions.col(i);
    return points;
  }

private:
  // Returns cells whose references are corners of boxes, with the edges that are the goals.
  Scaled_cells_3 box_corners(const Corner_goals_3& goals) const
  {
    const double scale = scale_of_length(goals.mean_edge);
    Scaled_cells_3 result = { scale, {}, cell_weights(m_numbered) };
    for(const Vector_3& edges : goals.edges)
      result.inverse_sources.push_back(Matrix_3::diagonal((scale * edges).unaryExpr([](const double x) { return 1 / x; })));
    return result;
  }

  // Returns the penalty of the constraints on vertices that move, relative to a sum over corners with the energy 1 each. An edge
  // has a length near 1 / scale.
  Quadratic_penalty_3 penalty_of(const Corner_goals_3& goals, const Unknowns_3& unknowns, const double scale) const
  {
    const std::vector<int> index = inverse_order(m_order);
    std::vector<Linear_constraint_3<int> > result;
    for(Linear_constraint_3<int> constraint : goals.constraints)
    {
      for(auto& term : constraint.terms)
        term.vertex = index[term.vertex];
      if(std::any_of(constraint.terms.begin(), constraint.terms.end(),
                     [&](const auto& term) { return unknowns.contains(term.vertex); }))
        result.push_back(std::move(constraint));
    }
    return Quadratic_penalty_3(std::move(result), scale * scale * goals.weight / static_cast<double>(m_corners.size()), scale);
  }

  Numbered_mesh_3 m_numbered;
  std::vector<std::size_t> m_order;
  std::vector<Corner> m_corners; // in the order of the cells
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_CORNERS_OF_HEXAHEDRA_3_H
