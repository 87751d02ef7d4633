// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_EXPANSION_EXPAND_CORE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_EXPANSION_EXPAND_CORE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Expansion/relax_vertices_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/untangle_patches_3.h>

#include <optional>
#include <queue>
#include <tuple>

namespace CGAL::Volume_mesh_parameterization::internal {

// Returns a point that sees the targets of all facets of cells with one free vertex from inside, if there is one.
inline std::optional<Vector_3> star_center_3(const Numbered_mesh_3& mesh)
{
  constexpr int number_of_steps = 500; // a guess; half as long as the one before every 50 steps
  const Box_3 box = target_box(mesh);
  Vector_3 center = 0.5 * (box.smallest + box.largest), best = center;
  std::vector<std::pair<Vector_3, Vector_3> > planes; // points and inner unit normals
  for(const std::array<int, 4>& cell : mesh.cells)
    if(std::count_if(cell.begin(), cell.end(), [&](const int v) { return mesh.is_free(v); }) == 1)
    {
      const std::size_t i = std::find_if(cell.begin(), cell.end(), [&](const int v) { return mesh.is_free(v); }) - cell.begin();
      const auto [a, b, c] = facet_of_cell(cell, i);
      const Vector_3 p = mesh.target.col(a), q = mesh.target.col(b), r = mesh.target.col(c);
      planes.emplace_back(p, -((q - p).cross(r - p)).normalized());
    }
  double highest = -std::numeric_limits<double>::infinity();
  for(int step = 0; step < number_of_steps && !planes.empty(); ++step)
  {
    const auto height = [&](const auto& plane) { return (center - plane.first).dot(plane.second); };
    const auto lowest = std::min_element(planes.begin(), planes.end(),
                                         [&](const auto& s, const auto& t) { return height(s) < height(t); });
    if(height(*lowest) > highest)
    {
      highest = height(*lowest);
      best = center;
    }
    center += std::exp2(-step / 50 - 5) * box.diagonal().norm() * lowest->second;
  }
  return highest > 0 ? std::optional<Vector_3>(best) : std::nullopt;
}

// Moves all vertices outside of the core, and the core as a whole, by Newton steps of the conformal energy.
inline void relax_open_cells_3(Core_map_3& core, Linear_solver_3& solver, const Budget& budget, const std::size_t number_of_steps)
{
  Core_map_3::Contracted_mesh contracted = core.contracted_mesh();
  Newton_system_3 system(contracted.mesh, free_vertices(contracted.mesh), solver);
  const Untangling_energy_3 conformal(0, 0);
  Progress_3 steps(budget, number_of_steps);
  contracted.positions
    = minimize_energy_3(system, Cell_energy_of<Untangling_energy_3>(conformal), contracted.positions, steps).positions;
  core.take(contracted);
}

// Lets vertices leave the core one after the other. Those with the most room go first.
class Expansion_3
{
public:
  explicit Expansion_3(Core_map_3& core) : m_core(core), m_stamps(core.number_of_vertices(), 0), m_failures(m_stamps)
  {}

  // Lets all vertices leave that have room. Returns how many have left.
  int expand(const Budget& budget)
  {
    int number = 0;
    m_queue = {};
    for(int v = 0; v < m_core.number_of_vertices(); ++v)
      push(v);
    while(!m_queue.empty() && m_core.size() > 1 && !budget.is_exhausted())
    {
      const auto [room, v, stamp] = m_queue.top();
      m_queue.pop();
      if(stamp == m_stamps[v] && m_core.is_in_core(v))
        number += leaves(v);
    }
    return number;
  }

  // Makes room for some vertices that have none. Returns how many have left then.
  int expand_by_untangling(const Budget& budget)
  {
    constexpr int sufficient_number = 20; // a guess
    std::vector<std::pair<int, int> > candidates;
    for(int v = 0; v < m_core.number_of_vertices(); ++v)
      if(m_core.is_in_core(v) && m_core.may_leave(v))
        if(const std::optional<Vector_3> p = open_point(v))
          candidates.emplace_back(m_failures[v], v);
    std::sort(candidates.begin(), candidates.end());
    int number = 0;
    for(const auto& [failures, v] : candidates)
    {
      if(number == sufficient_number || m_core.size() == 1 || budget.is_exhausted())
        break;
      const std::optional<Vector_3> p = open_point(v);
      if(!p || !m_core.may_leave(v))
        continue;
      m_core.leave(v, *p);
      if(untangle_around_3(m_core, v))
      {
        relax_around_3(m_core, v);
        ++number;
      }
      else
      {
        m_core.take_back(v);
        ++m_failures[v];
      }
    }
    return number;
  }

