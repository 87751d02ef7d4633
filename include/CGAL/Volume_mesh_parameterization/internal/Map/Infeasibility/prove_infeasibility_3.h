// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_INFEASIBILITY_PROVE_INFEASIBILITY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_INFEASIBILITY_PROVE_INFEASIBILITY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Rational_traits.h>
#include <CGAL/Simple_cartesian.h>

#include <map>
#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Proves that no map with the prescribed vertices has only positive cells: the volumes of these cells,
// times these positive factors, have a sum that does not depend on the free vertices and is not positive.
struct Infeasibility_proof_3
{
  std::vector<std::size_t> cells;
  std::vector<Exact_rational> factors;
};

// The free vertices of some cells.
inline std::set<int> free_vertices_of(const Numbered_mesh_3& mesh, const std::vector<std::size_t>& cells)
{
  std::set<int> result;
  for(const std::size_t c : cells)
    for(const int v : mesh.cells[c])
      if(!mesh.is_fixed(v))
        result.insert(v);
  return result;
}

// Six times the volume of the image of a cell whose free vertices are among u and v is linear in u, v and u x v: the
// constant, and the three coefficients of each of them.
using Volume_form_3 = std::array<Exact_rational, 10>;

inline Volume_form_3 volume_form_3(const Numbered_mesh_3& mesh, const std::array<int, 4>& cell, const int u)
{
  using Point = Simple_cartesian<Exact_rational>::Point_3;
  const auto volume = [&](const Point& image_of_u, const Point& image_of_v)
  {
    std::array<Point, 4> p;
    for(int i = 0; i < 4; ++i)
      p[i] = cell[i] == u           ? image_of_u
           : !mesh.is_fixed(cell[i]) ? image_of_v
           : Point(mesh.target(0, cell[i]), mesh.target(1, cell[i]), mesh.target(2, cell[i]));
    return CGAL::determinant(p[1] - p[0], p[2] - p[0], p[3] - p[0]);
  };
  const Point origin(0, 0, 0), unit[3] = { Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1) };
  Volume_form_3 form;
  form[0] = volume(origin, origin);
  for(int k = 0; k < 3; ++k)
  {
    form[1 + k] = volume(unit[k], origin) - form[0];
    form[4 + k] = volume(origin, unit[k]) - form[0];
  }
  for(int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    form[7 + k] = volume(unit[i], unit[j]) - form[1 + i] - form[4 + j] - form[0];
  }
  return form;
}

// Checks the proof with exact numbers only; does not rely on how it was found.
inline bool is_valid(const Infeasibility_proof_3& proof, const Numbered_mesh_3& mesh)
{
  if(proof.cells.empty() || proof.factors.size() != proof.cells.size()
     || *std::max_element(proof.cells.begin(), proof.cells.end()) >= mesh.cells.size())
    return false;
  const std::set<int> free = free_vertices_of(mesh, proof.cells);
  if(free.size() > 2)
    return false;
  Volume_form_3 sum;
  sum.fill(0);
  for(std::size_t i = 0; i < proof.cells.size(); ++i)
  {
    if(proof.factors[i] <= 0)
      return false;
    const Volume_form_3 form = volume_form_3(mesh, mesh.cells[proof.cells[i]], free.empty() ? -1 : *free.begin());
    for(std::size_t k = 0; k < sum.size(); ++k)
      sum[k] += proof.factors[i] * form[k];
  }
  return sum[0] <= 0 && std::all_of(sum.begin() + 1, sum.end(), [](const Exact_rational& x) { return x == 0; });
}

// Linear equations A x = b with b >= 0, a row [A | b] each, times the last pivot: so all numbers are minors of the first
// ones, and short (Edmonds 1967).
struct Linear_equations
{
  std::vector<std::vector<Exact_integer> > rows;
  Exact_integer last_pivot = 1;

  // Solves the equation of row r for unknown j, and puts it into the others.
  void solve(const std::size_t r, const std::size_t j)
  {
    const Exact_integer pivot = rows[r][j];
    for(std::size_t i = 0; i < rows.size(); ++i)
      if(const Exact_integer factor = rows[i][j]; i != r)
        for(std::size_t k = 0; k < rows[i].size(); ++k)
          rows[i][k] = (pivot * rows[i][k] - factor * rows[r][k]) / last_pivot;
    last_pivot = pivot;
  }
};

// A basic solution x >= 0, up to a factor, if there is one: the first phase of the simplex method with the rule of Bland
// (1977), which ends. CGAL's QP_solver takes more time, and a sixth of all that it takes to compile a map. None if the
// budget ends before.
inline std::optional<std::vector<Exact_integer> > nonnegative_solution(Linear_equations equations, const Budget& budget)
{
  const auto& rows = equations.rows;
  const std::size_t n = rows.front().size() - 1, m = rows.size();
  std::vector<std::size_t> basis(m); // the unknown of each row, or n and more where it is not yet fulfilled
  std::iota(basis.begin(), basis.end(), n);
  const auto bounds_before = [&](const std::size_t i, const std::size_t r, const std::size_t j)
  {
    const Exact_integer difference = rows[i].back() * rows[r][j] - rows[r].back() * rows[i][j];
    return difference < 0 || (difference == 0 && basis[i] < basis[r]);
  };
  for(std::size_t j = 0; j < n && !budget.is_exhausted();)
  {
    Exact_integer gain = 0;
    std::size_t r = m; // the row that bounds unknown j
    for(std::size_t i = 0; i < m; ++i)
    {
      if(basis[i] >= n)
        gain += rows[i][j];
      if(rows[i][j] > 0 && (r == m || bounds_before(i, r, j)))
        r = i;
    }
    if(gain > 0)
    {
      equations.solve(r, j);
      basis[r] = j;
    }
    j = gain > 0 ? 0 : j + 1;
  }
  std::vector<Exact_integer> solution(n, 0);
  for(std::size_t i = 0; i < m; ++i)
    if(basis[i] < n)
      solution[basis[i]] = rows[i].back();
    else if(rows[i].back() != 0)
      return std::nullopt;
  return solution;
}

