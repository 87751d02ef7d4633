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
#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/volume_form_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <CGAL/Exact_rational.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// A vector that spans the null space of a matrix with exact numbers, given by rows; none if its dimension is not 1.
inline std::vector<Exact_rational> null_vector(std::vector<std::vector<Exact_rational> > rows, const std::size_t n)
{
  std::vector<std::size_t> pivots; // the column of each row that has been eliminated
  for(std::size_t column = 0; column < n; ++column)
  {
    const std::size_t r = pivots.size();
    const auto pivot = std::find_if(rows.begin() + r, rows.end(), [&](const auto& row) { return !is_zero(row[column]); });
    if(pivot == rows.end())
      continue;
    std::swap(rows[r], *pivot);
    for(std::size_t k = 0; k < rows.size(); ++k)
      if(k != r && !is_zero(rows[k][column]))
      {
        const Exact_rational factor = rows[k][column] / rows[r][column];
        for(std::size_t j = column; j < n; ++j)
          rows[k][j] -= factor * rows[r][j];
      }
    pivots.push_back(column);
  }
  if(pivots.size() + 1 != n)
    return {};
  std::size_t free = 0; // the column without a pivot
  while(free < pivots.size() && pivots[free] == free)
    ++free;
  std::vector<Exact_rational> result(n, Exact_rational(0));
  result[free] = 1;
  for(std::size_t r = 0; r < pivots.size(); ++r)
    result[pivots[r]] = -rows[r][free] / rows[r][pivots[r]];
  return result;
}

// The exact factors with which these cells are a proof, if there are any: up to a common one they are unique, as the cells
// are those of a simplex around the origin. A further column, if wanted, is what the sum of the volumes is below zero.
inline std::optional<Infeasibility_proof_3> exact_proof(const Numbered_mesh_3& mesh,
                                                        const std::vector<std::size_t>& cells, const bool has_slack)
{
  const std::size_t n = cells.size() + has_slack;
  const std::set<int> free = free_vertices_of(mesh, cells);
  std::vector<std::vector<Exact_rational> > rows(10, std::vector<Exact_rational>(n, Exact_rational(0)));
  for(std::size_t i = 0; i < cells.size(); ++i)
  {
    const Volume_form_3<Exact_rational> form = exact_volume_form_3(mesh, cells[i], *free.begin());
    for(std::size_t k = 0; k < form.size(); ++k)
      rows[k][i] = form[k];
  }
  if(has_slack)
    rows[0].back() = 1;
  Infeasibility_proof_3 proof = { cells, null_vector(std::move(rows), n) };
  if(proof.factors.empty())
    return std::nullopt;
  proof.factors.resize(cells.size());
  if(proof.factors.front() < 0)
    for(Exact_rational& factor : proof.factors)
      factor = -factor;
  return proof; // to be checked
}

// The volume forms as columns of unit length, in coordinates that suit the prescribed vertices,
// and a last column for the constant 1. A vector of values of 1, u, v and u x v that makes all cells positive
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
  const auto point = [&](const int v)
  {
    const Eigen::Vector3d p = (mesh.target.col(v) - origin) / radius;
    return std::array<double, 3>{ p[0], p[1], p[2] };
  };

  const int u = *free_vertices_of(mesh, cells).begin();
  const Eigen::Index n = static_cast<Eigen::Index>(cells.size());
  Eigen::MatrixXd result(10, n + 1);
  for(Eigen::Index i = 0; i < n; ++i)
  {
    const Volume_form_3<double> form = volume_form_3<double>(mesh, mesh.cells[cells[i]], u, point);
    result.col(i) = Eigen::Map<const Eigen::VectorXd>(form.data(), 10).normalized();
  }
  result.col(n) = Eigen::VectorXd::Unit(10, 0);
  return result;
}

// Can these cells be positive together? Floating-point numbers find the places where they are, and, when there is none,
// the cells that matter, whose factors are computed with exact numbers; the proof that results remains to be checked.
inline std::optional<Infeasibility_proof_3> prove_cells_infeasible_3(const Numbered_mesh_3& mesh,
                                                                const std::vector<std::size_t>& cells)
{
  const std::vector<Eigen::Index> columns = columns_around_origin(volume_directions(mesh, cells));
  if(columns.empty())
    return std::nullopt;
  std::vector<std::size_t> support;
  for(const Eigen::Index i : columns)
    if(i < static_cast<Eigen::Index>(cells.size()))
      support.push_back(cells[i]);
  return exact_proof(mesh, support, support.size() < columns.size());
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_PROVE_CELLS_INFEASIBLE_3_H
