// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors


#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_PROVE_CELLS_INFEASIBLE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_PROVE_CELLS_INFEASIBLE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/Infeasibility_proof_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/columns_around_origin.h>
#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/volume_polynomial_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Looks for factors that make these cells a proof, as a linear program with exact numbers.
inline std::optional<Infeasibility_proof_3> exact_proof(const Numbered_mesh_3& mesh,
                                                        const std::vector<std::size_t>& cells)
{
  const int slack = static_cast<int>(cells.size()); // what the sum of the volumes is below zero
  Quadratic_program<Exact_rational> program(CGAL::EQUAL, true, 0, false, 0);
  std::map<Coordinate_monomial, int> rows = {{constant_monomial, 0}};
  for(int i = 0; i < slack; ++i)
    for(const auto& term : exact_volume_polynomial_3(mesh, cells[i]))
      program.set_a(i, rows.emplace(term.first, static_cast<int>(rows.size())).first->second, term.second);
  program.set_a(slack, 0, 1);
  const int sum_of_factors = static_cast<int>(rows.size());
  for(int i = 0; i < slack; ++i)
    program.set_a(i, sum_of_factors, 1);
  program.set_b(sum_of_factors, 1);

  const auto solution = solve_linear_program(program, Exact_rational());
  if(solution.is_infeasible())
    return std::nullopt;
  Infeasibility_proof_3 proof;
  auto value = solution.variable_values_begin();
  for(const std::size_t c : cells)
  {
    if(!is_zero(value->numerator()))
    {
      proof.cells.push_back(c);
      proof.factors.push_back(value->numerator() / value->denominator());
    }
    ++value;
  }
  return proof;
}

// The volume polynomials as columns of unit length, in coordinates that suit the prescribed vertices,
// and a last column for the constant 1. A vector of values of the monomials that makes all cells positive
// has positive scalar products with the columns.
inline Eigen::MatrixXd volume_directions(const Numbered_mesh_3& mesh, const std::vector<std::size_t>& cells)
{
  std::vector<int> prescribed;
  for(const std::size_t c : cells)
    std::copy_if(mesh.cells[c].begin(), mesh.cells[c].end(), std::back_inserter(prescribed),
                 [&](const int v) { return !mesh.is_free(v); });
  const Eigen::Vector3d origin = mesh.target.col(prescribed.front());
  double radius = 0;
  for(const int v : prescribed)
    radius = (std::max)(radius, (mesh.target.col(v) - origin).norm());

  std::map<Coordinate_monomial, Eigen::Index> rows = {{constant_monomial, 0}};
  std::vector<Volume_polynomial_3<double> > polynomials;
  for(const std::size_t c : cells)
  {
    polynomials.push_back(volume_polynomial_3<double>(mesh, mesh.cells[c], [&](const int v, const int k)
    {
      return (mesh.target(k, v) - origin[k]) / radius;
    }));
    for(const auto& term : polynomials.back())
      rows.emplace(term.first, static_cast<Eigen::Index>(rows.size()));
  }

  const Eigen::Index n = static_cast<Eigen::Index>(cells.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), n + 1);
  for(Eigen::Index i = 0; i < n; ++i)
    for(const auto& term : polynomials[i])
      result(rows.at(term.first), i) = term.second;
  result(0, n) = 1;
  result.colwise().normalize();
  return result;
}

// Can these cells be positive together? Floating-point numbers find most places where they are, and a guess of the
// cells that matter when there is none.
inline std::optional<Infeasibility_proof_3> prove_cells_infeasible_3(const Numbered_mesh_3& mesh,
                                                                const std::vector<std::size_t>& cells)
{
  const std::vector<Eigen::Index> columns = columns_around_origin(volume_directions(mesh, cells));
  if(columns.empty())
    return std::nullopt;
  std::vector<std::size_t> guess;
  for(const Eigen::Index i : columns)
    if(i < static_cast<Eigen::Index>(cells.size()))
      guess.push_back(cells[i]);
  const std::optional<Infeasibility_proof_3> proof = exact_proof(mesh, guess);
  return proof ? proof : exact_proof(mesh, cells);
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_PROVE_CELLS_INFEASIBLE_3_H
