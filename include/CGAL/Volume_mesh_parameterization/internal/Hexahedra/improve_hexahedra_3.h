// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_IMPROVE_HEXAHEDRA_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_IMPROVE_HEXAHEDRA_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Hexahedral_mesh_result.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/Box_grid_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/Padded_hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/Sliding_hexahedra_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

using Locations_3 = std::vector<std::optional<Volume_map_3::Location> >;

// Checks that a map has a cell, and at the vertices of cells only finite coordinates of sizes that numbers have room for.
inline Input_check_3 check_map_3(const Mapped_soup_3& soup)
{
  if(soup.cells.empty())
    return failed_check(ERROR_EMPTY_COMPLEX, get_error_message(ERROR_EMPTY_COMPLEX));
  check_simplices(soup);
  for(const std::array<std::size_t, 4>& cell : soup.cells)
    for(const std::size_t v : cell)
      if(!to_vector(soup.points[v]).allFinite() || !to_vector(soup.images[v]).allFinite())
        return failed_check(ERROR_NON_FINITE_COORDINATE, "Point ", v, " has the coordinates ",
                            describe(to_vector(soup.points[v])), " and the image ", describe(to_vector(soup.images[v])),
                            ".");
  Eigen::AlignedBox3d source, image;
  for(const std::array<std::size_t, 4>& cell : soup.cells)
    for(const std::size_t v : cell)
    {
      source.extend(to_vector(soup.points[v]));
      image.extend(to_vector(soup.images[v]));
    }
  if(source.sizes().isZero(0))
    return failed_check(ERROR_INVERTED_SOURCE_CELL, "All points of the source coincide.");
  const Input_check_3 check = check_size(source, "source");
  return check.status == OK ? check_size(image, "images") : check;
}

