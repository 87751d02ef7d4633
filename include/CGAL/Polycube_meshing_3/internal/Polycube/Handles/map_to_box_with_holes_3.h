// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_MAP_TO_BOX_WITH_HOLES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_MAP_TO_BOX_WITH_HOLES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Handles/Box_with_holes_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Handles/Meridians_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_map_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/repair_labels_3.h>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the coordinates of the charts of a box with holes, after some faces have changed their charts; none if charts have
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

// Result of mapping a surface to a box with holes.
struct Map_to_box_with_holes_3
{
  std::size_t number_of_flipped_faces = (std::numeric_limits<std::size_t>::max)(); // between edges
  std::vector<bool> has_flipped_face;                                             // for each hole
  std::vector<Vector_3> images;                                            // none if they are not valid
  double distortion = (std::numeric_limits<double>::infinity)();
};

// Maps a surface to the box with holes between lines. Faces without room between the edges are given to neighboring charts.
inline Map_to_box_with_holes_3 map_to_box_between_lines_3(const Unit_surface_3& surface, const Lines_of_box_3& lines,
                                                          const std::vector<int>& turns, const bool may_be_long,
                                                          const Normal_labels_3& costs, const Budget& budget)
{
  constexpr int maximum_number_of_attempts = 10; // a guess
  const Boundary_mesh_3& mesh = surface.mesh;
  const double size = surface.box.diagonal().maxCoeff();
  Map_to_box_with_holes_3 result;
  Box_with_holes_3 box_with_holes(mesh, lines);
  if(!box_with_holes.run(turns))
    return result;
  const std::vector<std::size_t> labels_of_box = box_with_holes.labels();
  const std::vector<double> coordinates_of_box
    = box_with_holes.coordinates(may_be_long, { -surface.box.center() / size, surface.spacing / size });
  std::vector<std::size_t> labels = labels_of_box;
  for(int attempt = 0;
      attempt < maximum_number_of_attempts && budget.may_begin_round(Phase::BOUNDARY, "labels of a box with holes"); ++attempt)
  {
    if(straighten_chains_3(mesh, Polycube_charts_3(mesh, labels), labels))
      continue;
    Polycube_map_3 map(surface, labels);
    const std::vector<double> coordinates
      = coordinates_of_charts(map.charts(), box_with_holes.chart_of_face(), labels_of_box, coordinates_of_box);
    if(coordinates.empty())
      return result;
    const Error_code status = map.start_at(coordinates, budget);
    if(result.has_flipped_face.empty())
    {
      result.number_of_flipped_faces = map.flipped_faces().size();
      result.has_flipped_face.assign(turns.size(), false);
      for(std::size_t k = 0; k < turns.size(); ++k)
        for(const auto f : map.flipped_faces())
          for(const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
            result.has_flipped_face[k] = result.has_flipped_face[k] || box_with_holes.is_at_hole(v, k);
    }
    const double distortion = status == OK ? map.distortion() : result.distortion; // before the images get their size
    if(status == OK && map.finish(budget) == OK)
    {
      result.images = map.images();
      result.distortion = distortion;
      return result;
    }
    if(!give_away_faces(mesh, map.flipped_faces(), costs, labels))
      return result;
  }
  return result;
}

// Maps a surface to a box whose holes are turned as long as fewer faces are flipped: where the surface is narrow, sides of a
// hole may not face the sides of the box or of another hole that they have edges with.
inline Map_to_box_with_holes_3 map_to_turned_box_3(const Unit_surface_3& surface, const Lines_of_box_3& lines,
                                                   const bool may_be_long, const Normal_labels_3& costs, const Budget& budget)
{
  std::vector<int> turns(lines.number_of_holes(), 0);
  Map_to_box_with_holes_3 best = map_to_box_between_lines_3(surface, lines, turns, may_be_long, costs, budget);
  for(bool is_better = true; is_better && best.images.empty(); )
  {
    is_better = false;
    for(std::size_t k = 0; k < turns.size() && best.images.empty(); ++k)
      for(const int turn : { 1, -1, 2, -2, 4, -4, 8, -8, 16, -16 })
        if(!best.has_flipped_face.empty() && best.has_flipped_face[k] && !budget.is_exhausted())
        {
          std::vector<int> candidate = turns;
          candidate[k] += turn;
          Map_to_box_with_holes_3 map = map_to_box_between_lines_3(surface, lines, candidate, may_be_long, costs, budget);
          if(map.images.empty() && map.number_of_flipped_faces >= best.number_of_flipped_faces)
            continue;
          best = std::move(map);
          turns = candidate;
          is_better = true;
          break;
        }
  }
  return best;
}

// Maps the surface of a body with handles onto that of a box with as many holes, if the body can be cut into a ball along
// discs and the mesh is fine enough. Among several cuts, the one of the least distortion is taken. Vertices of cells are
// numbers of points; `points` has the number of the point of each vertex of the surface.
inline Surface_map_3 map_to_box_with_holes_3(const Unit_surface_3& surface, const std::vector<std::array<std::size_t, 4> >& cells,
                                             const std::vector<std::size_t>& points, const Budget& budget)
{
  constexpr std::size_t maximum_number_of_cuts = 16, maximum_number_of_maps = 3; // guesses
  const Boundary_mesh_3& mesh = surface.mesh;
  const std::size_t number_of_holes = number_of_handles(mesh);
  std::unordered_map<std::size_t, std::size_t> vertex_of_point;
  for(std::size_t v = 0; v < points.size(); ++v)
    vertex_of_point.emplace(points[v], v);
  const Normal_labels_3 costs(mesh, surface.is_sharp, budget);
  Meridians_3 meridians(cells);
  bool has_meridians = false;
  Map_to_box_with_holes_3 best;
  for(std::size_t i = 0, number_of_maps = 0; i < maximum_number_of_cuts && number_of_maps < maximum_number_of_maps
      && budget.may_begin_round(Phase::BOUNDARY, "cuts of a body with handles"); ++i)
  {
    std::vector<Meridians_3::Loop> loops = meridians.loops(number_of_holes, i * cells.size() / maximum_number_of_cuts, budget);
    if(loops.size() < number_of_holes)
      continue;
    has_meridians = true;
    for(Meridians_3::Loop& loop : loops)
      for(std::size_t& v : loop)
        v = vertex_of_point.at(v);
    Lines_of_box_3 lines(mesh, loops);
    if(!lines.run(budget))
      continue;
    Map_to_box_with_holes_3 map = map_to_turned_box_3(surface, lines, false, costs, budget);
    if(map.images.empty())
      map = map_to_turned_box_3(surface, lines, true, costs, budget);
    number_of_maps += !map.images.empty();
    if(map.distortion < best.distortion)
      best = std::move(map);
  }
  return { !best.images.empty() ? OK : has_meridians ? ERROR_BOUNDARY_TOO_COARSE : ERROR_NO_POLYCUBE, best.images };
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_MAP_TO_BOX_WITH_HOLES_3_H
