// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_IMPL_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_IMPL_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Subdomain_separation_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Hexahedra_improvement_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/balance_interfaces_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/fitted_to_interfaces.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/interface_distance_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/move_to_corners_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/find_hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/measure_distortion_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Gives quadrangles the references of the facets of the body nearest to their centers: those of the boundary, and those of
// interfaces, which it collects.
inline void set_facet_references(const Tetrahedron_soup_3& soup, const Body_surface_3& boundary, Body_interfaces_3& interfaces,
                                 Hexahedron_soup_3& mesh)
{
  std::map<std::array<std::size_t, 3>, int> references;
  for(std::size_t f = 0; f < soup.facets.size(); ++f)
    references.emplace(sorted(soup.facets[f]), soup.facet_references[f]);
  const auto reference = [&](const std::array<std::size_t, 4>& q, const Body_surface_3& surface)
  {
    const auto point = [&](const std::size_t i) { return to_vector(mesh.points[q[i]]); };
    const auto found = references.find(sorted(surface.nearest_facet((point(0) + point(1) + point(2) + point(3)) / 4)));
    return found == references.end() ? 0 : found->second;
  };
  for(const std::array<std::size_t, 4>& q : mesh.facets)
    mesh.facet_references.push_back(reference(q, boundary));
  for(const Interface_quadrangle_3& q : interface_quadrangles_3(mesh))
  {
    mesh.interface_facets.push_back(q.vertices);
    mesh.interface_cells.push_back({ q.sides[0].cell, q.sides[1].cell });
    mesh.interface_references.push_back(reference(q.vertices, interfaces.surface_of_pair(pair_of(mesh, q))));
  }
}

// Whether interfaces are staircases: no, as asked, or since hexahedra that follow the interfaces are worse.
enum class Staircases { NONE, ASKED, BETTER };

// Distances of interfaces, relative to the edges of hexahedra: the largest one that is not told, a guess, and of rounding.
constexpr double tolerance_of_interfaces = 0.1, rounding_of_interfaces = 1e-6;

// Tells how well interfaces are kept, in numbers, and in sentences if they are not.
inline void evaluate_interfaces(const Hexahedron_soup_3& mesh, Body_interfaces_3& interfaces,
                                const Staircases staircases, Hexahedral_mesh_result& result)
{
  const Largest_distance_3 farthest = interface_distance_3(mesh, interfaces);
  result.interface_distance = farthest.distance;
  double area = 0;
  for(const std::array<std::size_t, 4>& q : mesh.interface_facets)
    area += area_vector(mesh.points, q).norm();
  const double edge = std::sqrt(area / static_cast<double>(mesh.interface_facets.size()));
  if(staircases == Staircases::ASKED || !(farthest.distance > tolerance_of_interfaces * edge))
    return;
  if(staircases == Staircases::BETTER)
    result.message += " Interfaces between subdomains are staircases, because hexahedra that follow them would be inverted or "
      "of lower quality.";
  result.message += sentence(" Interfaces between subdomains are kept up to a distance of ", farthest.distance / edge,
                             " of the edges there. The distance is largest at ", describe(farthest.point), ".");
}

// Names the place if a part of the body is left out: a subdomain, or what is farther from the hexahedra than their edges are long.
inline void check_completeness(const Tetrahedron_soup_3& soup, const Largest_distance_3& farthest, const double edge,
                               Hexahedral_mesh_result& result)
{
  std::string missing;
  if(farthest.distance > edge)
    missing = sentence(" The boundaries of hexahedra and body are ", farthest.distance, " apart at ", describe(farthest.point),
                       ", where an edge of a hexahedron is about ", edge, " long.");
  for(const Subdomain_volumes& volumes : result.volumes)
    if(volumes.of_hexahedra == 0)
    {
      const auto first = std::find(soup.cell_references.begin(), soup.cell_references.end(), volumes.reference);
      const std::size_t v = soup.cells[first - soup.cell_references.begin()][0];
      missing += sentence(" Subdomain ", volumes.reference, " at ", describe(to_vector(soup.points[v])),
                          ", has no hexahedron.");
    }
  if(missing.empty())
    return;
  result.message = get_error_message(ERROR_INCOMPLETE_HEXAHEDRA) + missing
                   + (result.status == OK ? "" : " " + result.message);
  result.status = ERROR_INCOMPLETE_HEXAHEDRA;
}

