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
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Scaled_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Unknowns_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Untangler_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/harmonic_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Stage_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/Untangling_setting.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/patches_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/relax_flat_cells_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Untangles where cells are inverted: these with a ring of neighbors, then with two, each connected part as a problem of
// its own in which all other vertices are prescribed where they are. Small problems get past what stops the whole, in
// thousandths of a second. A step is a patch.
class Patch_untangling_3 : public Stage_3
{
public:
  Patch_untangling_3(const Numbered_mesh_3& mesh, Linear_solver_3& solver, Eigen::Matrix3Xd positions)
    : m_mesh(mesh), m_solver(solver), m_positions(std::move(positions))
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

  Eigen::Matrix3Xd positions() const override { return m_positions; }
  bool is_flip_free() const override { return m_number_of_inverted_cells == 0; }

private:
  static constexpr int maximal_number_of_rings = 2;
  static constexpr int maximal_number_of_steps = 60;

  void begin_sweep()
  {
    m_number_of_inverted_cells = inverted_cells(m_mesh, m_positions).number;
    if(m_number_of_inverted_cells == 0)
      end(OK);
    else if(m_number_of_rings <= maximal_number_of_rings)
      m_waiting = patches_3(m_mesh, [&](const auto& cell) { return !is_positive(m_positions, cell); }, m_number_of_rings);
    if(m_waiting.empty() && is_running())
      end(ERROR_NOT_FLIP_FREE);
  }

  // Moves its vertices if fewer cells around them are inverted then.
  void untangle(const Patch_3& patch)
  {
    Patch_mesh_3 p(m_mesh, m_positions, patch);
    // the volume does not depend on the free vertices
    if(volume(p.mesh, p.mesh.target) > 0 && improve(p.mesh, p.positions))
      p.write(m_positions);
  }

  // From the positions and from the harmonic map, with each setting, until no cell is inverted. Returns whether fewer are.
  bool improve(const Numbered_mesh_3& patch, Eigen::Matrix3Xd& positions)
  {
    const std::size_t before = inverted_cells(patch, positions).number;
    std::size_t fewest = before;
    const Eigen::Matrix3Xd start = positions;
    for(const bool is_harmonic : {false, true})
      for(const Untangling_setting& setting : untangling_settings)
      {
        if(fewest == 0)
          break;
        Newton_system_3 system(patch, reference_cells(patch, setting), free_vertices(patch), m_solver, false);
        Eigen::Matrix3Xd u = system.unit() * start;
        if(is_harmonic)
          harmonic_map_3(system, u);
        const Eigen::Matrix3Xd found = snapped(patch, untangled(patch, system, u, setting.theta) / system.unit());
        const std::size_t number = inverted_cells(patch, found).number;
        if(number < fewest)
        {
          fewest = number;
          positions = found;
        }
      }
    m_number_of_inverted_cells -= before - fewest;
    return fewest < before;
  }

  // Cells that have just become positive are flat.
  static Eigen::Matrix3Xd untangled(const Numbered_mesh_3& patch, Newton_system_3& system, const Eigen::Matrix3Xd& u,
                                    const double theta)
  {
    Untangler_3 untangler(system, u, theta);
    for(int i = 0; i < maximal_number_of_steps && untangler.step() == Step_status::CONTINUE; ++i) {}
    if(!untangler.evaluation().is_flip_free())
      return untangler.positions();
    system.set_references(patch, cells_scaled_to_target(patch));
    return relaxed_3(system, untangler.positions());
  }

  const Numbered_mesh_3& m_mesh;
  Linear_solver_3& m_solver;
  Eigen::Matrix3Xd m_positions;
  std::vector<Patch_3> m_waiting;
  std::size_t m_number_of_inverted_cells = 0;
  int m_number_of_rings = 1;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_PATCH_UNTANGLING_3_H
