// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Hexahedral_mesh_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/Box_grid_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/smooth_hexahedra_3.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Has the map a cell, and only finite coordinates at the vertices of cells?
inline Input_check_3 check_map_3(const Mapped_soup_3& soup)
{
  if(soup.cells.empty())
    return failed_check(ERROR_EMPTY_COMPLEX, get_error_message(ERROR_EMPTY_COMPLEX));
  for(const std::array<std::size_t, 4>& cell : soup.cells)
    for(const std::size_t v : cell)
      if(!to_vector(soup.points.at(v)).allFinite() || !to_vector(soup.images.at(v)).allFinite())
        return failed_check(ERROR_NON_FINITE_COORDINATE, "Point ", v, " has the coordinates ",
                            describe(to_vector(soup.points[v])), " and the image ", describe(to_vector(soup.images[v])),
                            ".");
  return {};
}

// The preimages of points, in blocks between which the budget is asked; none at all once it is exhausted.
inline Locations_3 preimages_3(const Volume_map_3& map, const std::vector<std::array<double, 3> >& points,
                               const bool is_parallel, const Budget& budget)
{
  constexpr std::size_t size_of_block = 4096;
  Locations_3 result;
  result.reserve(points.size());
  std::vector<Volume_map_3::Point_3> block;
  for(const std::array<double, 3>& q : points)
  {
    block.emplace_back(q[0], q[1], q[2]);
    if(block.size() < size_of_block && result.size() + block.size() < points.size())
      continue;
    if(budget.is_exhausted())
      return {};
    const Locations_3 found = is_parallel ? map.preimages<Parallel_if_available_tag>(block) : map.preimages(block);
    result.insert(result.end(), found.begin(), found.end());
    block.clear();
  }
  return result;
}

// Finds the images of vertices inside.
inline void set_inner_images(const Volume_map_3& map, const bool is_parallel, Hexahedron_soup_3& mesh)
{
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  for_each_index(is_parallel, 0, mesh.points.size(), [&](const std::size_t v)
  {
    const std::array<double, 3>& p = mesh.points[v];
    if(is_outer[v])
      return;
    if(const auto image = map.nearest_image(Volume_map_3::Point_3(p[0], p[1], p[2])))
      mesh.images[v] = { image->point.x(), image->point.y(), image->point.z() };
  });
}

// The result where the input does not allow a mesh.
inline Hexahedral_mesh_result refused_result(const Input_check_3& check)
{
  Hexahedral_mesh_result result;
  result.status = check.status;
  result.message = check.message;
  return result;
}

// The result for a mesh.
inline Hexahedral_mesh_result judged(const Hexahedron_soup_3& mesh, const bool has_padding)
{
  Hexahedral_mesh_result result;
  result.number_of_vertices = mesh.points.size();
  result.number_of_cells = mesh.cells.size();
  result.has_padding = has_padding;
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  result.number_of_boundary_vertices = std::count(is_outer.begin(), is_outer.end(), true);

  std::string place;
  for_each_corner(mesh, [&](const std::array<std::size_t, 4>& corner)
  {
    if(!is_positive_corner(mesh, corner) && result.number_of_inverted_corners++ == 0)
      place = " The first one is at " + describe(to_vector(mesh.points[corner[0]]))
              + (is_outer[corner[0]] ? ", on the boundary." : ", inside.");
  });
  const std::vector<double> quality = scaled_jacobians(mesh);
  result.minimal_scaled_jacobian = *std::min_element(quality.begin(), quality.end());
  result.mean_scaled_jacobian = std::accumulate(quality.begin(), quality.end(), 0.) / quality.size();
  result.status = result.number_of_inverted_corners == 0 ? OK : ERROR_INVERTED_HEXAHEDRON;
  result.message = get_error_message(result.status) + place;
  return result;
}

constexpr double sufficient_scaled_jacobian = 0.3;
constexpr double poor_scaled_jacobian = 0.1; // to raise the worst corners further costs the others too much

inline bool is_better(const Hexahedral_mesh_result& a, const Hexahedral_mesh_result& b)
{
  return a.number_of_inverted_corners != b.number_of_inverted_corners
         ? a.number_of_inverted_corners < b.number_of_inverted_corners
         : a.minimal_scaled_jacobian > b.minimal_scaled_jacobian;
}

