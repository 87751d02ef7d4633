// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_UNTANGLE_MESH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_UNTANGLE_MESH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Expansion/expand_core_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Infeasibility/prove_infeasibility_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/find_splits_3.h>

#include <functional>

namespace CGAL::Volume_mesh_parameterization::internal {

// Makes one attempt after the other, and keeps the best images of all, with the prescribed vertices on their targets.
class Untangling_search_3
{
public:
  // Splits make room for the last inverted cells in less time than large patches do, if edges may be split.
  Untangling_search_3(Newton_system_3& system, Map_3 start, Progress_3& progress, const bool may_split)
    : m_mesh(system.mesh()), m_system(system), m_progress(progress), m_number_of_rings(may_split ? 2 : 4),
      m_few_cells(few_inverted_cells(m_mesh.global_number_of_cells()))
  { m_best.map = std::move(start); }

  const Found_map_3& best() const { return m_best; }

  // Is there a proof that no map can mend the few cells that are still inverted?
  bool is_in_vain() const
  {
    return is_unsolved() && m_best.map.number_of_inverted_cells <= m_few_cells && m_mesh.is_whole()
        && !prove_infeasibility_3(m_mesh, m_best.map.inverted_cells, m_progress.budget()).empty();
  }

  bool is_unsolved() const { return m_best.status == ERROR_NOT_FLIP_FREE; }

  // Looks for edges whose splits leave fewer cells inverted, if few or at most that number are; only once for the same map.
  bool finds_splits() { return finds_splits(m_few_cells); }
  bool finds_splits(const std::size_t maximum_number)
  {
    const std::size_t number = m_best.map.number_of_inverted_cells;
    if(!is_unsolved() || number > maximum_number || number >= m_fewest_without_splits || m_progress.is_interrupted())
      return false;
    m_fewest_without_splits = number;
    m_progress.begin_stage();
    m_progress.begin_attempt("splits");
    m_best.splits = find_splits_3(m_mesh, m_system.solver(), m_best.map, m_progress);
    return m_best.is_stuck();
  }

  // Starts with all free vertices at one point, if the domain is star-shaped and its boundary fixed.
  void expand_core(const bool may_split)
  {
    if(!is_unsolved() || !m_mesh.is_whole() || !m_mesh.conditions.empty() || m_mesh.alignment || m_progress.is_interrupted())
      return;
    m_progress.begin_stage();
    Expansion_result_3 expansion;
    const Matrix3Xd end = keep_better("expansion of a core", [&]
    {
      expansion = expand_core_3(m_mesh, may_split, m_system.solver(), m_progress);
      return expansion.images;
    });
    if(expansion.images.status == OK && !expansion.edges.empty())
      m_best.splits = { std::move(expansion.edges), std::move(expansion.new_images), end, true };
  }

  // Returns the best map. Cells that have just become positive are flat, and are relaxed.
  Found_map_3 finish(const bool has_moved)
  {
    if(is_unsolved() && m_best.map.is_valid())
      m_best.status = OK;
    if(m_best.status == OK && has_moved)
      m_best.map = evaluated_map(m_mesh, relaxed_flat_cells_3(m_mesh, m_system.solver(), m_best.map.positions,
                                                       m_progress.budget()));
    return std::move(m_best);
  }

  // The whole mesh, and then patches of it. Returns the images that the whole mesh has left to patches.
  Matrix3Xd untangle(const Untangling_attempt_3& attempt, const Matrix3Xd& start)
  { return untangle(attempt, attempt.name, start, m_few_cells); }

  // Goes on with the whole mesh from where it has left few cells to patches and splits, which did not mend them.
  void go_on(const Untangling_attempt_3& attempt, const Matrix3Xd& end)
  {
    if(inverted_cells(m_mesh, end).number <= m_few_cells)
      untangle(attempt, std::string(attempt.name) + ", continued", end, 0);
  }

  // Unless so many cells are inverted that they are no exceptions.
  void untangle_patches(const Matrix3Xd& start, const std::string& method)
  {
    if(inverted_cells(m_mesh, start).number <= maximum_number_of_exceptions(m_mesh.global_number_of_cells()))
      keep_better(method, [&] { return untangle_patches_3(m_mesh, m_system.solver(), start, m_progress, m_number_of_rings); });
  }

