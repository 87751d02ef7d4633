// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_UNTANGLE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_UNTANGLE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Infeasibility/prove_infeasibility_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/untangle_patches_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Makes one attempt after the other, and keeps the best images of all, with the prescribed vertices on their targets.
class Untangling_search_3
{
public:
  Untangling_search_3(Newton_system_3& system, const Map_3& start, Progress_3& progress, Found_map_3& best)
    : m_mesh(system.mesh()), m_system(system), m_progress(progress), m_best(best)
  {
    m_best.take(ERROR_NOT_FLIP_FREE, "", start);
    m_best.untangling_method = "";
  }

  // Are so few cells left inverted that they are what no map can mend, as a proof tells?
  bool is_in_vain(const Untangling_attempt_3& attempt) const
  {
    return goes_on() && m_best.map.number_of_inverted_cells <= attempt.few_cells && m_mesh.is_whole()
        && !prove_infeasibility_3(m_mesh, m_best.map.inverted_cells, m_progress.budget()).empty();
  }

  bool goes_on() const { return m_best.status == ERROR_NOT_FLIP_FREE; }

  // Takes the cells of the source again. Cells that have just become positive are flat, and are relaxed.
  void finish()
  {
    if(goes_on() && m_best.map.is_valid())
      m_best.status = OK;
    m_system.set_references(false);
    if(m_best.status == OK && m_progress.number_of_steps() > 0)
      m_best.map = judged(m_mesh, relaxed_flat_cells_3(m_mesh, m_system.solver(), m_best.map.positions,
                                                       m_progress.budget()));
  }

  // The whole mesh, and then patches of it.
  void untangle(const Untangling_attempt_3& attempt, const Matrix3Xd& start)
  {
    const Matrix3Xd positions
      = keep_better(attempt.name, [&] { return untangle_by_3(attempt, m_system, start, m_progress); });
    if(goes_on())
      untangle_patches(positions, std::string(attempt.name) + ", patches");
  }

  // Unless so many cells are inverted that they are no exceptions.
  void untangle_patches(const Matrix3Xd& start, const std::string& method)
  {
    if(inverted_cells(m_mesh, start).number <= most_exceptions(m_mesh.global_number_of_cells()))
      keep_better(method, [&] { return untangle_patches_3(m_mesh, m_system.solver(), start, m_progress); });
  }

  // Either patches of a map suffice, or the cells that stay inverted are jammed, and nothing to go on from. If cells are so
  // flat that a minimization would hardly take a step, the search goes on, too: in thin parts, the harmonic map shrinks
  // cells exponentially, and only the search over the whole mesh spreads them.
  void begin_with_patches(const Matrix3Xd& map)
  {
    constexpr double flat = 1e-12;
    const Found_map_3 start = m_best;
    untangle_patches(map, "patches");
    if(goes_on())
      m_best = start;
    else if(m_best.status == OK && m_system.smallest_relative_volume(m_best.map.positions) < flat)
      m_best.status = ERROR_NOT_FLIP_FREE;
  }

private:
  // Returns the images that `find()` does, and keeps them if they are the best. Images without inverted cells replace others
  // of that kind if there were steps, as those were flat.
  template <typename Find>
  Matrix3Xd keep_better(const std::string& method, const Find& find)
  {
    m_progress.begin_attempt(method);
    const std::size_t steps_before = m_progress.number_of_steps();
    const Newton_result_3 result = find();
    const bool has_moved = m_progress.number_of_steps() > steps_before;
    Map_3 map = judged(m_mesh, result.positions);
    m_best.status = result.status == OK && !map.is_valid() ? ERROR_NOT_FLIP_FREE : result.status;
    m_best.reason = result.reason;
    if(map.number_of_inverted_cells < m_best.map.number_of_inverted_cells || (map.is_valid() && has_moved))
    {
      m_best.map = std::move(map);
      m_best.untangling_method = has_moved ? method : "";
    }
    m_progress.end_check();
    return result.positions;
  }

  const Numbered_mesh_3& m_mesh;
  Newton_system_3& m_system;
  Progress_3& m_progress;
  Found_map_3& m_best;
};

// Few inverted cells of a map with respect to regular cells are patched. Otherwise makes one attempt after the other, each
// from the same start, until no cell is inverted. The cells of the source take longest, and seldom help where few cells are
// left, so edges at these are rather split, if they may be.
inline void untangle_3(Newton_system_3& system, const Map_3& start, const Matrix3Xd& regular_start,
                       const bool may_split, Progress_3& progress, Found_map_3& found)
{
  constexpr std::size_t few_to_split = 10;
  Untangling_search_3 search(system, start, progress, found);
  search.begin_with_patches(regular_start);
  for(const Untangling_attempt_3& attempt : untangling_attempts)
  {
    if(may_split && !attempt.has_regular_cells && found.map.number_of_inverted_cells <= few_to_split)
      break;
    if(search.goes_on())
      search.untangle(attempt, start.positions);
    if(search.is_in_vain(attempt))
      break;
  }
  search.finish();
}

// Goes on from images that an earlier search has left with few inverted cells, or none.
inline void untangle_on_3(Newton_system_3& system, const Matrix3Xd& start, Progress_3& progress, Found_map_3& found)
{
  Untangling_search_3 search(system, judged(system.mesh(), start), progress, found);
  search.untangle_patches(start, "patches");
  if(search.goes_on())
    search.untangle(untangling_attempts[0], found.map.positions);
  search.finish();
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_UNTANGLE_3_H
