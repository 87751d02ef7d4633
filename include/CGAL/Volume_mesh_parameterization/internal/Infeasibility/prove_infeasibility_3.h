// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_PROVE_INFEASIBILITY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_PROVE_INFEASIBILITY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/Infeasibility_proof_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Map_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <iterator>
#include <map>
#include <optional>

namespace CGAL::Volume_mesh_parameterization::internal {

// Is there a place for the free vertices of this cell that makes it positive?
inline bool can_be_positive(const Numbered_mesh_3& mesh, const std::array<int, 4>& cell)
{
  using Point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point_3> p;
  for(const int v : cell)
    if(!mesh.is_free(v))
      p.emplace_back(mesh.target(0, v), mesh.target(1, v), mesh.target(2, v));
  switch(p.size())
  {
    case 4: return is_positive(mesh.target, cell);
    case 3: return !CGAL::collinear(p[0], p[1], p[2]);
    case 2: return p[0] != p[1];
    default: return true;
  }
}

// Can these cells be positive together? By Gordan's theorem not, if and only if a combination of their volume forms with
// factors that are not negative, and of sum 1, is a constant that is not positive: a linear program, solved with exact
// numbers. Its basic solutions have few cells.
inline std::optional<Infeasibility_proof_3> prove_cells_infeasible_3(const Numbered_mesh_3& mesh,
                                                                     const std::vector<std::size_t>& cells)
{
  const int u = *free_vertices_of(mesh, cells).begin(), n = static_cast<int>(cells.size()), row_of_sum = 10;
  Quadratic_program<Exact_rational> program(EQUAL);
  program.set_r(0, SMALLER);
  program.set_b(row_of_sum, 1);
  for(int i = 0; i < n; ++i)
  {
    const Volume_form_3 form = volume_form_3(mesh, mesh.cells[cells[i]], u);
    for(int k = 0; k < row_of_sum; ++k)
      program.set_a(i, k, form[k]);
    program.set_a(i, row_of_sum, 1);
  }
  const auto solution = solve_nonnegative_linear_program(program, Exact_rational());
  if(solution.is_infeasible())
    return std::nullopt;
  Infeasibility_proof_3 proof;
  auto factor = solution.variable_values_begin();
  for(const std::size_t c : cells)
  {
    if(!is_zero(factor->numerator()))
    {
      proof.cells.push_back(c);
      proof.factors.push_back(factor->numerator() / factor->denominator());
    }
    ++factor;
  }
  return proof;
}

// Examines the cells whose free vertices are one vertex, or the two ends of an edge: that their volumes are positive
// is linear in these points u and v and in u x v.
class Infeasibility_search_3
{
  // an edge u < v, or the vertex u = v
  using Ends = std::array<int, 2>;

public:
  // Examines only sets of cells that are not all positive in `positions`, until the budget ends.
  Infeasibility_search_3(const Numbered_mesh_3& mesh, const Eigen::Matrix3Xd& positions, const Budget& budget)
    : m_mesh(mesh),
      m_is_suspect(mesh.cells.size())
  {
    for(std::size_t c = 0; c < mesh.cells.size() && !budget.is_exhausted(); ++c)
    {
      m_is_suspect[c] = !is_positive(positions, mesh.cells[c]);
      if(m_is_suspect[c] && !can_be_positive(mesh, mesh.cells[c]))
        m_proofs.push_back({{c}, {Exact_rational(1)}});
      else
        add_to_group(c);
    }
    for(const bool are_edges : {false, true})
      for(const auto& group : m_groups)
        if((group.first[0] != group.first[1]) == are_edges && !budget.is_exhausted())
          examine(group.first);
  }

  const std::vector<Infeasibility_proof_3>& proofs() const { return m_proofs; }

private:
  void add_to_group(const std::size_t c)
  {
    const std::array<int, 4>& cell = m_mesh.cells[c];
    std::vector<int> free;
    std::copy_if(cell.begin(), cell.end(), std::back_inserter(free), [&](const int v) { return m_mesh.is_free(v); });
    if(free.size() == 1 || free.size() == 2)
      m_groups[{(std::min)(free.front(), free.back()), (std::max)(free.front(), free.back())}].push_back(c);
  }

  void examine(const Ends& ends)
  {
    if(m_unplaceable.count(ends[0]) != 0 || m_unplaceable.count(ends[1]) != 0)
      return;
    std::vector<std::size_t> cells;
    for(const Ends& part : std::set<Ends>{{ends[0], ends[0]}, ends, {ends[1], ends[1]}})
    {
      const auto group = m_groups.find(part);
      if(group != m_groups.end())
        cells.insert(cells.end(), group->second.begin(), group->second.end());
    }
    if(std::none_of(cells.begin(), cells.end(), [&](const std::size_t c) { return m_is_suspect[c]; }))
      return;
    const std::optional<Infeasibility_proof_3> proof = prove_cells_infeasible_3(m_mesh, cells);
    if(!proof || !is_valid(*proof, m_mesh))
      return;
    m_proofs.push_back(*proof);
    if(ends[0] == ends[1])
      m_unplaceable.insert(ends[0]);
  }

  const Numbered_mesh_3& m_mesh;
  std::vector<bool> m_is_suspect;
  std::map<Ends, std::vector<std::size_t> > m_groups; // the cells by their free vertices
  std::set<int> m_unplaceable;                        // free vertices with a proof of their own
  std::vector<Infeasibility_proof_3> m_proofs;
};

// Proves, where it can, that no map with the prescribed vertices has only positive cells. Three kinds of reasons are
// looked for: a cell that can never be positive, a free vertex and an edge between two of them for which there
// is no place. Any image of the vertices, `positions`, speeds up the search by the cells that are positive there.
// No proof does not mean that there is a map; with a limited budget, not even that the search was complete. Near-linear in
// the number of cells.
inline std::vector<Infeasibility_proof_3> prove_infeasibility_3(const Numbered_mesh_3& mesh,
                                                                const Eigen::Matrix3Xd& positions,
                                                                const Budget& budget = Budget())
{
  return Infeasibility_search_3(mesh, positions, budget).proofs();
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_PROVE_INFEASIBILITY_3_H
