// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_MAP_TO_BOX_WITH_HOLE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_MAP_TO_BOX_WITH_HOLE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Handles/Box_with_hole_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Handles/Meridians_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_map_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/repair_labels_3.h>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the coordinates of the charts of a box with a hole, after some faces have changed their charts; none if charts have
// been divided, or edges are not along an axis.
inline std::vector<double> coordinates_of_charts(const Polycube_charts_3& charts, const std::vector<std::size_t>& charts_of_box,
                                                 const std::vector<std::size_t>& labels, const std::vector<double>& coordinates)
{
  std::vector<double> result(charts.number_of_charts(), (std::numeric_limits<double>::quiet_NaN)());
  for(std::size_t f = 0; f < charts_of_box.size(); ++f)
    if(const std::size_t c = charts.chart_of_face()[f]; labels[f] == charts.labels()[c])
      result[c] = coordinates[charts_of_box[f]];
  const bool are_whole = result.size() == coordinates.size()
    && std::all_of(result.begin(), result.end(), [](const double x) { return std::isfinite(x); });
  const bool have_axes = std::all_of(charts.chains().begin(), charts.chains().end(),
                                     [](const Polycube_chain_3& chain) { return chain.axis >= 0; });
  return are_whole && have_axes ? result : std::vector<double>();
}

// Maps a surface to the box with a hole between lines. Faces without room between the edges are given to neighboring charts.
inline Surface_map_3 map_to_box_between_lines_3(const Unit_surface_3& surface, const Lines_of_box_3& lines,
                                                const Normal_labels_3& costs, const Budget& budget)
{
  constexpr int maximum_number_of_attempts = 10; // a guess
  const Boundary_mesh_3& mesh = surface.mesh;
  const double size = surface.box.diagonal().maxCoeff();
  Box_with_hole_3 box(mesh, lines);
  if(!box.run())
    return { ERROR_BOUNDARY_TOO_COARSE };
  const std::vector<std::size_t> labels_of_box = box.labels();
  const std::vector<double> coordinates_of_box = box.coordinates({ -surface.box.center() / size, surface.spacing / size });
  std::vector<std::size_t> labels = labels_of_box;
  for(int attempt = 0;
      attempt < maximum_number_of_attempts && budget.may_begin_round(Phase::BOUNDARY, "labels of a box with a hole"); ++attempt)
  {
    if(straighten_chains_3(mesh, Polycube_charts_3(mesh, labels), labels))
      continue;
    Polycube_map_3 map(surface, labels);
    const std::vector<double> coordinates
      = coordinates_of_charts(map.charts(), box.chart_of_face(), labels_of_box, coordinates_of_box);
    if(coordinates.empty())
      break;
    if(map.start_at(coordinates, budget) == OK)
    {
      const double distortion = map.distortion(); // of the harmonic map, by which cuts are compared
      if(map.finish(budget) == OK)
        return { OK, map.images(), distortion };
    }
    if(!give_away_faces(mesh, map.flipped_faces(), costs, labels))
      break;
  }
  return { ERROR_BOUNDARY_TOO_COARSE };
}

// Maps the surface of a body with one handle onto that of a box with a hole, if the mesh is fine enough. Among several cuts of the
// body into a ball, the one of the least distortion is taken. Vertices of cells are numbers of points; `points` has the number of
// the point of each vertex of the surface.
inline Surface_map_3 map_to_box_with_hole_3(const Unit_surface_3& surface, const std::vector<std::array<std::size_t, 4> >& cells,
                                            const std::vector<std::size_t>& points, const Budget& budget)
{
  constexpr std::size_t maximum_number_of_cuts = 16, maximum_number_of_maps = 3; // guesses
  const Boundary_mesh_3& mesh = surface.mesh;
  std::unordered_map<std::size_t, std::size_t> vertex_of_point;
  for(std::size_t v = 0; v < points.size(); ++v)
    vertex_of_point.emplace(points[v], v);
  const Normal_labels_3 costs(mesh, surface.is_sharp, budget);
  Meridians_3 meridians(cells);
  Surface_map_3 best;
  for(std::size_t i = 0, number_of_maps = 0; i < maximum_number_of_cuts && number_of_maps < maximum_number_of_maps
      && budget.may_begin_round(Phase::BOUNDARY, "cuts of a body with a handle"); ++i)
  {
    Meridians_3::Loop meridian = meridians.from(i * cells.size() / maximum_number_of_cuts);
    if(meridian.empty())
      continue;
    for(std::size_t& v : meridian)
      v = vertex_of_point.at(v);
    Lines_of_box_3 lines(mesh, meridian);
    Surface_map_3 map = { ERROR_BOUNDARY_TOO_COARSE };
    if(lines.run(budget))
      map = map_to_box_between_lines_3(surface, lines, costs, budget);
    number_of_maps += map.status == OK;
    if(best.status != OK || map.distortion < best.distortion)
      best = std::move(map);
  }
  if(best.status == OK)
    best.distortion = distortion_3(mesh, best.images);
  return best;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_MAP_TO_BOX_WITH_HOLE_3_H
