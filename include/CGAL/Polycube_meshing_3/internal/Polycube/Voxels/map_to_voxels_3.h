// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_MAP_TO_VOXELS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_MAP_TO_VOXELS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_map_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Unit_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Drawn_polycube_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Placement_of_voxel_faces_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Routed_charts_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Voxel_simplification_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/directions.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/ordered_coordinates_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>

#include <map>

namespace CGAL::Polycube_meshing_3::internal {

// Returns coordinates of charts that keep the order of the planes of the voxels along each axis and are at least a gap apart.
// The polycube stays embedded, because monotone functions of the coordinates map space. Among such coordinates, the returned ones
// are closest to the mean coordinates of the planes on the surface, by least squares.
inline std::vector<double> coordinates_of_voxel_charts_3(const Facets_3& facets, const std::vector<std::size_t>& chart_of_facet,
                                                         const std::vector<std::size_t>& label_of_chart,
                                                         const std::vector<int>& plane_of_chart, const double gap,
                                                         const Plane_grid_3& grid)
{
  std::vector<double> result(label_of_chart.size());
  for(int axis = 0; axis < 3; ++axis)
  {
    const auto is_along_axis = [&](const std::size_t c) { return axis_of_direction(label_of_chart[c]) == axis; };
    std::map<int, std::size_t> number_of_plane; // among those with a chart, in ascending order
    for(std::size_t c = 0; c < label_of_chart.size(); ++c)
      if(is_along_axis(c))
        number_of_plane.emplace(plane_of_chart[c], 0);
    std::size_t n = 0;
    for(auto& [plane, number] : number_of_plane)
      number = n++;
    std::vector<Order_of_coordinates> orders; // a chain, which always has coordinates
    for(std::size_t k = 1; k < n; ++k)
      orders.push_back({ k - 1, k, gap });
    std::vector<double> areas(n, 0), moments(n, 0);
    for(std::size_t f = 0; f < chart_of_facet.size(); ++f)
      if(const std::size_t c = chart_of_facet[f]; is_along_axis(c))
      {
        const std::size_t number = number_of_plane.at(plane_of_chart[c]);
        areas[number] += facets.areas[f];
        moments[number] += facets.areas[f] * facets.centers[f][axis];
      }
    const std::vector<double> coordinates = ordered_coordinates_3(areas, moments, orders, grid, axis).value().values;
    for(std::size_t c = 0; c < label_of_chart.size(); ++c)
      if(is_along_axis(c))
        result[c] = coordinates[number_of_plane.at(plane_of_chart[c])];
  }
  return result;
}

// Places the faces of voxels on a surface, simplifies the voxels, and returns their polycube. Moves may change corners at first,
// as moves that keep corners leave more charts. If the surface has no map to the polycube then, all moves keep corners.
inline Polycube_of_voxels_3 polycube_of_voxels_3(const Voxels_3& given, const Unit_surface_3& surface, const Budget& budget)
{
  Voxels_3 voxels = given;
  const Facets_3 facets(surface.mesh);
  const Voxel_faces_3 faces = Placement_of_voxel_faces_3(facets, voxels.spacing).run(Voxel_faces_3(voxels));
  const Label_functional_3 functional(surface.mesh, surface.is_sharp);
  const Pieces_of_surface_3 pieces(surface.mesh, functional, nearest_voxel_faces_3(facets, faces, voxels.spacing),
                                   faces.faces.size());
  std::vector<std::size_t> face_of_piece;
  for(const bool do_keep_corners : { false, true })
  {
    voxels = given;
    Voxel_simplification_3 simplification(voxels, faces, pieces, do_keep_corners);
    simplification.run(budget);
    face_of_piece = simplification.face_of_piece();
    if(are_corners_those_of_charts(Charts_of_voxels_3(voxels), faces, face_of_piece))
      break;
  }

  std::vector<std::size_t> labels;
  std::vector<int> planes;
  for(const std::size_t face : face_of_piece)
  {
    const std::size_t label = direction_of_face(face);
    labels.push_back(label);
    planes.push_back(voxels.voxel(voxel_of_face(face))[axis_of_direction(label)] + (sign_of_direction(label) > 0));
  }
  return Polycube_of_voxels_3(voxels.spacing, faces, labels, planes);
}

// Maps a surface with the charts of a polycube that are drawn on it. Relaxes the charts first, and splits edges that lead through
// charts between their borders. If that fails, calls `visit(p)` for the center p of each flipped facet.
template <typename Function>
Surface_map_3 map_drawn_polycube_3(const Polycube_of_voxels_3& polycube, Drawn_polycube_3 drawn, const Budget& budget,
                                   const Function& visit)
{
  constexpr double gap = 0.3; // between planes, in voxels; a guess
  const Unit_surface_3& surface = drawn.surface;
  relax_charts_3(surface, polycube.charts.labels(), drawn.chart_of_facet);
  split_between_borders(drawn);
  std::vector<std::size_t> labels;
  for(const std::size_t c : drawn.chart_of_facet)
    labels.push_back(polycube.charts.labels()[c]);
  const double size = surface.box.diagonal().maxCoeff();
  const Facets_3 facets(surface.mesh);
  const std::vector<double> coordinates
    = coordinates_of_voxel_charts_3(facets, drawn.chart_of_facet, polycube.charts.labels(),
                                    polycube.plane_of_chart, gap * polycube.size_of_voxels,
                                    { -surface.box.center() / size, surface.spacing / size });
  Polycube_map_3 map(surface, labels);
  std::vector<double> coordinates_in_map(map.charts().number_of_charts());
  if(coordinates_in_map.size() != coordinates.size())
    return {};
  for(std::size_t f = 0; f < labels.size(); ++f)
    coordinates_in_map[map.charts().chart_of_face()[f]] = coordinates[drawn.chart_of_facet[f]];
  const Error_code status = map.start_at(coordinates_in_map, budget);
  Surface_map_3 result = status == OK ? finished_map_3(map, budget) : Surface_map_3{ status };
  if(result.status != OK)
    for(const auto f : map.flipped_faces())
      visit(facets.centers[f]);
  result.splits = std::move(drawn.surface.splits);
  return result;
}

// Maps a surface to a polycube of voxels. Where the charts cannot be drawn or mapped, edges near their borders become shorter. The
// shortest edges are made only if they are allowed.
inline Surface_map_3 map_to_polycube_of_voxels_3(const Polycube_of_voxels_3& polycube, const Unit_surface_3& surface,
                                                 const bool may_have_shortest_edges, const Budget& budget)
{
  const double least = (may_have_shortest_edges ? 0.25 : 0.5) * polycube.size_of_voxels; // guesses
  Lengths_at_chains_3 lengths(polycube);
  Surface_map_3 map;
  std::set<std::size_t> chains; // that cannot be drawn or mapped
  do
  {
    Drawn_polycube_3 drawn = draw_polycube_3(polycube, surface, lengths, budget);
    chains = std::move(drawn.blocked_chains);
    if(drawn.chart_of_facet.empty())
      continue;
    chains.clear();
    map = map_drawn_polycube_3(polycube, std::move(drawn), budget,
                               [&](const Vector_3& p) { chains.insert(lengths.nearest_chain(p)); });
  }
  while(map.status != OK && lengths.halve(chains, least) && !budget.is_exhausted());
  return map;
}

// Maps a surface to the cheapest of some polycubes of voxels. The voxels are finer and finer, each size at several places.
inline Surface_map_3 map_to_voxels_3(const Unit_surface_3& surface, const Budget& budget)
{
  constexpr int maximum_number_of_maps = 4, maximum_number_of_sizes = 3; // of sizes with maps; guesses, as all these numbers
  constexpr std::array<int, 15> numbers = { 8, 10, 12, 14, 16, 18, 20, 22, 24, 28, 32, 36, 40, 48, 64 }; // voxels along the body
  constexpr std::array<double, 6> least_parts = { 0.5, 0.4, 0.6, 0.5, 0.3, 0.5 }; // of voxels inside, for each place of the grid
  const int characteristic = 2 - 2 * number_of_handles(surface.mesh);
  std::mt19937 random; // of a fixed seed
  const auto shift = [&]() { return static_cast<double>(random()) / 4294967296. - 0.5; }; // by 2^32, as there are as many values
  Surface_map_3 best;
  int number_of_maps = 0, number_of_sizes = 0;
  for(const int number : numbers)
  {
    number_of_sizes += number_of_maps > 0;
    for(std::size_t attempt = 0; number_of_sizes < maximum_number_of_sizes && attempt < least_parts.size(); ++attempt)
    {
      if(number_of_maps == maximum_number_of_maps || !budget.may_begin_round(Phase::BOUNDARY, "polycubes of voxels"))
        return best;
      const double size_of_voxels = 1. / number, x = shift(), y = shift(), z = shift();
      const Vector_3 offset = attempt == 0 ? Vector_3(0, 0, 0) : Vector_3(x, y, z);
      Voxels_3 voxels = voxels_of_surface_3(surface.mesh, size_of_voxels, offset, least_parts[attempt]);
      if(!make_surface_of_characteristic(voxels, least_parts[attempt], characteristic))
        continue;
      Unit_surface_3 fine = surface;
      split_long_edges_3([&](const Vector_3&) { return size_of_voxels; }, fine);
      const Polycube_of_voxels_3 polycube = polycube_of_voxels_3(voxels, fine, budget);
      Surface_map_3 map = map_to_polycube_of_voxels_3(polycube, surface, best.status != OK, budget);
      if(map.status != OK)
        continue;
      ++number_of_maps;
      if(best.status != OK || cost_of_map(map) < cost_of_map(best))
        best = std::move(map);
    }
  }
  return best;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_MAP_TO_VOXELS_3_H
