// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_EXPANSION_RELAX_VERTICES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_EXPANSION_RELAX_VERTICES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Energies/Untangling_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Expansion/Core_map_3.h>

#include <limits>
#include <map>
#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// The conformal energy |J|^2 / chi(D)^(2/3) of cells as a function of the image of one of their vertices, J from a regular cell,
// D = det J. With J linear in p and chi' = dchi / dD as a constant, the Hessian is positive definite.
struct Vertex_energy_3
{
  double value = 0;
  Vector_3 gradient = Vector_3::Zero();
  Matrix_3 hessian = Matrix_3::Zero();

  // Adds a cell with the image p, and the edges P from there to the others. With epsilon = 0, inverted cells are infinite.
  void add(const Matrix_3& P, const double epsilon)
  {
    static const Matrix_3 inverse = regular_edges().inverse();
    constexpr double inverse_determinant = 0.5, row_sum = 0.5; // of `inverse`
    const double D = inverse_determinant * P.determinant();
    if(epsilon == 0 && !(D > 0))
    {
      value = std::numeric_limits<double>::infinity();
      return;
    }
    const Matrix_3 J = P * inverse;
    const double chi = regularized_determinant(D, epsilon), slope = chi / std::sqrt(D * D + epsilon * epsilon);
    const double square = CGAL::square(J.norm()), power = 1 / std::cbrt(chi * chi);
    const Vector_3 of_square = -2 * row_sum * (J.col(0) + J.col(1) + J.col(2));
    const Vector_3 of_chi = -slope * inverse_determinant * (P.col(1) - P.col(0)).cross(P.col(2) - P.col(0));
    value += power * square;
    gradient += power * (of_square - 2. / 3 * square / chi * of_chi);
    hessian += power * (6 * row_sum * row_sum * Matrix_3::Identity()
                        - 2. / 3 / chi * (Matrix_3::outer_product(of_square, of_chi) + Matrix_3::outer_product(of_chi, of_square))
                        + 10. / 9 * square / (chi * chi) * Matrix_3::outer_product(of_chi, of_chi));
  }
};

// The energy of the cells at a vertex with its image at p, in a unit of length.
inline Vertex_energy_3 energy_at_vertex_3(const Core_map_3& core, const int v, const Vector_3& p, const double unit,
                                          const double epsilon)
{
  Vertex_energy_3 result;
  for(const Core_map_3::Side& side : core.sides(v))
    if(core.is_open(side.cell))
      result.add(1 / unit * core.edges_from(p, core.facet(side)), epsilon);
  return result;
}

// Moves a vertex by a Newton step that lowers the energy of its cells, if there is one.
inline void relax_vertex_3(Core_map_3& core, const int v, const double unit = 1, const double epsilon = 0)
{
  constexpr double sufficient_decrease = 1e-4; // a guess
  const Vector_3 start = core.position(v);
  const Vertex_energy_3 energy = energy_at_vertex_3(core, v, start, unit, epsilon);
  const Vector_3 d = -(unit * (energy.hessian.inverse() * energy.gradient));
  const double slope = energy.gradient.dot(d) / unit;
  for(double length = 1; length > 1e-3; length /= 2)
    if(const Vector_3 p = start + length * d;
       energy_at_vertex_3(core, v, p, unit, epsilon).value < energy.value + sufficient_decrease * length * slope)
    {
      core.set_position(v, p);
      return;
    }
}

// Moves a vertex that has just left the core, and its neighbors outside.
inline void relax_around_3(Core_map_3& core, const int v)
{
  constexpr int number_of_sweeps = 3; // a guess
  const std::vector<int> neighbors = core.neighbors(v);
  for(int sweep = 0; sweep < number_of_sweeps; ++sweep)
  {
    relax_vertex_3(core, v);
    for(const int w : neighbors)
      if(core.moves(w))
        relax_vertex_3(core, w);
  }
}

// Moves a vertex and two rings around it until none of their cells is inverted or nearly flat. Returns whether that is so.
// Otherwise, they are where they were.
inline bool untangle_around_3(Core_map_3& core, const int v)
{
  constexpr int number_of_rings = 2, number_of_sweeps = 40; // guesses
  std::set<int> moving = { v };
  for(int ring = 0; ring < number_of_rings; ++ring)
    for(const int u : std::vector<int>(moving.begin(), moving.end()))
      for(const int w : core.neighbors(u))
        if(core.moves(w))
          moving.insert(w);
  std::set<int> cells;
  std::map<int, Vector_3> before;
  for(const int u : moving)
  {
    before.emplace(u, core.position(u));
    for(const Core_map_3::Side& side : core.sides(u))
      if(core.is_open(side.cell))
        cells.insert(side.cell);
  }
  const double unit = core.distance_of_neighbors(v);
  for(int sweep = 0; sweep < number_of_sweeps; ++sweep)
  {
    double smallest = std::numeric_limits<double>::infinity();
    bool are_positive = true;
    for(const int c : cells)
    {
      smallest = (std::min)(smallest, core.volume(c) / (unit * unit * unit));
      are_positive = are_positive && core.is_positive(c);
    }
    if(are_positive)
      return true;
    const double epsilon = first_epsilon(smallest / 2);
    for(const int u : moving)
      relax_vertex_3(core, u, unit, epsilon);
  }
  for(const auto& [u, p] : before)
    core.set_position(u, p);
  return false;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_EXPANSION_RELAX_VERTICES_3_H
