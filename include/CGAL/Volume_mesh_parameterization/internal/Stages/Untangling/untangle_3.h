// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_UNTANGLE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_UNTANGLE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Linear_solver_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/Patch_untangling_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/Untangling_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Untangling/Untangling_setting.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// Images of all vertices, with the prescribed ones on their targets, and how the search for them ended.
struct Untangled_3
{
  Eigen::Matrix3Xd positions = {};
  std::size_t number_of_inverted_cells = 0;
  Error_code status = ERROR_NOT_FLIP_FREE;
  std::string reason = {};
  std::string method = {}; // that has found the images; empty if they are those of the start
  std::size_t number_of_steps = 0;
};

// Untangles by one search after the other, and keeps the best result.
class Untangling_search_3
{
public:
  // The set-up of the system began at that time.
  Untangling_search_3(const Numbered_mesh_3& mesh, Newton_system_3& system, Linear_solver_3& solver,
                      const Eigen::Matrix3Xd& start, const double begin, Progress_3& progress)
    : m_mesh(mesh), m_system(system), m_solver(solver), m_progress(progress), m_begin(begin),
      m_best{ start, inverted_cells(mesh, start).number }
  {}

  const Untangled_3& best() const { return m_best; }

  // The best result, with the cells of the source again.
  Untangled_3 finish()
  {
    if(goes_on() && m_best.number_of_inverted_cells == 0)
      m_best.status = OK;
    m_system.set_references(m_mesh, cells_scaled_to_target(m_mesh));
    return std::move(m_best);
  }

  bool goes_on() const { return m_best.status == ERROR_NOT_FLIP_FREE; }

  // The whole mesh, and then patches of it.
  void untangle(const Untangling_setting& setting, const Eigen::Matrix3Xd& start)
  {
    m_system.set_references(m_mesh, reference_cells(m_mesh, setting));
    Untangling_3 untangling(m_mesh, m_system, start, setting.theta);
    const Eigen::Matrix3Xd positions = run(untangling, setting.name);
    if(goes_on())
      untangle_patches(positions, std::string(setting.name) + ", patches");
  }

  // Unless so many cells are inverted that they are no exceptions.
  void untangle_patches(const Eigen::Matrix3Xd& start, const std::string& method)
  {
    if(inverted_cells(m_mesh, start).number > most_exceptions(m_mesh.number_of_all_cells()))
      return;
    Patch_untangling_3 patches(m_mesh, m_solver.for_patches(), start);
    run(patches, method);
    m_system.claim_solver();
  }

  // Either patches of a map suffice, or the cells that stay inverted are jammed, and nothing to go on from.
  void begin_with_patches(const Eigen::Matrix3Xd& map)
  {
    const Untangled_3 start = m_best;
    untangle_patches(map, "patches");
    const std::size_t number_of_steps = m_best.number_of_steps;
    if(goes_on())
      m_best = start;
    m_best.number_of_steps = number_of_steps;
    go_on_if_flat();
  }

private:
  // Goes on if cells are so flat that a minimization would hardly take a step: in thin parts, the harmonic map shrinks
  // cells exponentially, and only the search over the whole mesh spreads them.
  void go_on_if_flat()
  {
    constexpr double flat = 1e-12; // relative to the mean volume
    const Dirichlet_energy_3 any;
    if(m_best.status == OK && m_system.evaluate(Cell_energy_of<Dirichlet_energy_3>(any),
                                                m_system.unit() * m_best.positions).smallest_determinant < flat)
      m_best.status = ERROR_NOT_FLIP_FREE;
  }

  Eigen::Matrix3Xd run(Stage_3& stage, const std::string& method)
  {
    m_best.status = m_progress.run(stage, m_begin, m_best.number_of_steps);
    m_best.reason = m_best.status == stage.status() ? stage.reason() : std::string();
    m_best.number_of_steps += stage.last_step().iteration;
    const Eigen::Matrix3Xd positions = stage.positions();
    const std::size_t number = inverted_cells(m_mesh, positions).number;
    if(stage.last_step().iteration > 0 && (number < m_best.number_of_inverted_cells || number == 0))
    {
      m_best.number_of_inverted_cells = number;
      m_best.positions = positions;
      m_best.method = method;
    }
    m_begin = m_progress.seconds();
    return positions;
  }

  const Numbered_mesh_3& m_mesh;
  Newton_system_3& m_system;
  Linear_solver_3& m_solver;
  Progress_3& m_progress;
  double m_begin;
  Untangled_3 m_best;
};

// Few inverted cells of a map with respect to regular cells are patched. Otherwise tries one setting after the other, each
// from the same start, until no cell is inverted.
inline Untangled_3 untangle_3(const Numbered_mesh_3& mesh, Newton_system_3& system, Linear_solver_3& solver,
                              const Eigen::Matrix3Xd& start, const Eigen::Matrix3Xd& regular_start, const double begin,
                              Progress_3& progress)
{
  Untangling_search_3 search(mesh, system, solver, start, begin, progress);
  search.begin_with_patches(regular_start);
  for(const Untangling_setting& setting : untangling_settings)
    if(search.goes_on())
      search.untangle(setting, start);
  return search.finish();
}

// Goes on from images that an earlier search has left with few inverted cells, or none.
inline Untangled_3 untangle_on_3(const Numbered_mesh_3& mesh, Newton_system_3& system, Linear_solver_3& solver,
                                 const Eigen::Matrix3Xd& start, const double begin, Progress_3& progress)
{
  Untangling_search_3 search(mesh, system, solver, start, begin, progress);
  search.untangle_patches(start, "patches");
  if(search.goes_on())
    search.untangle(setting_to_go_on, search.best().positions);
  return search.finish();
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_UNTANGLE_3_H