  // Either patches of a map suffice, or no map can mend the cells that stay inverted, or these are jammed, and nothing to go on
  // from. The search also goes on if cells are too flat to minimize: the harmonic map shrinks thin parts exponentially.
  void begin_with_patches(const Matrix3Xd& map)
  {
    constexpr double flat_volume = 1e-12; // a guess; relative to the mean volume
    const Found_map_3 start = m_best;
    untangle_patches(map, "patches");
    if(is_unsolved() && !is_in_vain())
      m_best = start;
    else if(m_best.status == OK && m_system.smallest_relative_volume(m_best.map.positions) < flat_volume)
      m_best.status = ERROR_NOT_FLIP_FREE;
  }

private:
  Matrix3Xd untangle(const Untangling_attempt_3& attempt, const std::string& name, const Matrix3Xd& start,
                     const std::size_t few_cells)
  {
    Matrix3Xd end = keep_better(name, [&] { return untangle_with_3(attempt, m_system, start, m_progress, few_cells); });
    if(is_unsolved())
      untangle_patches(end, name + ", patches");
    return end;
  }

  // Returns the images that `find()` does, and keeps them if they are the best. Images without inverted cells replace others
  // of that kind if there were steps, as those were flat.
  Matrix3Xd keep_better(const std::string& method, const std::function<Newton_result_3()>& find)
  {
    m_progress.begin_attempt(method);
    const std::size_t steps_before = m_progress.number_of_steps();
    const Newton_result_3 result = find();
    const bool has_moved = m_progress.number_of_steps() > steps_before;
    Map_3 map = evaluated_map(m_mesh, result.positions);
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
  int m_number_of_rings; // of the largest patches; a guess
  std::size_t m_few_cells;
  Found_map_3 m_best;
  std::size_t m_fewest_without_splits = (std::numeric_limits<std::size_t>::max)(); // inverted cells for which none were found
};

// Makes one attempt after the other, each from the start, until no cell is inverted, or all are in vain. Where one leaves few
// cells, others mostly leave as many, so these are rather left to splits of edges, if these may be and are found. If all of this
// fails, a core is expanded, if it may be, and at last the attempts go on from where they have stopped.
inline void make_attempts_3(Untangling_search_3& search, const Numbered_mesh_3& mesh, const Matrix3Xd& start,
                            const bool may_split, const bool may_expand)
{
  std::vector<std::pair<Untangling_attempt_3, Matrix3Xd> > ends;
  for(const Untangling_attempt_3& attempt : untangling_attempts)
  {
    if(search.is_in_vain())
      break;
    if(search.is_unsolved())
      ends.emplace_back(attempt, search.untangle(attempt, start));
    if(may_split && search.finds_splits())
      return;
  }
  if(may_expand && (may_split || !search.is_in_vain()))
    search.expand_core(may_split);
  if(search.best().is_stuck())
    return;
  for(const auto& [attempt, end] : ends)
    if(mesh.is_whole() && search.is_unsolved() && !search.is_in_vain()) // processes would count other cells
      search.go_on(attempt, end);
  if(may_split)
    search.finds_splits(maximum_number_of_exceptions(mesh.global_number_of_cells()));
}

// Few inverted cells of a map with respect to regular cells are patched. Otherwise makes the attempts from the start.
inline Found_map_3 untangle_map_3(Newton_system_3& system, const Map_3& start, const Matrix3Xd& regular_start,
                                  const bool may_split, Progress_3& progress)
{
  Untangling_search_3 search(system, start, progress, may_split);
  search.begin_with_patches(regular_start);
  make_attempts_3(search, system.mesh(), start.positions, may_split, true);
  return search.finish(progress.number_of_steps() > 0);
}

// Continues from images that an earlier search has left with few inverted cells, or none. If the first splits do not suffice, a
// core is expanded: further rounds take longer, and leave meshes in which it is harder.
inline Found_map_3 continue_untangling_3(Newton_system_3& system, const Matrix3Xd& start, const bool may_split,
                                         const bool may_expand, Progress_3& progress)
{
  Untangling_search_3 search(system, evaluated_map(system.mesh(), start), progress, may_split);
  search.untangle_patches(start, "patches");
  if(may_expand)
    search.expand_core(may_split);
  if(!search.best().is_stuck())
    make_attempts_3(search, system.mesh(), Matrix3Xd(search.best().map.positions), may_split, false);
  return search.finish(true);
}

// Returns the initial map with an image for each vertex: a prescribed vertex without one is on its target, and the others
// without one, as those that a refinement has inserted, are where they minimize the Dirichlet energy. Returns no images at
// all if none are given.
inline Matrix3Xd completed_initial_map_3(const Numbered_mesh_3& mesh, Linear_solver_3& solver, Progress_3& progress)
{
  Matrix3Xd result = mesh.initial;
  const auto is_missing = [&](const int v) { return mesh.initial.col(v).hasNaN(); };
  for(int v = 0; v < result.cols(); ++v)
    if(is_missing(v))
      result.col(v) = mesh.target.col(v);
  const Unknowns_3 unknowns(static_cast<int>(result.cols()), [&](const int v) { return mesh.is_free(v) && is_missing(v); });
  if(unknowns.size() == 0)
    return result;
  Newton_system_3 system(mesh, unknowns, solver);
  harmonic_map_3(system, result, progress);
  return result;
}

// Returns the images from which displacements of prescribed vertices to their targets are extended if there is no initial map:
// one point, which gives the harmonic map, or the source near the targets if a part of the boundary is free. Then a coordinate
// that the source misses by more than the mean of the targets does is constant, as that across a shell which becomes flat.
inline Matrix3Xd first_images_3(const Numbered_mesh_3& mesh)
{
  if(!mesh.alignment)
  {
    Matrix3Xd points(3, mesh.number_of_vertices());
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      points.col(v) = mesh.base_point;
    return points;
  }
  Matrix3Xd result = moved(*mesh.alignment, mesh.source);
  for(int axis = 0; axis < 3 && !mesh.conditions.empty(); ++axis)
  {
    std::vector<double> targets;
    double misfit = 0, spread = 0;
    for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices(); ++v)
      if(mesh.projector(v).row(axis) == Vector_3::Zero())
      {
        targets.push_back(mesh.target(axis, v));
        misfit += CGAL::square(mesh.target(axis, v) - result(axis, v));
      }
    const double mean = std::accumulate(targets.begin(), targets.end(), 0.) / static_cast<double>(targets.size());
    for(const double t : targets)
      spread += CGAL::square(t - mean);
    const bool are_equal = std::adjacent_find(targets.begin(), targets.end(), std::not_equal_to<double>()) == targets.end();
    if(!are_equal && misfit > spread)
      result.row(axis).setConstant(mean);
  }
  return result;
}

// Starts from `initial`, moves the prescribed vertices to their targets, extends the displacements harmonically, and
// untangles. With one point for `initial` this starts from the harmonic map, which recovers affine maps. If it inverts cells,
// so may that with respect to regular cells, but mostly fewer, so that patches suffice.
inline Found_map_3 untangle_from_3(Newton_system_3& system, const Matrix3Xd& initial, const bool may_split,
                                   Progress_3& progress)
{
  const Numbered_mesh_3& mesh = system.mesh();
  constexpr double energy_tolerance = 1e-6; // of what is a start only
  progress.begin_stage();
  Matrix3Xd displacements = snapped(mesh, initial) - initial;
  const auto image = [&]() -> Matrix3Xd { return snapped(mesh, initial + displacements); };
  Newton_direction_3 direction = harmonic_map_3(system, displacements, progress, energy_tolerance);
  const Map_3 start = evaluated_map(mesh, image());
  if(direction.is_usable() && !start.is_valid() && !progress.is_interrupted())
    direction = harmonic_map_3(system, displacements, progress, energy_tolerance, Reference_cells::REGULAR);
  progress.reach_flip_free();
  Found_map_3 found;
  if(direction.is_usable())
    found = untangle_map_3(system, start, image(), may_split, progress);
  else
  {
    found.map = start;
    found.status = ERROR_LINEAR_SOLVER_FAILED;
    found.reason = describe_failure(direction);
  }
  found.number_of_inverted_cells_at_start = start.number_of_inverted_cells;
  return found;
}

// Continues from the start, if its stage is untangling. Otherwise starts from the initial map. If this fails or there is none,
// starts from the harmonic map.
inline Found_map_3 untangle_mesh_3(Newton_system_3& system, const Search_start_3& start, Progress_3& progress)
{
  const Numbered_mesh_3& mesh = system.mesh();
  const bool continues = start.stage == Search_start_3::Stage::UNTANGLING, may_split = start.may_split_inverted_cells();
  Found_map_3 found;
  progress.begin_stage();
  const Matrix3Xd initial = continues ? start.positions : completed_initial_map_3(mesh, system.solver(), progress);
  if(continues)
    found = continue_untangling_3(system, initial, may_split, start.number_of_rounds == 1, progress);
  else if(initial.cols() > 0)
  {
    found = untangle_from_3(system, initial, may_split, progress);
    found.may_be_near_minimum = found.status == OK && progress.number_of_steps() == 0;
  }
  if(!continues && found.status == ERROR_NOT_FLIP_FREE && !found.is_stuck())
    found = untangle_from_3(system, first_images_3(mesh), may_split, progress);
  if(found.untangling_method.empty())
    found.untangling_method = start.method;
  return found;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_UNTANGLING_UNTANGLE_MESH_3_H