  // Splits the edges from vertices that cannot leave to the prescribed vertices of their open facets, or, if there are none, to
  // the others. The new vertices can leave to where they see both edges of the rim there, and then move, so that the rim does.
  // Returns whether there are such edges.
  bool split_spokes()
  {
    for(const bool are_prescribed : { true, false })
    {
      std::vector<std::array<int, 2> > edges;
      for(int v = 0; v < m_core.number_of_vertices(); ++v)
        if(m_core.is_in_core(v) && !m_core.is_new(v) && m_core.is_contractible_without(v))
        {
          std::set<int> ends;
          for(const Core_map_3::Side& side : m_core.sides(v))
            if(const std::array<int, 3> facet = m_core.facet(side); m_core.number_in_core(facet) == 0)
              for(const int w : facet)
                if(!m_core.is_new(w) && m_core.is_prescribed(w) == are_prescribed)
                  ends.insert(w);
          for(const int w : ends)
            edges.push_back({ v, w });
        }
      for(const auto& [v, w] : edges)
        m_core.split(v, w);
      m_stamps.resize(m_core.number_of_vertices(), 0);
      m_failures.resize(m_core.number_of_vertices(), 0);
      if(!edges.empty())
        return true;
    }
    return false;
  }

private:
  static constexpr double least_room = 0.006; // a guess; the sine of an angle

  void push(const int v)
  {
    if(!m_core.is_in_core(v) || !m_core.may_leave(v))
      return;
    if(const double room = m_core.way_out(v).room; room > least_room)
      m_queue.emplace(room, v, ++m_stamps[v]);
  }

  bool leaves(const int v)
  {
    if(!m_core.may_leave(v))
      return false;
    const Core_map_3::Way_out way = m_core.way_out(v);
    if(way.room <= least_room)
      return false;
    m_core.leave(v, way.point);
    if(!m_core.are_cells_positive(v))
    {
      m_core.take_back(v);
      return false;
    }
    relax_around_3(m_core, v);
    std::set<int> near;
    for(const int w : m_core.neighbors(v))
      for(const int u : m_core.neighbors(w))
        if(m_core.is_in_core(u))
          near.insert(u);
    for(const int u : near)
      push(u);
    return true;
  }

  // A point in the mean direction of the open facets of a vertex of the core, if it has some.
  std::optional<Vector_3> open_point(const int v) const
  {
    const Vector_3 center = m_core.position(v);
    Vector_3 direction = Vector_3::Zero();
    double distance = std::numeric_limits<double>::infinity();
    for(const Core_map_3::Side& side : m_core.sides(v))
      if(const std::array<int, 3> facet = m_core.facet(side); m_core.number_in_core(facet) == 0)
        for(const int w : facet)
        {
          direction += (m_core.position(w) - center).normalized();
          distance = (std::min)(distance, (m_core.position(w) - center).norm());
        }
    return direction.norm() > 0 ? std::optional<Vector_3>(center + 0.5 * distance * direction.normalized()) : std::nullopt;
  }

  Core_map_3& m_core;
  std::vector<int> m_stamps, m_failures;
  std::priority_queue<std::tuple<double, int, int> > m_queue; // room, vertex, stamp of the vertex
};

// Images of all vertices, with flat cells if some cannot leave the core, and the splits of edges that they are for.
struct Expansion_result_3
{
  Newton_result_3 images;
  Edges_3 edges;
  std::vector<Vector_3> new_images;
};

// Maps a body to a star-shaped domain. All free vertices start at a point that sees all of the boundary, and leave it one by one;
// no open cell is ever inverted. If no other vertex can leave, edges are split, if they may be.
inline Expansion_result_3 expand_core_3(const Numbered_mesh_3& mesh, const bool may_split, Linear_solver_3& solver,
                                        Progress_3& progress)
{
  constexpr std::size_t number_of_steps = 20; // a guess
  constexpr int patience = 2; // a guess
  const std::size_t maximum_number_of_splits = mesh.number_of_vertices() / 5; // a guess: a ball that succeeds needs a tenth
  const std::optional<Vector_3> center = star_center_3(mesh);
  if(!center)
    return { { mesh.target, 0, ERROR_NOT_FLIP_FREE }, {}, {} };
  Core_map_3 core(mesh, *center);
  Expansion_3 expansion(core);
  const Budget& budget = progress.budget();
  for(int number_in_vain = 0; core.size() > 1 && number_in_vain < patience && progress.may_continue(); )
  {
    if(expansion.expand(budget) > 0 || expansion.expand_by_untangling(budget) > 0)
      number_in_vain = 0;
    else
    {
      relax_open_cells_3(core, solver, budget, number_of_steps);
      const bool may_split_more = may_split && core.splits().size() < maximum_number_of_splits;
      if(++number_in_vain == patience && may_split_more && expansion.split_spokes())
        number_in_vain = 0;
    }
    Parameterization_step step;
    step.phase = Phase::UNTANGLING;
    step.number_of_inverted_cells = core.number_of_flat_cells();
    progress.after_step(step);
  }
  return { { core.positions(), 0, core.size() == 1 ? OK : progress.status_of_end(false) }, core.splits(), core.new_positions() };
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_EXPANSION_EXPAND_CORE_3_H