// Returns the area, center and normal of the quadrangles with each reference.
inline std::vector<Hexahedral_mesh_patch> patches_of(const Hexahedron_soup_3& mesh)
{
  struct Sums
  {
    Hexahedral_mesh_patch patch;
    Eigen::Vector3d center = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
  };
  std::map<int, Sums> sums;
  for(std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    Sums& sum = sums[mesh.facet_references[f]];
    const auto& [a, b, c, d] = mesh.facets[f];
    for(const std::array<std::size_t, 3>& triangle : { std::array<std::size_t, 3>{ a, b, c }, { a, c, d } })
    {
      const Small_matrix<3, 2> X = edges_of_facet(triangle, [&](const std::size_t v) { return to_vector(mesh.points[v]); });
      sum.center += area_of_facet(X) * (to_vector(mesh.points[triangle[0]]) + X.rowwise().sum() / 3);
      sum.normal += X.col(0).cross(X.col(1)) / 2;
      sum.patch.area += area_of_facet(X);
    }
    ++sum.patch.number_of_quadrangles;
  }
  std::vector<Hexahedral_mesh_patch> result;
  for(auto& [reference, sum] : sums)
  {
    sum.patch.reference = reference;
    sum.patch.center = coordinates(sum.center / sum.patch.area);
    sum.patch.normal = coordinates(sum.normal.stableNormalized());
    result.push_back(sum.patch);
  }
  return result;
}

// Advises what makes the hexahedron with the least scaled Jacobian better: a finer grid, or, where the map distorts angles much,
// another map.
inline std::string advice_3(const Mapped_soup_3& soup, const Volume_map_3& map, const Hexahedron_soup_3& mesh)
{
  constexpr double large_distortion = 10; // a guess
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for(const std::size_t v : worst_hexahedron(mesh, scaled_jacobians(mesh)))
    center += to_vector(mesh.points[v]) / 8;
  const std::array<std::size_t, 4>& cell = soup.cells[map.nearest_image({ center[0], center[1], center[2] })->cell];
  const Eigen::Vector3d s = signed_singular_values_3(edge_matrix(soup.images, cell) * edge_matrix(soup.points, cell).inverse());
  const double distortion = angle_distortion(s[0], s[2]);
  return distortion < large_distortion ? " Make the spacing smaller."
    : sentence(" The map distorts angles by a factor of ", distortion, " at the worst one. To lower the distortion, refine the "
               "source, allow refinement, or choose another domain.");
}

// Names the hexahedron of the least scaled Jacobian if this is below a bound.
inline void check_quality(const Hexahedron_soup_3& mesh, const double bound, Hexahedral_mesh_result& result)
{
  if(result.minimum_scaled_jacobian >= bound)
    return;
  const std::vector<double> quality = scaled_jacobians(mesh);
  const Eigen::Vector3d position = to_vector(mesh.points[worst_hexahedron(mesh, quality)[0]]);
  const auto number = std::count_if(quality.begin(), quality.end(), [&](const double q) { return q < bound; });
  result.status = ERROR_POOR_HEXAHEDRON;
  result.message = sentence(get_error_message(ERROR_POOR_HEXAHEDRON), " ", number,
                            number == 1 ? " hexahedron is" : " hexahedra are", " below ", bound, "; the worst one, of ",
                            result.minimum_scaled_jacobian, ", has a vertex at ", describe(position), ".");
}

