// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_BEST_HEXAHEDRA_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_BEST_HEXAHEDRA_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Hexahedral_mesh_result.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/scaled_jacobians.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Hexahedra_problem_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <numeric>

namespace CGAL::Polycube_meshing_3::internal {

// Bounds of the least scaled Jacobian, all guesses: the first one ends the search, below the second one other layers are
// tried, corners below the third one are almost flat, which steps avoid, and no gain makes up for one below the last.
constexpr double sufficient_scaled_jacobian = 0.5, poor_scaled_jacobian = 0.2, flat_scaled_jacobian = 0.1,
                 bad_scaled_jacobian = 0.05;

// Distances, in edges: one of boundaries that needs no improvement, and the largest one of boundaries and interfaces that is no
// error. Both are guesses.
constexpr double sufficient_distance = 0.4, largest_distance = 0.5;

// Returns the result for a mesh: numbers, validity and scaled Jacobians, but no distances. Its message names an inverted place.
inline Hexahedral_mesh_result evaluated_hexahedra(const Hexahedra_3& mesh, const bool has_padding)
{
  Hexahedral_mesh_result result;
  result.number_of_vertices = mesh.points.size();
  result.number_of_cells = mesh.cells.size();
  result.has_padding = has_padding;
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  result.number_of_boundary_vertices = std::count(is_outer.begin(), is_outer.end(), true);

  std::string first_position;
  const auto name_first_position = [&](const std::size_t v)
  {
    if(first_position.empty())
      first_position = sentence(" The first one has a vertex at ", describe(mesh.points[v]),
                                is_outer[v] ? ", on the boundary." : ", inside.");
  };
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
  {
    if(is_positive_hexahedron(mesh.points, mesh.cells[c]))
      continue;
    ++result.number_of_inverted_hexahedra;
    for_each_corner(mesh.cells[c], [&](const std::array<std::size_t, 4>& corner)
    {
      if(is_positive_corner(mesh.points, corner))
        return;
      ++result.number_of_inverted_corners;
      name_first_position(corner[0]);
    });
    name_first_position(mesh.cells[c][0]); // if all corners are positive
  }
  const std::vector<double> quality = scaled_jacobians(mesh);
  result.minimum_scaled_jacobian = *std::min_element(quality.begin(), quality.end());
  result.mean_scaled_jacobian
    = std::accumulate(quality.begin(), quality.end(), 0.) / static_cast<double>(quality.size());
  result.has_valid_mesh = result.number_of_inverted_hexahedra == 0;
  result.status = result.has_valid_mesh ? OK : ERROR_INVERTED_HEXAHEDRON;
  result.message = get_error_message(result.status) + first_position;
  return result;
}

// Returns the numbers of inverted corners and of inverted hexahedra, which are compared in this order.
inline std::pair<std::size_t, std::size_t> inverted(const Hexahedral_mesh_result& result)
{ return { result.number_of_inverted_corners, result.number_of_inverted_hexahedra }; }

// Returns whether mesh a is better than b, by the first of these that differ: fewer inverted corners, fewer inverted hexahedra, a
// larger least scaled Jacobian if this is not usable, boundaries that are not too far from each other, or at most an edge, a
// larger least scaled Jacobian if this is bad, and the sum of the least scaled Jacobian, up to the sufficient one, and the mean,
// less a price of the distance between boundaries. Takes the length of edges without distortion.
inline bool is_better(const Hexahedral_mesh_result& a, const Hexahedral_mesh_result& b, const double edge)
{
  constexpr double price = 0.3; // a guess; of boundaries that are farther by an edge
  const auto badness = [edge](const Hexahedral_mesh_result& result)
  {
    const double least = result.minimum_scaled_jacobian, distance = result.boundary_distance;
    const double quality = (std::min)(least, sufficient_scaled_jacobian) + result.mean_scaled_jacobian
                           - price * std::clamp(distance / edge - sufficient_distance, 0., 1.);
    return std::make_tuple(inverted(result), -(std::min)(least, usable_scaled_jacobian), !(distance <= largest_distance * edge),
                           !(distance <= edge), -(std::min)(least, bad_scaled_jacobian), -quality);
  };
  return badness(a) < badness(b);
}

// Returns whether a mesh is valid, and no scaled Jacobian is below a bound.
inline bool is_at_least(const Hexahedral_mesh_result& result, const double bound)
{ return result.has_valid_mesh && result.minimum_scaled_jacobian >= bound; }

// Whether interfaces are staircases: no, as asked, or since hexahedra that follow the interfaces are worse.
enum class Staircases { NONE, ASKED, BETTER };

// Best hexahedra so far.
struct Best_hexahedra_3
{
  double edge = 1; // of hexahedra without distortion
  Hexahedral_mesh_result result;
  Hexahedra_3 mesh;
  Staircases staircases = Staircases::NONE;
  bool has_features = false; // have hexahedra been fitted to features of the body?

  // Replaces the mesh and its result by the next ones if there is no mesh yet, or the next one is better.
  void take_if_better(const Hexahedral_mesh_result& of_next, const Hexahedra_3& next)
  {
    if(mesh.cells.empty() || is_better(of_next, result, edge))
    {
      result = of_next;
      mesh = next;
    }
  }
};

// Distances of interfaces, relative to the edges of hexahedra: the largest one without a message, a guess, and that of rounding.
constexpr double tolerance_of_interfaces = 0.1, rounding_of_interfaces = 1e-6;

// Returns whether a plain grid, pulled back, is worth a try in place of hexahedra that were fitted to interfaces: they are bad, or
// the interfaces are far from them, or at least as far as from the grid.
inline bool may_be_worse_than_staircases(const Best_hexahedra_3& fitted, const double distance_of_grid)
{
  const double distance = fitted.result.interface_distance;
  if(!is_at_least(fitted.result, bad_scaled_jacobian))
    return true;
  if(is_at_least(fitted.result, sufficient_scaled_jacobian) && distance <= rounding_of_interfaces * fitted.edge)
    return false;
  return distance > tolerance_of_interfaces * fitted.edge || distance_of_grid <= distance;
}

// Returns the largest relative error of the volume of a subdomain.
inline double volume_error(const Hexahedral_mesh_result& result)
{
  double largest = 0;
  for(const Subdomain_volumes& volumes : result.volumes)
    largest = (std::max)(largest, std::abs(volumes.of_hexahedra / volumes.of_tetrahedra - 1));
  return largest;
}

// Returns whether staircases replace hexahedra that were fitted to interfaces. They do if neither the worst hexahedra nor the
// interfaces get worse, or if the fitted ones are bad and staircases are better. Volumes of subdomains may not be worse, beyond a
// tolerance, than those of valid fitted ones.
inline bool is_better_as_staircases(const Hexahedral_mesh_result& staircases, const Best_hexahedra_3& fitted)
{
  constexpr double tolerance_of_volumes = 0.05; // a guess; relative to the volume of a subdomain
  if(fitted.mesh.cells.empty())
    return true;
  if(fitted.result.has_valid_mesh && volume_error(staircases) > volume_error(fitted.result) + tolerance_of_volumes)
    return false;
  if(!is_at_least(fitted.result, bad_scaled_jacobian))
    return is_better(staircases, fitted.result, fitted.edge);
  return is_at_least(staircases, fitted.result.minimum_scaled_jacobian)
    && staircases.interface_distance <= fitted.result.interface_distance + rounding_of_interfaces * fitted.edge;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_IMPROVEMENT_BEST_HEXAHEDRA_3_H
