// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_SPLIT_SEARCH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_SPLIT_SEARCH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Stage_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/Minimal_subset.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/patches_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/split_patch_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/untangle_patch_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Looks for edges to split where untangling is stuck, as few as possible: around each patch of inverted cells all of them
// at once, and if the patch can be untangled then, only those that are needed for it. Where that cannot be, it suffices
// that fewer cells are inverted. A step is a question about a patch.
class Split_search_3 : public Stage_3
{
public:
  using Edge = std::array<int, 2>;

  Split_search_3(const Numbered_mesh_3& mesh, Linear_solver_3& solver, const Eigen::Matrix3Xd& positions)
    : m_mesh(mesh), m_solver(solver), m_positions(positions), m_is_solved(mesh.number_of_vertices(), false),
      m_number_of_inverted_cells(inverted_cells(mesh, positions).number)
  {
    find_patches();
  }

  void step() override
  {
    if(!m_splits)
      begin_patch();
    else
      m_splits->answer(inverted_cells_with(m_splits->question(), m_attempts, m_fewest) <= m_fewest);
    if(m_splits && !m_splits->is_running())
      end_pass();
    next_step(Phase::UNTANGLING).number_of_inverted_cells = m_number_of_inverted_cells;
    if(!m_splits)
      find_patches();
  }

  Eigen::Matrix3Xd positions() const override { return m_positions; }
  bool is_flip_free() const override { return false; }
  const std::vector<Edge>& edges() const { return m_edges; }

private:
  struct Level
  {
    int number_of_rings;
    bool must_untangle; // or may cells stay inverted?
  };
  static constexpr std::array<Level, 3> levels = {{ {1, true}, {2, true}, {2, false} }};

  // The patches that are left: of the next level, if none of this one is waiting.
  void find_patches()
  {
    while(m_waiting.empty() && m_next_level < levels.size())
      m_waiting = patches_3(m_mesh, m_positions, [&](const Eigen::Matrix3Xd& positions, const std::array<int, 4>& cell)
      {
        return !is_positive(positions, cell)
          && std::none_of(cell.begin(), cell.end(), [&](const int v) { return m_is_solved[v]; });
      }, levels[m_next_level++].number_of_rings);
    if(m_waiting.empty())
      end(ERROR_NOT_FLIP_FREE);
  }

  void begin_patch()
  {
    m_patch.emplace(m_mesh, m_positions,
                    with_cells_around_prescribed_edges(m_mesh, m_positions, std::move(m_waiting.back())));
    m_waiting.pop_back();
    const std::vector<Edge> edges = edges_around_inverted_cells(m_patch->mesh, m_patch->positions);
    const bool must_untangle = levels[m_next_level - 1].must_untangle;
    m_fewest = must_untangle ? 1 : inverted_cells(m_patch->mesh, m_patch->positions).number;
    for(const Patch_attempt& attempt : patch_attempts())
    {
      if(m_fewest == 0)
        break;
      const std::size_t number = inverted_cells_with(edges, { attempt }, 0);
      if(number < m_fewest)
      {
        m_fewest = number;
        m_attempts = { attempt };
        m_splits.emplace(edges);
      }
    }
  }

  // The first pass asks one attempt, and the second, which has fewer edges, all of them.
  void end_pass()
  {
    if(m_attempts.size() == 1)
    {
      m_attempts = patch_attempts();
      m_splits = Minimal_subset<Edge>(m_splits->items());
    }
    if(!m_splits->is_running())
      end_patch();
  }

  void end_patch()
  {
    for(const auto& [a, b] : m_splits->items())
      m_edges.push_back({m_patch->vertices[a], m_patch->vertices[b]});
    for(int i = 0; i < m_patch->mesh.number_of_free_vertices; ++i)
      m_is_solved[m_patch->vertices[i]] = true;
    m_splits.reset();
  }

  std::size_t inverted_cells_with(const std::vector<Edge>& edges, const std::vector<Patch_attempt>& attempts,
                                  const std::size_t allowed) const
  {
    Patch_mesh_3 split = *m_patch;
    split_patch_edges_3(split.mesh, split.positions, edges);
    return untangle_patch_3(split.mesh, m_solver, split.positions, allowed, attempts);
  }

  const Numbered_mesh_3& m_mesh;
  Linear_solver_3& m_solver;
  const Eigen::Matrix3Xd& m_positions;
  std::vector<bool> m_is_solved; // the vertices that move in a patch
  std::size_t m_number_of_inverted_cells;
  std::size_t m_next_level = 0;
  std::vector<Patch_3> m_waiting;
  std::optional<Patch_mesh_3> m_patch;
  std::optional<Minimal_subset<Edge> > m_splits; // of the patch, as long as it is asked about
  std::size_t m_fewest = 0;                      // inverted cells of the patch with all edges split
  std::vector<Patch_attempt> m_attempts;         // that decide whether some edges suffice
  std::vector<Edge> m_edges;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_SPLIT_SEARCH_3_H
