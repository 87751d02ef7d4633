// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_SPLIT_BRIDGES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_SPLIT_BRIDGES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/measure_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Simplex_removal_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/find_map_3.h>

#include <set>

namespace CGAL::Volume_mesh_parameterization::internal {

// Marks the points of bridges. A bridge is an edge, facet or cell inside whose vertices are all prescribed, for instance across a
// wall that is one cell thick. No map changes its image.
inline std::vector<bool> points_of_bridges_3(const Body_3& body, const std::vector<bool>& is_prescribed, const Budget& budget)
{
  std::vector<bool> result(is_prescribed.size(), false);
  for_each_simplex_inside(body, is_prescribed, budget, [&](const Simplex_3& simplex)
  {
    for(const std::size_t p : simplex)
      result[p] = true;
  });
  return result;
}

// Returns the map from which a search with fixed boundary starts: the harmonic map, or that with the harmonic displacements
// of an initial map.
inline Matrix3Xd start_of_search_3(const Numbered_mesh_3& mesh, Linear_solver_3& solver, Progress_3& progress)
{
  constexpr double energy_tolerance = 1e-6; // as where the search starts
  Matrix3Xd initial = completed_initial_map_3(mesh, solver, progress);
  if(initial.cols() == 0)
    initial = first_images_3(mesh);
  Newton_system_3 system(mesh, free_vertices(mesh), solver);
  Matrix3Xd displacements = snapped(mesh, initial) - initial;
  harmonic_map_3(system, displacements, progress, energy_tolerance);
  return snapped(mesh, initial + displacements);
}

// Splits the edges, facets and cells inside that belong to distorted prescribed cells.
inline std::vector<Insertion_3> split_distorted_cells_3(Body_3& body, const Numbered_body_3& numbered, const Budget& budget)
{
  std::set<Simplex_3> simplices;
  std::vector<bool> has_distorted_cell(body.points.size(), false);
  for(const std::size_t c : distorted_prescribed_cells_3(numbered.mesh))
  {
    Simplex_3 cell;
    for(const int v : numbered.mesh.cells[c])
      cell.push_back(numbered.points[v]);
    for(const std::size_t p : cell)
      has_distorted_cell[p] = true;
    std::sort(cell.begin(), cell.end());
    for_each_face(cell, [&](const Simplex_3& face) { simplices.insert(face); });
  }
  const auto is_distorted = [&](const Simplex_3& simplex)
  {
    Simplex_3 ascending = simplex;
    std::sort(ascending.begin(), ascending.end());
    return simplices.count(ascending) > 0;
  };
  return Simplex_removal_3(body, is_distorted).run(has_distorted_cell, budget);
}

// Splits all bridges if one has a vertex of a poor cell: of one that is inverted where the search starts, or of a distorted
// prescribed cell. To leave bridges that are far from poor cells costs up to a quarter of the energy and saves few vertices.
// If cells are to be regular, however, each split makes others less regular, and only distorted cells are worth it.
inline std::vector<Insertion_3> split_bridges_3(Body_3& body, const Numbered_body_3& numbered,
                                                const Prescription_3& prescription, const Map_problem_3& problem)
{
  Progress_3& progress = problem.progress;
  if(problem.options.use_regular_references)
    return split_distorted_cells_3(body, numbered, progress.budget());
  Linear_solver_3& solver = problem.solver;
  const Numbered_mesh_3& mesh = numbered.mesh;
  const std::vector<bool> is_prescribed = prescription.fixed_points();
  const std::vector<bool> has_bridge = points_of_bridges_3(body, is_prescribed, progress.budget());
  const auto is_at_bridge = [&](const std::size_t c)
  {
    return std::any_of(mesh.cells[c].begin(), mesh.cells[c].end(),
                       [&](const int v) { return has_bridge[numbered.points[v]]; });
  };
  const auto are_some_at_bridges = [&](const std::vector<std::size_t>& cells)
  { return std::any_of(cells.begin(), cells.end(), is_at_bridge); };

  if(std::find(has_bridge.begin(), has_bridge.end(), true) == has_bridge.end())
    return {};
  if(!are_some_at_bridges(distorted_prescribed_cells_3(mesh))
     && !are_some_at_bridges(inverted_cells(mesh, start_of_search_3(mesh, solver, progress)).cells))
    return {};
  const auto is_bridge = [&](const Simplex_3& simplex) { return is_prescribed_simplex(is_prescribed, simplex); };
  return Simplex_removal_3(body, is_bridge).run(is_prescribed, progress.budget());
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_SPLIT_BRIDGES_3_H
