// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_PATCH_UNTANGLING_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_PATCH_UNTANGLING_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Stage_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/Neighborhood_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/patches_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/untangle_patch_3.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Untangles where cells are inverted: these with a ring of neighbors, then with two, each connected part as a problem of
// its own in which all other vertices are prescribed where they are. Small problems get past what stops the whole, in
// thousandths of a second. A step is a patch.
class Patch_untangling_3 : public Stage_3
{
public:
  Patch_untangling_3(const Numbered_mesh_3& mesh, Linear_solver_3& solver, const Eigen::Matrix3Xd& positions)
    : m_neighborhood(mesh, positions, is_inverted, maximal_number_of_rings + 1), // of what becomes inverted, too
      m_solver(solver), m_positions(m_neighborhood.positions()),
      m_number_of_inverted_cells(inverted_cells(mesh, positions).number)
  {
    begin_sweep();
  }

  void step() override
  {
    untangle(m_waiting.back());
    m_waiting.pop_back();
    next_step(Phase::UNTANGLING).number_of_inverted_cells = m_number_of_inverted_cells;
    if(m_waiting.empty())
    {
      ++m_number_of_rings;
      begin_sweep();
    }
  }

  Eigen::Matrix3Xd positions() const override { return m_neighborhood.in_whole(m_positions); }
  bool is_flip_free() const override { return m_number_of_inverted_cells == 0; }

private:
  static constexpr int maximal_number_of_rings = 2;

  void begin_sweep()
  {
    if(m_number_of_inverted_cells == 0)
      end(OK);
    else if(m_number_of_rings <= maximal_number_of_rings)
      m_waiting = patches_3(m_neighborhood.mesh(), m_positions, is_inverted, m_number_of_rings);
    if(m_waiting.empty() && is_running())
      end(ERROR_NOT_FLIP_FREE);
  }

  // Moves its vertices if fewer cells around them are inverted then.
  void untangle(const Patch_3& patch)
  {
    Patch_mesh_3 p(m_neighborhood.mesh(), m_positions, patch);
    if(!(volume(p.mesh, p.mesh.target) > 0)) // which does not depend on the free vertices
      return;
    const std::size_t before = inverted_cells(p.mesh, p.positions).number;
    p.positions = m_neighborhood.found_by_first([&]()
    {
      untangle_patch_3(p.mesh, m_solver, p.positions);
      return p.positions;
    });
    const std::size_t after = inverted_cells(p.mesh, p.positions).number;
    m_number_of_inverted_cells -= before - after;
    if(after < before)
      p.write(m_positions);
  }

  static bool is_inverted(const Eigen::Matrix3Xd& positions, const std::array<int, 4>& cell)
  {
    return !is_positive(positions, cell);
  }

  Neighborhood_3 m_neighborhood;
  Linear_solver_3& m_solver;
  Eigen::Matrix3Xd m_positions;
  std::vector<Patch_3> m_waiting;
  std::size_t m_number_of_inverted_cells; // in the whole mesh
  int m_number_of_rings = 1;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_PATCH_UNTANGLING_3_H
