// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_PATCH_SPLIT_SEARCH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_PATCH_SPLIT_SEARCH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/Minimal_subset.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/patches_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/split_patch_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/untangle_patch_3.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Looks for edges of a patch whose splits leave as few cells inverted as possible: splits all edges around inverted cells,
// and if that helps, keeps only those that are needed for it. A step is an attempt.
class Patch_split_search_3
{
public:
  using Edge = std::array<int, 2>;

  // Splits help if they leave no cell inverted, which they must, or at least fewer than now.
  Patch_split_search_3(Patch_mesh_3 patch, Linear_solver_3& solver, const bool must_untangle)
    : m_patch(std::move(patch)), m_solver(solver), m_all_edges(edges_around_inverted_cells(m_patch.mesh, m_patch.positions)),
      m_fewest(must_untangle ? 1 : inverted_cells(m_patch.mesh, m_patch.positions).number)
  {}

  bool is_running() const { return m_is_running; }
  bool is_successful() const { return m_splits.has_value(); }
  const Patch_mesh_3& patch() const { return m_patch; }
  std::vector<Edge> edges() const { return m_splits ? m_splits->items() : std::vector<Edge>(); }

  void step()
  {
    const std::size_t number = inverted_cells_of(m_attempts[m_next_attempt++]);
    if(m_splits)
      answer(number <= m_fewest);
    else
      compare(number);
  }

private:
  std::size_t inverted_cells_of(const Patch_attempt& attempt) const
  {
    Patch_mesh_3 split = m_patch;
    split_patch_edges_3(split.mesh, split.positions, m_splits ? m_splits->question() : m_all_edges);
    return inverted_cells(split.mesh, attempt_patch_3(split.mesh, m_solver, split.positions, attempt)).number;
  }

  bool is_last_attempt() const { return m_next_attempt == m_attempts.size(); }

  // What the last attempt has left, with all edges split, with the best one before.
  void compare(const std::size_t number)
  {
    if(number < m_fewest)
    {
      m_fewest = number;
      m_best = m_attempts[m_next_attempt - 1];
    }
    if(m_fewest > 0 && !is_last_attempt())
      return;
    if(m_best)
      begin_pass(m_all_edges, { *m_best });
    else
      m_is_running = false;
  }

  // The edges suffice if one attempt says so, and do not if all deny it. The first pass asks one attempt only, and the
  // second, which has fewer edges, all of them.
  void answer(const bool suffices)
  {
    if(!suffices && !is_last_attempt())
      return;
    m_next_attempt = 0;
    m_splits->answer(suffices);
    if(!m_splits->is_running() && m_attempts.size() == 1)
      begin_pass(m_splits->items(), patch_attempts());
    m_is_running = m_splits->is_running();
  }

  void begin_pass(std::vector<Edge> edges, std::vector<Patch_attempt> attempts)
  {
    m_splits.emplace(std::move(edges));
    m_attempts = std::move(attempts);
    m_next_attempt = 0;
    m_is_running = m_splits->is_running();
  }

  Patch_mesh_3 m_patch;
  Linear_solver_3& m_solver;
  std::vector<Edge> m_all_edges;
  std::size_t m_fewest;                // inverted cells with all edges split
  std::optional<Patch_attempt> m_best; // has left them
  std::optional<Minimal_subset<Edge> > m_splits;
  std::vector<Patch_attempt> m_attempts = patch_attempts(); // at the edges in question
  std::size_t m_next_attempt = 0;
  bool m_is_running = true;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_PATCH_SPLIT_SEARCH_3_H