// Finds the best hexahedra of boxes in the domain, with the layers that they need or with one along the whole boundary; they
// keep interfaces if there are any.
inline Best_hexahedra_3 best_hexahedra_3(const Mapped_soup_3& soup, const Volume_map_3& map, const Hexahedron_soup_3& boxes,
                                         const double spacing, const Body_surface_3& surface, Body_interfaces_3* const interfaces,
                                         Linear_solver_3& solver, const bool is_parallel, const Budget& budget)
{
  double volume = 0;
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    volume += volume_of_tetrahedron(soup, c);
  Best_hexahedra_3 best = { std::cbrt(volume / static_cast<double>(boxes.cells.size())),
                            refused_result(failed_check(ERROR_INTERRUPTED, get_error_message(ERROR_INTERRUPTED))), {} };
  const std::vector<Layer_3> chosen = Layer_choice_3(pulled_back(map, boxes, is_parallel, budget)).layers();
  const std::vector<Layer_3> one = { layer_along_boundary(boxes) }, other = chosen == one ? std::vector<Layer_3>() : one;
  for(const std::vector<Layer_3>& layers : { chosen, other })
  {
    if(budget.is_exhausted() || is_at_least(best.result, poor_scaled_jacobian))
      break;
    Hexahedron_soup_3 candidate = boxes;
    for(const Layer_3& layer : layers)
      candidate = Padding_3(candidate, quadrangles_along(candidate, layer), std::vector<int>(candidate.cells.size(), 0)).result();
    Interface_positions_3 positions;
    candidate = interfaces != nullptr
      ? fitted_to_interfaces(map, candidate, surface, *interfaces, is_parallel, budget, positions)
      : pulled_back(map, candidate, is_parallel, budget);
    put_on_boundary(surface, candidate);
    move_to_corners_3(soup, surface, spacing, positions, candidate);
    for(const bool may_leave_surface : { false, true })
    {
      if(budget.is_exhausted() || (may_leave_surface && is_at_least(best.result, bad_scaled_jacobian)))
        break;
      Sliding_hexahedra_3 hexahedra(candidate, freedoms_3(candidate, surface), surface, solver, is_parallel, budget, positions);
      Hexahedra_improvement_3(hexahedra, !layers.empty(), budget, best).run(may_leave_surface);
    }
  }
  return best;
}

// Tells whether hexahedra that were fitted to interfaces leave something to gain by a plain grid, pulled back: they are bad, or
// interfaces are far from them, or no nearer than the grid is.
inline bool may_be_worse_than_staircases(const Best_hexahedra_3& fitted, const Hexahedron_soup_3& grid,
                                         Body_interfaces_3& interfaces)
{
  if(!is_at_least(fitted.result, bad_scaled_jacobian))
    return true;
  const double distance = interface_distance_3(fitted.mesh, interfaces).distance;
  if(is_at_least(fitted.result, sufficient_scaled_jacobian) && distance <= rounding_of_interfaces * fitted.edge)
    return false;
  return distance > tolerance_of_interfaces * fitted.edge || interface_distance_3(grid, interfaces).distance <= distance;
}

// Tells whether staircases are to be taken: if neither the worst hexahedra nor interfaces get worse, or if hexahedra that were
// fitted to interfaces are bad, and staircases are better.
inline bool is_better_as_staircases(const Best_hexahedra_3& staircases, const Best_hexahedra_3& fitted,
                                    Body_interfaces_3& interfaces)
{
  if(!is_at_least(fitted.result, bad_scaled_jacobian))
    return fitted.mesh.cells.empty() || is_better(staircases.result, fitted.result, fitted.edge);
  return is_at_least(staircases.result, fitted.result.minimum_scaled_jacobian)
    && interface_distance_3(staircases.mesh, interfaces).distance
       <= interface_distance_3(fitted.mesh, interfaces).distance + rounding_of_interfaces * fitted.edge;
}