// Can these cells be positive together? By Gordan's theorem not, if and only if a combination of their volume forms with
// factors that are not negative, and of sum 1, is a constant that is not positive: that and one more unknown are 0.
inline std::optional<Infeasibility_proof_3> prove_cells_infeasible_3(const Numbered_mesh_3& mesh,
                                                                     const std::vector<std::size_t>& cells,
                                                                     const Budget& budget)
{
  const std::set<int> free = free_vertices_of(mesh, cells);
  const int u = free.empty() ? -1 : *free.begin();
  using Rational = Rational_traits<Exact_rational>;
  std::vector<Exact_integer> units(cells.size(), 1); // the denominators are powers of two
  Linear_equations equations;
  equations.rows.resize(std::tuple_size<Volume_form_3>::value + 1, std::vector<Exact_integer>(cells.size() + 2, 0));
  for(std::size_t i = 0; i < cells.size(); ++i)
  {
    if(budget.is_exhausted())
      return std::nullopt;
    const Volume_form_3 form = volume_form_3(mesh, mesh.cells[cells[i]], u);
    for(const Exact_rational& x : form)
      units[i] = (std::max)(units[i], Rational().denominator(x));
    for(std::size_t k = 0; k < form.size(); ++k)
      equations.rows[k][i] = Rational().numerator(Exact_rational(form[k] * units[i]));
    equations.rows.back()[i] = 1;
  }
  equations.rows.front()[cells.size()] = equations.rows.back().back() = 1;
  const auto factors = nonnegative_solution(std::move(equations), budget);
  if(!factors)
    return std::nullopt;
  Infeasibility_proof_3 proof;
  for(std::size_t i = 0; i < cells.size(); ++i)
    if((*factors)[i] != 0)
    {
      proof.cells.push_back(cells[i]);
      proof.factors.push_back(Exact_rational((*factors)[i] * units[i]));
    }
  return proof;
}

// The cells with one or two free vertices, by these: an edge u < v, or the vertex u = v.
using Cells_of_free_ends = std::map<std::array<int, 2>, std::vector<std::size_t> >;

// Returns the cells whose free vertices are among two. Their volumes are linear in these points u and v and in u x v.
inline std::vector<std::size_t> cells_among(const Cells_of_free_ends& cells_of, const std::array<int, 2>& ends)
{
  std::vector<std::size_t> result;
  for(const std::array<int, 2>& part : std::set<std::array<int, 2> >{{ends[0], ends[0]}, ends, {ends[1], ends[1]}})
    if(const auto found = cells_of.find(part); found != cells_of.end())
      result.insert(result.end(), found->second.begin(), found->second.end());
  return result;
}

// Looks for proofs that no map with the prescribed vertices has only positive cells. There are three kinds: a cell that is never
// positive, a free vertex without a place, and an edge of two free vertices without one. Only sets of cells with a suspect are
// examined, a cell that is not positive in some image. Without a proof, there need not be a map, and the budget may have ended the
// search. The time is nearly linear in the number of cells.
inline std::vector<Infeasibility_proof_3> prove_infeasibility_3(const Numbered_mesh_3& mesh,
                                                                const std::vector<std::size_t>& suspects,
                                                                const Budget& budget = Budget())
{
  std::vector<Infeasibility_proof_3> proofs;
  std::vector<bool> is_suspect(mesh.cells.size());
  for(const std::size_t c : suspects)
    is_suspect[c] = true;
  Cells_of_free_ends cells_of;
  for(std::size_t c = 0; c < mesh.cells.size() && !budget.is_exhausted(); ++c)
  {
    const std::set<int> free = free_vertices_of(mesh, { c });
    if(free.size() > 2)
      continue;
    if(const auto proof = is_suspect[c] ? prove_cells_infeasible_3(mesh, { c }, budget) : std::nullopt)
      proofs.push_back(*proof);
    else if(!free.empty())
      cells_of[{ *free.begin(), *free.rbegin() }].push_back(c);
  }
  std::set<int> infeasible; // free vertices with a proof of their own
  for(const bool is_edge : {false, true})
    for(const auto& [ends, own_cells] : cells_of)
    {
      if((ends[0] != ends[1]) != is_edge || infeasible.count(ends[0]) != 0 || infeasible.count(ends[1]) != 0
         || budget.is_exhausted())
        continue;
      const std::vector<std::size_t> cells = cells_among(cells_of, ends);
      if(std::none_of(cells.begin(), cells.end(), [&](const std::size_t c) { return is_suspect[c]; }))
        continue;
      const std::optional<Infeasibility_proof_3> proof = prove_cells_infeasible_3(mesh, cells, budget);
      if(!proof || !is_valid(*proof, mesh))
        continue;
      proofs.push_back(*proof);
      if(!is_edge)
        infeasible.insert(ends[0]);
    }
  return proofs;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_INFEASIBILITY_PROVE_INFEASIBILITY_3_H