// Improves hexahedra, whose vertices inside have been moved, until they suffice, and keeps the best ones: first all vertices
// move at once, as long as that helps, and then, if corners are poor, one after the other around these.
inline Hexahedral_mesh_result improve_in_rounds(Pulled_back_hexahedra_3& hexahedra, const bool has_padding,
                                                Hexahedron_soup_3& best)
{
  constexpr int maximal_number_of_rounds = 16, patience = 4;
  constexpr double gain = 0.2; // a target far above the worst corners would not serve them most
  best = hexahedra.mesh();
  Hexahedral_mesh_result result = judged(best, has_padding);
  const auto keep_if_better = [&]
  {
    const Hexahedral_mesh_result next = judged(hexahedra.mesh(), has_padding);
    if(!is_better(next, result))
      return false;
    result = next;
    best = hexahedra.mesh();
    return true;
  };
  bool is_sliding = true;
  for(int round = 0, in_vain = 0; round < maximal_number_of_rounds && in_vain < patience; ++round)
  {
    if(result.minimal_scaled_jacobian >= sufficient_scaled_jacobian || hexahedra.budget().is_exhausted())
      break;
    is_sliding = is_sliding && hexahedra.slide();
    if(!is_sliding)
    {
      if(result.minimal_scaled_jacobian >= poor_scaled_jacobian)
        break;
      smooth_hexahedra_3(hexahedra, (std::max)(0., result.minimal_scaled_jacobian) + gain);
    }
    bool is_better_now = keep_if_better();
    if(hexahedra.budget().is_exhausted())
      break;
    hexahedra.improve_inside();
    is_better_now = keep_if_better() || is_better_now;
    in_vain = is_better_now || is_sliding ? 0 : in_vain + 1;
    is_sliding = is_sliding && is_better_now;
  }
  return result;
}

// Hexahedra of a map to a domain whose boundary facets are orthogonal to the axes, with and without a layer along the
// boundary. The mesh is written if all corners are positive, as the status then tells, and only then.
inline Hexahedral_mesh_result find_hexahedra_3(const Mapped_soup_3& soup, const double spacing,
                                               Linear_solver_3& solver, const bool is_parallel, const Budget& budget,
                                               Hexahedron_soup_3& mesh)
{
  const Input_check_3 check = check_map_3(soup);
  if(check.status != OK)
    return refused_result(check);
  const Box_grid_3 grid(soup.cells, soup.images, spacing);
  if(grid.check().status != OK)
    return refused_result(grid.check());

  const Volume_map_3 map(soup.points, soup.cells, soup.images);
  Locations_3 places;
  Hexahedron_soup_3 boxes = grid.boxes([&](const std::vector<std::array<double, 3> >& centers)
  {
    return places = preimages_3(map, centers, is_parallel, budget);
  });
  for(const std::optional<Volume_map_3::Location>& place : places)
    if(place)
      boxes.cell_references.push_back(soup.cell_references.empty() ? 0 : soup.cell_references[place->cell]);
  if(boxes.cells.empty() && !budget.is_exhausted())
    return refused_result(failed_check(ERROR_INVERTED_TARGET_BOUNDARY,
                                       get_error_message(ERROR_INVERTED_TARGET_BOUNDARY)));

  Hexahedron_soup_3 best;
  Hexahedral_mesh_result result = refused_result(failed_check(ERROR_INTERRUPTED, get_error_message(ERROR_INTERRUPTED)));
  const auto keep_if_better = [&](const Hexahedral_mesh_result& next, const Hexahedron_soup_3& next_mesh)
  {
    if(best.cells.empty() || is_better(next, result))
    {
      result = next;
      best = next_mesh;
    }
  };
  std::vector<Pulled_back_hexahedra_3> candidates; // without and with padding
  std::vector<Hexahedral_mesh_result> first_results;
  for(const bool has_padding : {false, true})
  {
    if(result.minimal_scaled_jacobian >= sufficient_scaled_jacobian || budget.is_exhausted())
      break;
    const Hexahedron_soup_3 domain = has_padding ? padded(boxes) : boxes;
    const Locations_3 preimages = preimages_3(map, domain.points, is_parallel, budget);
    if(budget.is_exhausted())
      break;
    candidates.emplace_back(map, domain, preimages, spacing, solver, is_parallel, budget);
    candidates.back().improve_inside();
    first_results.push_back(judged(candidates.back().mesh(), has_padding));
    keep_if_better(first_results.back(), candidates.back().mesh());
  }
  // The other one is seldom better then if it has inverted corners now, but takes most of the time.
  const bool begins_with_padding = result.has_padding;
  for(const bool has_padding : {begins_with_padding, !begins_with_padding})
  {
    if(has_padding >= candidates.size() || result.minimal_scaled_jacobian >= sufficient_scaled_jacobian
       || budget.is_exhausted())
      break;
    if(has_padding != begins_with_padding && first_results[has_padding].number_of_inverted_corners > 0
       && result.minimal_scaled_jacobian >= poor_scaled_jacobian)
      break;
    Hexahedron_soup_3 candidate;
    const Hexahedral_mesh_result of_candidate = improve_in_rounds(candidates[has_padding], has_padding, candidate);
    keep_if_better(of_candidate, candidate);
  }
  result.is_interrupted = budget.is_exhausted();
  if(result.status == OK)
  {
    set_inner_images(map, is_parallel, best);
    mesh = std::move(best);
  }
  else if(result.is_interrupted)
    result.status = ERROR_INTERRUPTED;
  if(result.is_interrupted)
    result.message = get_error_message(ERROR_INTERRUPTED)
      + std::string(result.status == OK ? " The hexahedra have positive corners, but better ones might have been found."
                                        : " There are no hexahedra with positive corners yet.");
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_H