CGAL_POLYCUBE_MESHING_3_INLINE
Hexahedral_mesh_result find_hexahedra_3(const Mapped_soup_3& soup, const double spacing, Linear_solver_3& solver,
                                        const bool is_parallel, const Budget& budget, const double minimum_scaled_jacobian,
                                        const bool do_keep_interfaces, Hexahedron_soup_3& mesh)
{
  const Input_check_3 check = check_map_3(soup);
  if(check.status != OK)
    return refused_result(check);
  const Body_surface_3 surface(soup);
  const Box_grid_3 grid(soup.cells, soup.images, surface.lines(), spacing);
  if(grid.check().status != OK)
    return refused_result(grid.check());

  const Volume_map_3 map(soup.points, soup.cells, soup.images);
  Locations_3 locations;
  Hexahedron_soup_3 boxes = grid.boxes([&](const std::vector<std::array<double, 3> >& centers)
  {
    return locations = preimages_3(map, centers, is_parallel, budget);
  });
  for(const std::optional<Volume_map_3::Location>& location : locations)
    if(location)
      boxes.cell_references.push_back(soup.cell_references[location->cell]);
  if(boxes.cells.empty() && !budget.is_exhausted())
    return refused_result(failed_check(ERROR_INVERTED_TARGET_BOUNDARY, get_error_message(ERROR_INVERTED_TARGET_BOUNDARY)));

  Body_interfaces_3 interfaces(soup, surface);
  Best_hexahedra_3 best;
  bool is_cut = false; // were hexahedra that follow the interfaces ended by their limit of time?
  Staircases staircases = Staircases::NONE;
  const auto without_interfaces = [&]
  { return best_hexahedra_3(soup, map, boxes, spacing, surface, nullptr, solver, is_parallel, budget); };
  if(do_keep_interfaces && !interfaces.empty() && !budget.is_exhausted())
  {
    Hexahedron_soup_3 separated = boxes;
    Subdomain_separation_3(separated).run(budget);
    const Budget part = budget.part(0.5); // a guess; staircases, which are far faster, must have time
    best = best_hexahedra_3(soup, map, separated, spacing, surface, &interfaces, solver, is_parallel, part);
    is_cut = part.is_exhausted();
    if(best.result.has_valid_mesh)
    {
      balance_interfaces_3(interfaces, best.mesh);
      best.result.minimum_scaled_jacobian = evaluated_hexahedra(best.mesh, best.result.has_padding).minimum_scaled_jacobian;
    }
    if(may_be_worse_than_staircases(best, pulled_back(map, boxes, is_parallel, budget), interfaces) && !budget.is_exhausted())
      if(Best_hexahedra_3 other = without_interfaces(); is_better_as_staircases(other, best, interfaces))
      {
        best = std::move(other);
        staircases = Staircases::BETTER;
      }
  }
  else
  {
    staircases = Staircases::ASKED;
    best = without_interfaces();
  }
  Hexahedral_mesh_result result
    = best.result.has_valid_mesh ? evaluated_hexahedra(best.mesh, best.result.has_padding) : best.result;
  result.is_interrupted = budget.is_exhausted() || is_cut;
  if(result.has_valid_mesh)
  {
    set_images(map, is_parallel, best.mesh);
    set_facet_references(soup, surface, interfaces, best.mesh);
    const Largest_distance_3 farthest = boundary_distance_3(surface, best.mesh);
    result.boundary_distance = farthest.distance;
    result.patches = patches_of(best.mesh);
    result.volumes = volumes_of_subdomains(soup, best.mesh);
    check_quality(best.mesh, minimum_scaled_jacobian, result);
    if(result.status != OK)
      result.message += advice_3(soup, map, best.mesh);
    check_completeness(soup, farthest, best.edge, result);
    evaluate_interfaces(best.mesh, interfaces, staircases, result);
    result.corners_given_up = corners_given_up_3(soup, surface, best.mesh);
    if(!result.corners_given_up.empty())
      result.message += sentence(" Of ", surface.corners().size(), " marked corners, ", result.corners_given_up.size(),
                                 " have no vertex, among them the one at ", describe(to_vector(result.corners_given_up[0])), ".");
    mesh = std::move(best.mesh);
  }
  else if(!result.is_interrupted)
    result.message += advice_3(soup, map, best.mesh);
  else
    result.status = ERROR_INTERRUPTED;
  if(result.is_interrupted)
    result.message = get_error_message(ERROR_INTERRUPTED)
      + std::string(result.has_valid_mesh ? " The hexahedra are valid, but better ones might have been found."
                                        : " There are no valid hexahedra yet.");
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_IMPL_H