// Returns the preimages of points, in blocks between which the budget is asked; none at all once it is exhausted.
inline Locations_3 preimages_3(const Volume_map_3& map, const std::vector<std::array<double, 3> >& points,
                               const bool is_parallel, const Budget& budget)
{
  constexpr std::size_t size_of_block = 4096; // a guess
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

// Finds the images of vertices. Coordinates that differ from the old ones by rounding alone, as on planes, keep their value.
inline void set_images(const Volume_map_3& map, const bool is_parallel, Hexahedron_soup_3& mesh)
{
  double rounding = 0;
  for(const std::array<double, 3>& q : mesh.images)
    rounding = (std::max)(rounding, 1e-14 * to_vector(q).lpNorm<Eigen::Infinity>());
  for_each_index(is_parallel, 0, mesh.points.size(), [&](const std::size_t v)
  {
    const auto& [x, y, z] = mesh.points[v];
    if(const auto image = map.nearest_image(Volume_map_3::Point_3(x, y, z)))
      for(std::size_t axis = 0; axis < 3; ++axis)
        if(const double q = image->point[static_cast<int>(axis)]; std::abs(q - mesh.images[v][axis]) > rounding)
          mesh.images[v][axis] = q;
  });
}

// Returns the result for input that does not allow a mesh.
inline Hexahedral_mesh_result refused_result(const Input_check_3& check)
{
  Hexahedral_mesh_result result;
  result.status = check.status;
  result.message = check.message;
  return result;
}

// Returns the result for a mesh.
inline Hexahedral_mesh_result evaluated_hexahedra(const Hexahedron_soup_3& mesh, const bool has_padding)
{
  Hexahedral_mesh_result result;
  result.number_of_vertices = mesh.points.size();
  result.number_of_cells = mesh.cells.size();
  result.has_padding = has_padding;
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  result.number_of_boundary_vertices = std::count(is_outer.begin(), is_outer.end(), true);

  std::string where;
  for_each_corner(mesh, [&](const std::array<std::size_t, 4>& corner)
  {
    if(!is_positive_corner(mesh, corner) && result.number_of_inverted_corners++ == 0)
      where = " The first one is at " + describe(to_vector(mesh.points[corner[0]]))
              + (is_outer[corner[0]] ? ", on the boundary." : ", inside.");
  });
  const std::vector<double> quality = scaled_jacobians(mesh);
  result.minimal_scaled_jacobian = *std::min_element(quality.begin(), quality.end());
  result.mean_scaled_jacobian = std::accumulate(quality.begin(), quality.end(), 0.) / quality.size();
  result.has_valid_mesh = result.number_of_inverted_corners == 0;
  result.status = result.has_valid_mesh ? OK : ERROR_INVERTED_HEXAHEDRON;
  result.message = get_error_message(result.status) + where;
  return result;
}

// Tells whether a mesh has fewer inverted corners than another one, or a larger least scaled Jacobian where this is bad, or the
// larger sum of the least one, up to the sufficient one, and the mean: a gain in one of both must not cost as much of the other.
inline bool is_better(const Hexahedral_mesh_result& a, const Hexahedral_mesh_result& b)
{
  const auto quality = [](const Hexahedral_mesh_result& result)
  {
    return (std::min)(result.minimal_scaled_jacobian, sufficient_scaled_jacobian) + result.mean_scaled_jacobian;
  };
  if(a.number_of_inverted_corners != b.number_of_inverted_corners)
    return a.number_of_inverted_corners < b.number_of_inverted_corners;
  const double least_of_a = (std::min)(a.minimal_scaled_jacobian, bad_scaled_jacobian);
  const double least_of_b = (std::min)(b.minimal_scaled_jacobian, bad_scaled_jacobian);
  return least_of_a != least_of_b ? least_of_a > least_of_b : quality(a) > quality(b);
}

// Best hexahedra so far.
struct Best_hexahedra_3
{
  Hexahedral_mesh_result result;
  Hexahedron_soup_3 mesh;

  void take(const Hexahedral_mesh_result& of_next, const Hexahedron_soup_3& next)
  {
    if(mesh.cells.empty() || is_better(of_next, result))
    {
      result = of_next;
      mesh = next;
    }
  }
};

// Returns the hexahedra of a domain, pulled back to the body; none once the budget is exhausted.
inline Hexahedron_soup_3 pulled_back(const Volume_map_3& map, const Hexahedron_soup_3& domain, const bool is_parallel,
                                     const Budget& budget)
{
  const Locations_3 preimages = preimages_3(map, domain.points, is_parallel, budget);
  if(budget.is_exhausted())
    return {};
  Hexahedron_soup_3 result = domain;
  result.images = domain.points;
  for(std::size_t v = 0; v < domain.points.size(); ++v)
  {
    const auto& [x, y, z] = domain.points[v];
    result.points[v] = coordinates(preimages[v] ? preimages[v]->point // padding may leave the domain
                                                : map.nearest_preimage(Volume_map_3::Point_3(x, y, z))->point);
  }
  return result;
}

// Returns the freedom of each vertex.
inline std::vector<Freedom_3> freedoms_3(const Hexahedron_soup_3& mesh, const Body_surface_3& surface)
{
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  std::vector<Freedom_3> result;
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    result.push_back(is_outer[v] ? surface.freedom(to_vector(mesh.points[v])) : Freedom_3::SPACE);
  return result;
}

// Moves all vertices at once: first those inside, then all, and in the end for the sake of the worst corners, until the mean
// gains little. Where corners are inverted or almost flat in between, or poor in the end, their vertices move one after the
// other. Rounds that do not halve the number of inverted corners are in vain; then vertices on lines may leave the lines. If
// vertices may leave the surface, they do so before all else. The worst corners are improved last, as long as they gain: while
// they are bad but positive, their vertices leave the lines, and tips count less. Where corners stay poor, vertices leave the
// interfaces.
inline void improve_hexahedra_3(Sliding_hexahedra_3& hexahedra, const bool may_leave_surface, const bool has_padding,
                                const Budget& budget, Best_hexahedra_3& best)
{
  constexpr int number_of_rounds = 10, number_of_first_rounds = 3, patience = 3; // guesses
  constexpr std::size_t first_steps = 10, steps = 3;                             // guesses
  constexpr std::size_t corners_per_inverted_corner = 100; // a guess; with fewer, not lines but the map is to blame
  constexpr double gain = 0.2;                             // a target far above the worst corners would not serve them most
  constexpr double price = 0.03, smallest_price = 0.0003;  // guesses; of uncovered points, see smooth_hexahedra_3()
  constexpr double least_gain_of_worst = 0.005;            // a guess; in a round
  constexpr double least_scaled_jacobian_at_interfaces = 0.02; // a guess
  constexpr double least_gain = 0.002;                     // a guess; gain of the mean in a round
  const auto evaluate = [&]
  {
    const Hexahedral_mesh_result result = evaluated_hexahedra(hexahedra.mesh(), has_padding);
    best.take(result, hexahedra.mesh());
    return result;
  };
  const auto smooth = [&](const Hexahedral_mesh_result& result, const double price)
  {
    hexahedra.smooth((std::max)(0., result.minimal_scaled_jacobian) + gain, price);
    return evaluate();
  };
  Hexahedral_mesh_result result = evaluate();
  if(may_leave_surface)
  {
    hexahedra.leave_and_return();
    result = evaluate();
  }
  std::size_t fewest_inverted_corners = result.number_of_inverted_corners;
  for(int round = 0, in_vain = 0; round < number_of_rounds && in_vain < patience
      && budget.may_begin_round(Phase::HEXAHEDRA, "corners"); ++round)
  {
    const bool are_few = result.number_of_inverted_corners * corners_per_inverted_corner <= 8 * result.number_of_cells;
    if(in_vain == patience - 1 && are_few && hexahedra.leave_lines(0))
      in_vain = 0;
    if(round > 0 && result.minimal_scaled_jacobian < flat_scaled_jacobian)
      result = smooth(result, price);
    const double mean = result.mean_scaled_jacobian;
    hexahedra.improve(round == 0 ? first_steps : steps, round > 0, round < number_of_first_rounds ? 1 : 2);
    result = evaluate();
    in_vain = result.number_of_inverted_corners <= fewest_inverted_corners / 2 ? 0 : in_vain + 1;
    fewest_inverted_corners = (std::min)(fewest_inverted_corners, result.number_of_inverted_corners);
    if(round >= number_of_first_rounds && result.number_of_inverted_corners == 0
       && result.mean_scaled_jacobian < mean + least_gain)
      break;
  }
  double price_of_worst = price;
  for(int round = 0, in_vain = 0;
      round < number_of_rounds && in_vain < patience && result.minimal_scaled_jacobian < sufficient_scaled_jacobian
      && budget.may_begin_round(Phase::HEXAHEDRA, "worst corners"); ++round)
  {
    const double least = result.minimal_scaled_jacobian;
    result = smooth(result, price_of_worst);
    in_vain = result.minimal_scaled_jacobian > least + least_gain_of_worst ? 0 : in_vain + 1;
    if(in_vain > 0 && result.number_of_inverted_corners == 0 && result.minimal_scaled_jacobian < bad_scaled_jacobian)
    {
      hexahedra.leave_lines(bad_scaled_jacobian);
      price_of_worst = (std::max)(smallest_price, price_of_worst / 10);
    }
  }
  for(int round = 0; round < patience && result.minimal_scaled_jacobian < least_scaled_jacobian_at_interfaces
      && budget.may_begin_round(Phase::HEXAHEDRA, "interfaces") && hexahedra.leave_interfaces(flat_scaled_jacobian); ++round)
  {
    hexahedra.improve(steps, true, 2);
    result = smooth(evaluate(), price);
  }
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_IMPROVE_HEXAHEDRA_3_H
