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
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/Patch_split_search_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/patches_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/split_patch_edges_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Looks for edges to split where untangling is stuck, as few as possible: first so that the patches of inverted cells can be
// untangled, and where that cannot be, so that fewer cells are inverted. A step is an attempt at a patch.
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
    if(!m_search)
      begin_patch();
    m_search->step();
    next_step(Phase::UNTANGLING).number_of_inverted_cells = m_number_of_inverted_cells;
    if(m_search->is_running())
      return;
    end_patch();
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
    m_search.emplace(Patch_mesh_3(m_mesh, m_positions,
                                  with_cells_around_prescribed_edges(m_mesh, m_positions, std::move(m_waiting.back()))),
                     m_solver, levels[m_next_level - 1].must_untangle);
    m_waiting.pop_back();
  }

  void end_patch()
  {
    const Patch_mesh_3& patch = m_search->patch();
    for(const auto& [a, b] : m_search->edges())
      m_edges.push_back({patch.vertices[a], patch.vertices[b]});
    if(m_search->is_successful())
      for(int i = 0; i < patch.mesh.number_of_free_vertices; ++i)
        m_is_solved[patch.vertices[i]] = true;
    m_search.reset();
  }

  const Numbered_mesh_3& m_mesh;
  Linear_solver_3& m_solver;
  const Eigen::Matrix3Xd& m_positions;
  std::vector<bool> m_is_solved; // the vertices that move in a patch
  std::size_t m_number_of_inverted_cells;
  std::size_t m_next_level = 0;
  std::vector<Patch_3> m_waiting;
  std::optional<Patch_split_search_3> m_search; // of the patch in work
  std::vector<Edge> m_edges;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_SPLIT_SEARCH_3_H
