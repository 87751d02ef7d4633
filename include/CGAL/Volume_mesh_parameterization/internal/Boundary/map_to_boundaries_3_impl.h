// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_MAP_TO_BOUNDARIES_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_MAP_TO_BOUNDARIES_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/map_to_boundaries_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Refinement_3.h>

#include <iostream>

namespace CGAL::Volume_mesh_parameterization::internal {

// Makes one attempt. `prescription` is of the body without targets.
inline Mapped_body_3 map_to_boundary_3(const Boundary_attempt_3& attempt, Body_3 body, Prescription_3 prescription,
                                       const Mapped_boundary_3& boundary, Map_problem_3 problem)
{
  if(problem.options.verbose && !boundary.strategy.empty())
    std::cout << "boundary by " << boundary.strategy << ", with " << boundary.splits.size() << " splits" << std::endl;
  const std::size_t number_of_points = body.points.size();
  Mapped_body_3 mapped = { std::move(body), &boundary, {} };
  std::optional<std::vector<Insertion_3> > insertions = split_any_edges_3(mapped.body, boundary.splits);
  if(!insertions)
  {
    mapped.map.result.status = ERROR_BOUNDARY_TOO_COARSE;
    mapped.map.result.message = get_error_message(ERROR_BOUNDARY_TOO_COARSE);
    return mapped;
  }
  if(attempt.do_split_inside)
  {
    const std::vector<Insertion_3> made = split_edges_at_boundary_3(mapped.body);
    insertions->insert(insertions->end(), made.begin(), made.end());
  }
  if(attempt.is_held && problem.options.mode == Boundary_mode::AUTO)
    problem.options.mode = Boundary_mode::FIXED;
  prescription.targets = boundary.targets;
  prescription.extend_to(mapped.body.points.size());
  for(const std::array<std::size_t, 3>& facet : mapped.body.boundary)
    for(const std::size_t p : facet)
      if(p >= number_of_points)
        prescription.conditions[p] = prescription.boundary_condition;
  mapped.map = refine_and_parameterize_body_3(mapped.body, std::move(prescription), problem, std::move(*insertions));
  mapped.map.result.number_of_added_boundary_vertices = boundary.splits.size();
  return mapped;
}

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Mapped_body_3 map_to_boundaries_3(Body_3 body, const Prescription_3& prescription,
                                  const std::vector<Mapped_boundary_3>& boundaries, const Map_problem_3& problem)
{
  return best_boundary_attempt_3(boundaries, problem.progress,
    [&](const Boundary_attempt_3& attempt, const Mapped_boundary_3& boundary, const bool is_last)
  { return map_to_boundary_3(attempt, is_last ? std::move(body) : Body_3(body), prescription, boundary, problem); });
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_MAP_TO_BOUNDARIES_3_IMPL_H
