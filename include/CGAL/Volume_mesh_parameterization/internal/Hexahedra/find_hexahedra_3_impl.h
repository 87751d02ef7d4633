// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/find_hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/improve_hexahedra_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Gives the quadrangles of the boundary the references of the facets of the body nearest to their centers.
inline void set_facet_references(const Tetrahedron_soup_3& soup, const Body_surface_3& surface, Hexahedron_soup_3& mesh)
{
  std::map<std::array<std::size_t, 3>, int> references;
  for(std::size_t f = 0; f < soup.facets.size(); ++f)
    references.emplace(sorted(soup.facets[f]), soup.facet_references[f]);
  for(const std::array<std::size_t, 4>& q : mesh.facets)
  {
    const auto point = [&](const std::size_t i) { return to_vector(mesh.points[q[i]]); };
    const auto found = references.find(sorted(surface.nearest_facet((point(0) + point(1) + point(2) + point(3)) / 4)));
    mesh.facet_references.push_back(found == references.end() ? 0 : found->second);
  }
}

// Names the hexahedron of the least scaled Jacobian if this is below a bound.
inline void check_quality(const Hexahedron_soup_3& mesh, const double bound, Hexahedral_mesh_result& result)
{
  if(result.minimal_scaled_jacobian >= bound)
    return;
  const std::vector<double> quality = scaled_jacobians(mesh);
  const std::array<std::size_t, 8>& worst
    = mesh.cells[static_cast<std::size_t>(std::min_element(quality.begin(), quality.end()) - quality.begin())];
  const auto number = std::count_if(quality.begin(), quality.end(), [&](const double q) { return q < bound; });
  result.status = ERROR_POOR_HEXAHEDRON;
  result.message = sentence(get_error_message(ERROR_POOR_HEXAHEDRON), " ", number, number == 1 ? " hexahedron is" : " hexahedra are",
                            " below ", bound, "; the worst one, of ", result.minimal_scaled_jacobian, ", has a vertex at ",
                            describe(to_vector(mesh.points[worst[0]])), ".");
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Hexahedral_mesh_result find_hexahedra_3(const Mapped_soup_3& soup, const double spacing, Linear_solver_3& solver,
                                        const bool is_parallel, const Budget& budget, const double minimal_scaled_jacobian,
                                        Hexahedron_soup_3& mesh)
{
  const Input_check_3 check = check_map_3(soup);
  if(check.status != OK)
    return refused_result(check);
  const Box_grid_3 grid(soup.cells, soup.images, spacing);
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
    return refused_result(failed_check(ERROR_INVERTED_TARGET_BOUNDARY,
                                       get_error_message(ERROR_INVERTED_TARGET_BOUNDARY)));

  const Body_surface_3 surface(soup.points, soup.cells, soup.images);
  Best_hexahedra_3 best
    = { refused_result(failed_check(ERROR_INTERRUPTED, get_error_message(ERROR_INTERRUPTED))), {} };
  const std::vector<Layer_3> chosen = Layer_choice_3(pulled_back(map, boxes, is_parallel, budget)).layers();
  const std::vector<Layer_3> one = { layer_along_boundary(boxes) }, other = chosen == one ? std::vector<Layer_3>() : one;
  for(const std::vector<Layer_3>& layers : { chosen, other })
  {
    if(budget.is_exhausted() || best.result.minimal_scaled_jacobian >= poor_scaled_jacobian)
      break;
    Hexahedron_soup_3 candidate = boxes;
    for(const Layer_3& layer : layers)
      candidate = padded(candidate, layer);
    candidate = pulled_back(map, candidate, is_parallel, budget);
    for(const bool may_leave_surface : { false, true })
    {
      if(budget.is_exhausted() || (may_leave_surface && best.result.has_valid_mesh))
        break;
      Sliding_hexahedra_3 hexahedra(candidate, freedoms_3(candidate, surface), surface, solver, is_parallel, budget);
      improve_hexahedra_3(hexahedra, may_leave_surface, !layers.empty(), budget, best);
    }
  }
  Hexahedral_mesh_result result = best.result;
  result.is_interrupted = budget.is_exhausted();
  if(result.has_valid_mesh)
  {
    set_images(map, is_parallel, best.mesh);
    set_facet_references(soup, surface, best.mesh);
    check_quality(best.mesh, minimal_scaled_jacobian, result);
    mesh = std::move(best.mesh);
  }
  else if(result.is_interrupted)
    result.status = ERROR_INTERRUPTED;
  if(result.is_interrupted)
    result.message = get_error_message(ERROR_INTERRUPTED)
      + std::string(result.has_valid_mesh ? " The hexahedra have positive corners, but better ones might have been found."
                                        : " There are no hexahedra with positive corners yet.");
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_IMPL_H
