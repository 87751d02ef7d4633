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

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Box_grid_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Subdomain_separation_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Features/hexahedra_with_features_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Hexahedra_improvement_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Interfaces/Interface_quadrangles_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Layers/layers_at_interfaces.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/find_hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/found_hexahedra_3.h>

#include <optional>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the result for input that does not allow a mesh.
inline Hexahedral_mesh_result refused_result(const Input_check_3& check)
{
  Hexahedral_mesh_result result;
  result.status = check.status;
  result.message = check.message;
  return result;
}

// Boxes in a domain and their preimages in the body.
struct Boxes_3
{
  Hexahedra_3 in_domain, in_body = {};
  std::vector<Covered_faces_3> layers = {}; // that they need
  double edge = 1;                          // mean length in the body if all hexahedra were cubes
};

// Returns the boxes of a grid, with the subdomains of their centers. Once the budget is exhausted, `in_body` has no hexahedra.
inline Boxes_3 boxes_of_grid_3(const Body_with_domain_3& body, const Box_grid_3& grid, const Budget& budget)
{
  Locations_3 locations;
  Boxes_3 result = { grid.boxes([&](const std::vector<Vector_3>& centers)
                                { return locations = preimages_3(body, centers, budget); }) };
  for(const std::optional<Volume_map_3::Location>& location : locations)
    if(location)
      result.in_domain.cell_references.push_back(body.soup.cell_references[location->cell]);
  result.in_body = pulled_back(body, result.in_domain, budget);
  if(result.in_body.cells.empty())
    return result;
  result.layers = Layer_choice_3(result.in_body).layers();
  double volume = 0;
  for(std::size_t c = 0; c < body.soup.cells.size(); ++c)
    volume += volume_of_tetrahedron(body, c);
  result.edge = std::cbrt(volume / static_cast<double>(result.in_domain.cells.size()));
  return result;
}

// Returns the best hexahedra of boxes in the domain, with the layers that they need or, if they stay poor, with one along the
// whole boundary. Returns none, with the status ERROR_INTERRUPTED, if the budget is exhausted before the first ones. The hexahedra
// follow the interfaces unless these are to be staircases. Valid hexahedra of a body without interfaces are fitted to its
// features. If that succeeds, nothing else is tried, as fitting moves all vertices again.
inline Best_hexahedra_3 best_hexahedra_3(const Hexahedra_problem_3& problem, const Body_with_domain_3& body,
                                         const Boxes_3& boxes, Body_interfaces_3& interfaces, const Staircases staircases,
                                         const Budget& budget)
{
  Best_hexahedra_3 best
    = { boxes.edge, refused_result(failed_check(ERROR_INTERRUPTED, get_error_message(ERROR_INTERRUPTED))), {}, staircases };
  bool may_fit = interfaces.empty();
  const std::vector<Covered_faces_3> one_layer = { all_faces_of_domain(boxes.in_domain) },
                                     other_layers = boxes.layers == one_layer ? std::vector<Covered_faces_3>() : one_layer;
  for(const std::vector<Covered_faces_3>& layers : { boxes.layers, other_layers })
  {
    if(budget.is_exhausted() || is_at_least(best.result, poor_scaled_jacobian))
      break;
    Hexahedra_3 padded = boxes.in_domain;
    for(const Covered_faces_3& faces : layers)
      padded = Padding_3(padded, quadrangles_in(padded, faces), std::vector<int>(padded.cells.size(), 0)).result();
    std::vector<Interface_quadrangle_3> quadrangles;
    if(staircases == Staircases::NONE)
      padded = with_layers_at_interfaces(body, padded, interfaces, budget, quadrangles);
    const Hexahedra_3 mesh = pulled_back(body, padded, budget);
    if(mesh.cells.empty())
      break; // the budget is exhausted
    Placed_hexahedra_3 start = placed_hexahedra_3(mesh, quadrangles, interfaces);
    move_to_corners_3(body, problem.spacing, start);
    for(const bool may_leave_surface : { false, true })
    {
      if(budget.is_exhausted() || (may_leave_surface && is_at_least(best.result, bad_scaled_jacobian)))
        break;
      Sliding_hexahedra_3 hexahedra(start, problem.solver, body.is_parallel, budget);
      Hexahedra_improvement_3 improvement(hexahedra, !layers.empty(), budget, best);
      if(!improvement.untangle(may_leave_surface))
        continue;
      if(may_fit && best.result.has_valid_mesh)
      {
        constexpr double part = 0.75; // a guess; if fitting fails, the first valid hexahedra need time to be improved
        may_fit = false;              // fitting takes as long as all else
        if(const auto with_features = hexahedra_with_features_3(problem, body, interfaces, best, budget.part(part)))
          return *with_features;
      }
      improvement.polish();
    }
  }
  return best;
}

