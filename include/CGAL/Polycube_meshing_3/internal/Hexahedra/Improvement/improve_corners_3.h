// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_IMPROVE_CORNERS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_IMPROVE_CORNERS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/scaled_jacobians.h>
#include <CGAL/Volume_mesh_parameterization/Power_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/minimize_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/minimize_untangling_energy_3.h>

namespace CGAL::Polycube_meshing_3::internal {

// The aims for the corners of hexahedra, and how they are pursued.
struct Corner_goals_3
{
  std::vector<Matrix_3> projectors; // of each vertex, onto the directions in which it moves
  std::vector<Eigen::Vector3d> edges;      // of each corner: the lengths of its edges where it has right angles
  double mean_edge = 1;
  std::vector<Linear_constraint_3<int> > constraints; // where vertices are wanted
  double weight = 0;                       // of constraints: how many corners a residual of one edge costs as much as
  int exponent = 1;                        // of the energy: the larger, the more the worst corners count
  std::size_t number_of_steps = 1;         // with positive corners
};

// Sets the goal for edges: their own lengths at each corner, so that angles alone count, as they do for scaled Jacobians; or the
// mean lengths of the edges of a hexahedron along each axis. Short ones have a bound.
inline void set_edges(const Numbered_mesh_3& mesh, const bool are_own, Corner_goals_3& goals)
{
  const double shortest = are_own ? 0.05 : 0.5; // guesses; relative to the mean edge
  std::vector<Eigen::Vector3d> edges(mesh.cells.size() / 8, Eigen::Vector3d::Zero());
  const auto own_length = [&](const std::size_t corner, const std::size_t i)
  { return edge_matrix(mesh.target, mesh.cells[corner]).col(static_cast<int>(i)).norm(); };
  const auto mean_length = [&](const std::size_t corner, const std::size_t i) -> double&
  {
    const std::array<std::size_t, 4>& vertices = corners_of_hexahedron[mesh.user_number(corner) % 8];
    return edges[mesh.user_number(corner) / 8][axis_of_edge(vertices[0], vertices[i + 1])];
  };
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    for(std::size_t i = 0; i < 3; ++i)
      mean_length(c, i) += own_length(c, i) / 8;
  goals.mean_edge = 0;
  for(const Eigen::Vector3d& lengths : edges)
    goals.mean_edge += lengths.mean() / static_cast<double>(edges.size());
  goals.edges.resize(mesh.cells.size());
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    for(std::size_t i = 0; i < 3; ++i)
      goals.edges[c][i] = (std::max)(are_own ? own_length(c, i) : mean_length(c, i), shortest * goals.mean_edge);
}

// Returns cells whose references are corners of boxes, with the edges that are the goals.
inline Scaled_cells_3 box_corners_3(const Numbered_mesh_3& mesh, const Corner_goals_3& goals)
{
  const double scale = scale_of_length(goals.mean_edge);
  Scaled_cells_3 result = { scale, {}, cell_weights(mesh) };
  for(const Eigen::Vector3d& edges : goals.edges)
    result.inverse_sources.push_back((scale * edges).cwiseInverse().asDiagonal());
  return result;
}

// Returns the penalty of the constraints on vertices that move, relative to a sum over corners with the energy 1 each. An edge
// has a length near 1 / scale.
inline Quadratic_penalty_3 penalty_of_goals_3(const Numbered_mesh_3& mesh, const Corner_goals_3& goals,
                                              const Unknowns_3& unknowns, const double scale)
{
  std::vector<Linear_constraint_3<int> > result;
  std::copy_if(goals.constraints.begin(), goals.constraints.end(), std::back_inserter(result),
               [&](const Linear_constraint_3<int>& constraint)
  {
    return std::any_of(constraint.terms.begin(), constraint.terms.end(),
                       [&](const auto& term) { return unknowns.contains(term.vertex); });
  });
  return Quadratic_penalty_3(std::move(result), scale * scale * goals.weight / static_cast<double>(mesh.cells.size()), scale);
}

// Moves the vertices of hexahedra, whose corners are the cells and overlap, starting at their targets: untangles corners, and
// if none is inverted then, brings them nearer to corners of boxes, all alike or (with an exponent) the worst ones first. An
// exhausted budget ends the search at the next step. Vertices that are not free stay.
inline Matrix3Xd improve_corners_3(const Numbered_mesh_3& mesh, const Corner_goals_3& goals, Linear_solver_3& solver,
                                   const Budget& budget)
{
  constexpr double theta = 0.5;                           // a guess; how much volumes count beside shapes
  constexpr std::size_t number_of_steps_to_untangle = 30; // a guess
  Unknowns_3 unknowns(goals.projectors);
  if(unknowns.size() == 0 || budget.is_exhausted())
    return mesh.target;
  Scaled_cells_3 boxes = box_corners_3(mesh, goals);
  const Quadratic_penalty_3 penalty = penalty_of_goals_3(mesh, goals, unknowns, boxes.scale);
  Newton_system_3 system(mesh, std::move(boxes), std::move(unknowns), solver, &penalty);
  Progress_3 untangling(budget, number_of_steps_to_untangle), progress(budget, goals.number_of_steps);
  Matrix3Xd positions = mesh.target;
  if(inverted_cells(mesh, positions).number > 0)
    positions = minimize_untangling_energy_3(system, positions, theta, untangling).positions;
  if(inverted_cells(mesh, positions).number > 0)
    return positions;
  const Untangling_energy_3 energy(0, theta); // its barrier: all corners are positive now
  return goals.exponent > 1
    ? minimize_energy_3(system, Cell_energy_of<Power_energy_3<Untangling_energy_3> >(Power_energy_3(goals.exponent, energy)),
                        positions, progress).positions
    : minimize_energy_3(system, Cell_energy_of<Untangling_energy_3>(energy), positions, progress).positions;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_IMPROVE_CORNERS_3_H
