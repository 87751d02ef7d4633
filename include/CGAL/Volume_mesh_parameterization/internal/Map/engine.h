// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_ENGINE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_ENGINE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Found_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/check_input_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Linear_solver_3.h>

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE
#  include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/improve_corners_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/spatial_order_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Map/find_map_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Map/improve_map_3.h>
#  include <CGAL/Volume_mesh_parameterization/internal/Map/make_result_3.h>
#endif

namespace CGAL::Volume_mesh_parameterization::internal {

// The engine: all between numbered arrays and positions. It knows no complex, an energy only as `Cell_energy_3`, and a
// solver only as `Linear_solver_3`; so it is compiled once, with each unit or in a library of its own. To it belongs what
// is declared in check_input_3.h, too.

// Puts vertices and cells into the order of all that follows: free vertices first, neighbors in space are neighbors in
// memory. Writes source, cells, user numbers and the number of free vertices; returns the old number of each vertex.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
std::vector<std::size_t> set_numbered_mesh(const std::vector<std::array<int, 4> >& cells, const Matrix3Xd& points,
                                           const std::vector<bool>& is_prescribed, Numbered_mesh_3& mesh);

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Found_map_3 find_map_3(const Numbered_mesh_3& mesh, const Input_check_3& check, const Cell_energy_3& energy,
                       Linear_solver_3& solver, const Map_options_3& options, Progress_3& progress);

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Matrix3Xd improve_corners_3(const Numbered_mesh_3& mesh, const Corner_goals_3& goals, Linear_solver_3& solver,
                                   const Budget& budget);

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Parameterization_result make_result_3(const Numbered_mesh_3& mesh, const Input_check_3& check, const Found_map_3& found,
                                      const Cell_energy_3& energy, const Linear_solver_3& solver,
                                      const Progress_3& progress);

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Parameterization_result refused_result(const Input_check_3& check, const Progress_3& progress);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_ENGINE_IS_HERE
namespace CGAL::Volume_mesh_parameterization::internal {

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
std::vector<std::size_t> set_numbered_mesh(const std::vector<std::array<int, 4> >& cells, const Matrix3Xd& points,
                                           const std::vector<bool>& is_prescribed, Numbered_mesh_3& mesh)
{
  const std::vector<std::size_t> order = spatial_order_3(points, is_prescribed, mesh.is_parallel);
  mesh.number_of_free_vertices = static_cast<int>(std::count(is_prescribed.begin(), is_prescribed.end(), false));
  mesh.cells = renumbered_cells(cells, places_in(order), mesh.user_numbers, mesh.is_parallel);
  mesh.source.resize(3, points.cols());
  constexpr int vertices_per_range = 4096;
  for_each_in_ranges(mesh.is_parallel, order.size(), vertices_per_range,
                     [&](const std::size_t i) { mesh.source.col(i) = points.col(order[i]); });
  return order;
}

} // namespace CGAL::Volume_mesh_parameterization::internal
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_ENGINE_H
