// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FOUND_HEXAHEDRA_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FOUND_HEXAHEDRA_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Body_with_domain_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Features/hexahedra_with_features_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Hexahedra_problem_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Best_hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Covered_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/volumes_of_subdomains_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/measure_distortion_3.h>

#include <map>

namespace CGAL::Polycube_meshing_3::internal {

// Adds the quadrangles of interfaces to the soup, and the references of quadrangles there and on the boundary: those of the facets
// of the body nearest to their centers.
inline void add_interfaces_and_references(const Body_with_domain_3& body, Body_interfaces_3& interfaces, const Hexahedra_3& mesh,
                                          Hexahedron_soup_3& soup)
{
  std::map<std::array<std::size_t, 3>, int> references;
  for(std::size_t f = 0; f < body.soup.facets.size(); ++f)
    references.emplace(sorted(body.soup.facets[f]), body.soup.facet_references[f]);
  const auto reference = [&](const std::array<std::size_t, 4>& q, const Body_surface_3& surface)
  {
    const auto found = references.find(sorted(surface.nearest_facet(center_of(mesh.points, q))));
    return found == references.end() ? 0 : found->second;
  };
  for(const std::array<std::size_t, 4>& q : mesh.facets)
    soup.facet_references.push_back(reference(q, body.surface));
  for(const Interface_quadrangle_3& q : interface_quadrangles_3(mesh))
  {
    soup.interface_facets.push_back(q.vertices);
    soup.interface_cells.push_back({ q.sides[0].cell, q.sides[1].cell });
    soup.interface_references.push_back(reference(q.vertices, interfaces.surface_of_pair(subdomains_of(mesh, q))));
  }
}

constexpr double largest_volume_deviation = 0.02; // of a subdomain, relative to its volume, that is no error; a guess

// Returns the message of a result whose status is OK without the text for OK.
inline std::string sentences_after_success(const Hexahedral_mesh_result& result)
{ return result.message.substr(std::string(get_error_message(OK)).size()); }

// Makes the result an error for hexahedra that deviate from the body. The sentences, which name the place, follow those on earlier
// deviations, or else precede the old message, of which the text for OK is removed.
inline void add_deviation(const std::string& sentences, Hexahedral_mesh_result& result)
{
  const std::string error = get_error_message(ERROR_INCOMPLETE_HEXAHEDRA);
  result.message = result.status == ERROR_INCOMPLETE_HEXAHEDRA ? result.message + sentences
                 : result.status == OK ? error + sentences + sentences_after_success(result)
                                       : error + sentences + " " + result.message;
  result.status = ERROR_INCOMPLETE_HEXAHEDRA;
}

// Sets the distance of interfaces in the result. Unless staircases were asked for, the message states a distance beyond the
// tolerance, and a distance beyond the largest one is an error. Takes the quadrangles of interfaces.
inline void check_interfaces(const Hexahedra_3& mesh, const std::vector<std::array<std::size_t, 4> >& quadrangles,
                             Body_interfaces_3& interfaces, const Staircases staircases, Hexahedral_mesh_result& result)
{
  const Largest_distance_3 farthest = interface_distance_3(mesh, interfaces);
  result.interface_distance = farthest.distance;
  double area = 0;
  for(const std::array<std::size_t, 4>& q : quadrangles)
    area += area_vector(mesh.points, q).norm();
  const double edge = std::sqrt(area / static_cast<double>(quadrangles.size())); // the mean one; not a number if there is none
  if(staircases == Staircases::ASKED || !(farthest.distance > tolerance_of_interfaces * edge))
    return;
  const std::string distance = sentence(" Interfaces between subdomains are kept up to a distance of ", farthest.distance / edge,
                                        " of the edges there. The distance is largest at ", describe(farthest.point), ".");
  if(farthest.distance > largest_distance * edge)
    add_deviation(distance, result);
  else
    result.message += distance;
  if(staircases == Staircases::BETTER)
    result.message += " Interfaces between subdomains are staircases, because hexahedra that follow them would be inverted or "
      "of lower quality.";
}

// Makes the result an error if a boundary is farther than half an edge from the other, or if a subdomain has no hexahedron, or, of
// several, another volume. Few hexahedra have long edges. Therefore, the distance is also compared with the size of the body.
inline void check_completeness(const Body_with_domain_3& body, const Largest_distance_3& farthest, const double edge,
                               const double spacing, const Staircases staircases, Hexahedral_mesh_result& result)
{
  constexpr double large_part = 0.1; // a guess; of the diagonal of the body
  Box_3 source, image;
  for(const std::array<std::size_t, 4>& cell : body.soup.cells)
    for(const std::size_t v : cell)
    {
      source.extend(body.points[v]);
      image.extend(body.images[v]);
    }
  std::string missing;
  if(farthest.distance > (std::min)(largest_distance * edge, large_part * source.diagonal().norm()))
    missing = sentence(" The boundaries of hexahedra and body are ", farthest.distance, " apart at ", describe(farthest.point),
                       ", where an edge of a hexahedron is about ", edge, " long. The spacing is ", spacing,
                       " in a domain with the sides ", describe(image.diagonal()), ".");
  for(const Subdomain_volumes& volumes : result.volumes)
  {
    const double deviation = std::abs(volumes.of_hexahedra / volumes.of_tetrahedra - 1);
    const bool may_deviate = staircases == Staircases::ASKED || result.volumes.size() == 1;
    if(volumes.of_hexahedra != 0 && (may_deviate || !(deviation > largest_volume_deviation)))
      continue;
    const std::vector<int>& references = body.soup.cell_references;
    const auto first = std::find(references.begin(), references.end(), volumes.reference) - references.begin();
    const std::string position = describe(body.points[body.soup.cells[first][0]]);
    missing += volumes.of_hexahedra == 0 ? sentence(" Subdomain ", volumes.reference, " at ", position, ", has no hexahedron.")
      : sentence(" Subdomain ", volumes.reference, " at ", position, ", has the volume ", volumes.of_tetrahedra,
                 ", and its hexahedra have ", volumes.of_hexahedra, ".");
  }
  if(!missing.empty())
    add_deviation(missing, result);
}

// Returns the number, area, center and normal of the quadrangles of the boundary with each reference, by ascending references.
inline std::vector<Hexahedral_mesh_patch> patches_of(const Hexahedra_3& mesh, const std::vector<int>& facet_references)
{
  struct Sums
  {
    Hexahedral_mesh_patch patch;
    Vector_3 center = Vector_3::Zero(), normal = Vector_3::Zero();
  };
  std::map<int, Sums> sums;
  for(std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    Sums& sum = sums[facet_references[f]];
    const auto& [a, b, c, d] = mesh.facets[f];
    for(const std::array<std::size_t, 3>& triangle : { std::array<std::size_t, 3>{ a, b, c }, { a, c, d } })
    {
      const Facet_edges_3 X = edges_of_facet(triangle, [&](const std::size_t v) { return mesh.points[v]; });
      sum.center += area_of_facet(X) * (mesh.points[triangle[0]] + (X[0] + X[1]) / 3);
      sum.normal += X[0].cross(X[1]) / 2;
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

// Returns the advice for a better least scaled Jacobian: a finer grid, or, if the map distorts angles much there, another map.
inline std::string advice_3(const Body_with_domain_3& body, const Hexahedra_3& mesh)
{
  constexpr double large_distortion = 10; // a guess
  const Vector_3 center = center_of(mesh.points, worst_hexahedron(mesh, scaled_jacobians(mesh)));
  const std::array<std::size_t, 4>& cell = body.soup.cells[body.map.nearest_image(exact_point(center))->cell];
  const Vector_3 s = signed_singular_values_3(edge_matrix(body.images, cell) * edge_matrix(body.points, cell).inverse());
  const double distortion = angle_distortion(s[0], s[2]);
  return distortion < large_distortion ? " Make the spacing smaller."
    : sentence(" The map distorts angles by a factor of ", distortion, " at the worst one. To lower the distortion, refine the "
               "source, allow refinement, or choose another domain.");
}

// Makes the result an error that names the hexahedron of the least scaled Jacobian if this is below a bound.
inline void check_quality(const Hexahedra_3& mesh, const double bound, Hexahedral_mesh_result& result)
{
  if(result.minimum_scaled_jacobian >= bound)
    return;
  const std::vector<double> quality = scaled_jacobians(mesh);
  const auto number = std::count_if(quality.begin(), quality.end(), [&](const double q) { return q < bound; });
  result.status = ERROR_POOR_HEXAHEDRON;
  result.message = sentence(get_error_message(ERROR_POOR_HEXAHEDRON), " ", number,
                            number == 1 ? " hexahedron is" : " hexahedra are", " below ", bound, "; the worst one, of ",
                            result.minimum_scaled_jacobian, ", has a vertex at ",
                            describe(mesh.points[worst_hexahedron(mesh, quality)[0]]), ".");
}

// Makes the soup of a valid mesh, with new images. Adds features, patches, volumes and distances to the result, which has scaled
// Jacobians already. Its status and message say which of these do not suffice.
inline void complete_valid(const Hexahedra_problem_3& problem, const Body_with_domain_3& body, Body_interfaces_3& interfaces,
                           Best_hexahedra_3 best, Found_hexahedra_3& found)
{
  Hexahedra_3& mesh = best.mesh;
  Hexahedral_mesh_result& result = found.result;
  update_images(body, mesh);
  found.mesh = hexahedron_soup_of(mesh);
  add_interfaces_and_references(body, interfaces, mesh, found.mesh);
  const Body_complex_3 complex(body.soup, body.points);
  result.features = kept_features_3(complex, body.surface, mesh, best.edge);
  add_features(complex, mesh, best.edge, found.mesh);
  const Largest_distance_3 farthest = boundary_distance_3(body.surface, mesh);
  result.boundary_distance = farthest.distance;
  result.patches = patches_of(mesh, found.mesh.facet_references);
  result.volumes = volumes_of_subdomains(body, mesh);
  check_quality(mesh, problem.minimum_scaled_jacobian, result);
  if(result.status != OK)
    result.message += advice_3(body, mesh);
  check_completeness(body, farthest, best.edge, problem.spacing, best.staircases, result);
  check_interfaces(mesh, found.mesh.interface_facets, interfaces, best.staircases, result);
  result.message += sentence_on_features(result.features, problem.spacing);
  result.corners_given_up = corners_given_up_3(body, mesh);
  if(!result.corners_given_up.empty())
    result.message += sentence(" Of ", body.surface.corners().size(), " marked corners, ", result.corners_given_up.size(),
                               " have no vertex, among them the one at ", describe(to_vector(result.corners_given_up[0])), ".");
}

// Returns the soup of the best hexahedra if they are valid, and their result with its final status and message.
inline Found_hexahedra_3 found_hexahedra_3(const Hexahedra_problem_3& problem, const Body_with_domain_3& body,
                                           Body_interfaces_3& interfaces, const Best_hexahedra_3& best, const Budget& budget)
{
  Found_hexahedra_3 found;
  Hexahedral_mesh_result& result = found.result;
  result = best.result.has_valid_mesh ? evaluated_hexahedra(best.mesh, best.result.has_padding) : best.result;
  result.is_interrupted = budget.is_exhausted();
  if(result.has_valid_mesh)
    complete_valid(problem, body, interfaces, best, found);
  else if(!result.is_interrupted)
    result.message += advice_3(body, best.mesh);
  if(!result.is_interrupted)
    return found;
  const bool is_only_fault = !result.has_valid_mesh || result.status == OK; // is the interruption?
  const std::string sentences = get_error_message(ERROR_INTERRUPTED)
    + std::string(result.has_valid_mesh ? " The hexahedra are valid, but more time may give better ones."
                                        : " There are no valid hexahedra yet. Allow more time.");
  result.message = !is_only_fault ? result.message + " " + sentences
                 : result.has_valid_mesh ? sentences + sentences_after_success(result)
                 : sentences;
  if(is_only_fault)
    result.status = ERROR_INTERRUPTED;
  return found;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FOUND_HEXAHEDRA_3_H