// Returns the best hexahedra that follow the interfaces, or, if these are worse, hexahedra whose interfaces are staircases.
inline Best_hexahedra_3 hexahedra_at_interfaces_3(const Hexahedra_problem_3& problem, const Body_with_domain_3& body,
                                                  const Boxes_3& boxes, Body_interfaces_3& interfaces, const Budget& budget)
{
  const auto with_distance_and_volumes = [&](Best_hexahedra_3 hexahedra)
  {
    hexahedra.result.interface_distance = interface_distance_3(hexahedra.mesh, interfaces).distance;
    hexahedra.result.volumes = volumes_of_subdomains(body, hexahedra.mesh);
    return hexahedra;
  };
  const auto make_staircases = [&](const Budget& part_of_budget)
  { return with_distance_and_volumes(best_hexahedra_3(problem, body, boxes, interfaces, Staircases::BETTER, part_of_budget)); };
  std::optional<Best_hexahedra_3> staircases;
  if(budget.is_limited()) // staircases are far faster than what follows, which may have all of the time that is left then
    staircases = make_staircases(budget.part(0.5));
  Boxes_3 separated = boxes;
  Subdomain_separation_3(separated.in_domain).run(budget);
  Best_hexahedra_3 best = best_hexahedra_3(problem, body, separated, interfaces, Staircases::NONE, budget);
  if(best.result.has_valid_mesh)
  {
    keep_volumes_3(body, interfaces, best.mesh);
    const std::vector<double> quality = scaled_jacobians(best.mesh);
    best.result.minimum_scaled_jacobian = *std::min_element(quality.begin(), quality.end());
  }
  best = with_distance_and_volumes(std::move(best));
  if((!staircases && budget.is_exhausted())
     || !may_be_worse_than_staircases(best, interface_distance_3(boxes.in_body, interfaces).distance))
    return best;
  if(!staircases)
    staircases = make_staircases(budget);
  return is_better_as_staircases(staircases->result, best) ? std::move(*staircases) : std::move(best);
}

CGAL_POLYCUBE_MESHING_3_INLINE
Found_hexahedra_3 find_hexahedra_3(const Hexahedra_problem_3& problem, const Budget& budget)
{
  if(const Input_check_3 check = check_map_3(problem.soup); check.status != OK)
    return { refused_result(check), {} };
  const Body_with_domain_3 body(problem.soup, problem.is_parallel);
  const Box_grid_3 grid(body.soup.cells, body.images, body.surface.edges_of_lines(), problem.spacing);
  if(grid.check().status != OK)
    return { refused_result(grid.check()), {} };
  const Boxes_3 boxes = boxes_of_grid_3(body, grid, budget);
  if(boxes.in_domain.cells.empty() && !budget.is_exhausted())
    return { refused_result(failed_check(ERROR_INVERTED_TARGET_BOUNDARY, get_error_message(ERROR_INVERTED_TARGET_BOUNDARY))), {} };
  Body_interfaces_3 interfaces(body.soup, body.surface);
  Best_hexahedra_3 best = problem.do_keep_interfaces && !interfaces.empty() && !budget.is_exhausted()
    ? hexahedra_at_interfaces_3(problem, body, boxes, interfaces, budget)
    : best_hexahedra_3(problem, body, boxes, interfaces, Staircases::ASKED, budget);
  const bool may_fit = interfaces.empty() || best.staircases != Staircases::ASKED;
  if(best.result.has_valid_mesh && !best.has_features && may_fit) // features may have room that the first valid hexahedra lacked
    if(auto with_features = hexahedra_with_features_3(problem, body, interfaces, best, budget))
    {
      best = std::move(*with_features);
      if(best.staircases == Staircases::NONE)
        keep_volumes_3(body, interfaces, best.mesh);
    }
  put_on_planes(body.surface, best.mesh);
  return found_hexahedra_3(problem, body, interfaces, best, budget);
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_FIND_HEXAHEDRA_3_IMPL_H
