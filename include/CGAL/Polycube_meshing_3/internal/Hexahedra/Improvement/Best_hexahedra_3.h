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
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <numeric>

namespace CGAL::Polycube_meshing_3::internal {

// Bounds of the least scaled Jacobian, all guesses: the first one ends the search, below the second one other layers are
// tried, corners below the third one are almost flat, which steps avoid, and no gain makes up for one below the last.
constexpr double sufficient_scaled_jacobian = 0.5, poor_scaled_jacobian = 0.2, flat_scaled_jacobian = 0.1,
                 bad_scaled_jacobian = 0.05;
constexpr double sufficient_distance = 0.4; // of boundaries, in edges; a guess

// Returns the result for a mesh.
inline Hexahedral_mesh_result evaluated_hexahedra(const Hexahedra_3& mesh, const bool has_padding)
{
  Hexahedral_mesh_result result;
  result.number_of_vertices = mesh.points.size();
  result.number_of_cells = mesh.cells.size();
  result.has_padding = has_padding;
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  result.number_of_boundary_vertices = std::count(is_outer.begin(), is_outer.end(), true);

  std::string where;
  const auto name = [&](const std::size_t v)
  {
    if(where.empty())
      where = sentence(" The first one has a vertex at ", describe(mesh.points[v]),
                       is_outer[v] ? ", on the boundary." : ", inside.");
  };
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
  {
    if(is_positive_hexahedron(mesh, c))
      continue;
    ++result.number_of_inverted_hexahedra;
    for_each_corner(mesh.cells[c], [&](const std::array<std::size_t, 4>& corner)
    {
      if(is_positive_corner(mesh, corner))
        return;
      ++result.number_of_inverted_corners;
      name(corner[0]);
    });
    name(mesh.cells[c][0]); // if all corners are positive
  }
  const std::vector<double> quality = scaled_jacobians(mesh);
  result.minimum_scaled_jacobian = *std::min_element(quality.begin(), quality.end());
  result.mean_scaled_jacobian
    = std::accumulate(quality.begin(), quality.end(), 0.) / static_cast<double>(quality.size());
  result.has_valid_mesh = result.number_of_inverted_hexahedra == 0;
  result.status = result.has_valid_mesh ? OK : ERROR_INVERTED_HEXAHEDRON;
  result.message = get_error_message(result.status) + where;
  return result;
}

// Returns whether a mesh has fewer inverted corners or hexahedra than another one, or a larger least scaled Jacobian if this is
// bad, or leaves out nothing of the body longer than an edge, or has the larger sum of the least one, up to the sufficient one,
// and the mean: a gain in one of both must not cost as much of the other. Boundaries that are far apart, in edges, have a price.
inline bool is_better(const Hexahedral_mesh_result& a, const Hexahedral_mesh_result& b, const double edge)
{
  constexpr double price = 0.3; // a guess; of boundaries that are farther by an edge
  const auto quality = [edge](const Hexahedral_mesh_result& result)
  {
    return (std::min)(result.minimum_scaled_jacobian, sufficient_scaled_jacobian) + result.mean_scaled_jacobian
           - price * std::clamp(result.boundary_distance / edge - sufficient_distance, 0., 1.);
  };
  if(a.number_of_inverted_corners != b.number_of_inverted_corners)
    return a.number_of_inverted_corners < b.number_of_inverted_corners;
  if(a.number_of_inverted_hexahedra != b.number_of_inverted_hexahedra)
    return a.number_of_inverted_hexahedra < b.number_of_inverted_hexahedra;
  const double least_of_a = (std::min)(a.minimum_scaled_jacobian, bad_scaled_jacobian);
  const double least_of_b = (std::min)(b.minimum_scaled_jacobian, bad_scaled_jacobian);
  const bool is_a_complete = a.boundary_distance <= edge, is_b_complete = b.boundary_distance <= edge;
  return least_of_a != least_of_b ? least_of_a > least_of_b
    : is_a_complete != is_b_complete ? is_a_complete : quality(a) > quality(b);
}

// Returns whether a mesh is valid, and no scaled Jacobian is below a bound.
inline bool is_at_least(const Hexahedral_mesh_result& result, const double bound)
{ return result.has_valid_mesh && result.minimum_scaled_jacobian >= bound; }

// Best hexahedra so far.
struct Best_hexahedra_3
{
  double edge = 1; // of hexahedra without distortion
  Hexahedral_mesh_result result;
  Hexahedra_3 mesh;

  void take(const Hexahedral_mesh_result& of_next, const Hexahedra_3& next)
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

// Returns whether hexahedra that were fitted to interfaces leave something to gain by a plain grid, pulled back: they are bad, or
// interfaces are far from them, or no nearer than the grid is.
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

// Returns whether staircases replace hexahedra that were fitted to interfaces: if neither the worst hexahedra nor
// the interfaces get worse, or if the fitted ones are bad, and staircases are better. Volumes of valid fitted ones are kept.
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
