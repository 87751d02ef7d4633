// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_MAP_TO_BOUNDARIES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_MAP_TO_BOUNDARIES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_parameterizer_base_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3.h>

#include <CGAL/assertions.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Attempt to map a body to images of its boundary that a boundary parameterizer has found.
struct Boundary_attempt_3
{
  bool is_refined;      // is it the boundary with edges split, or the one that was given?
  bool is_held;         // is the boundary held? By default, it may be let go, which takes far longer.
  bool do_split_inside; // does each boundary vertex get vertices of its own inside?
  double part_of_time;  // of the time that is left, unless it is the last attempt
};

// Boundary attempts in their order; the first one whose map meets the boundary ends them. If no boundary is refined, only the
// last attempt is made. A refined boundary has far more vertices than there are inside, and each of these may be joined to too
// many. The parts of time are guesses.
constexpr std::array<Boundary_attempt_3, 3> boundary_attempts = {{
  { true, true, false, 1. / 3 },
  { true, false, true, 0.75 },
  { false, false, false, 1 }
}};

// Body with its map to images of its boundary.
struct Mapped_body_3
{
  Body_3 body;
  const Mapped_boundary_3* boundary;
  Body_map_3 map;

  bool has_valid_map() const { return map.result.has_valid_map; }
  bool meets_boundary() const { return has_valid_map() && map.result.boundary_residual == 0; }
};

// Makes the attempts for which there is a boundary, with `map(attempt, boundary, is_last)`. Returns the first map that meets its
// boundary; or else the first one without inverted cells, or the last attempt.
template <typename Progress, typename Map>
auto best_boundary_attempt_3(const std::vector<Mapped_boundary_3>& boundaries, Progress& progress, const Map& map)
{
  std::vector<std::pair<Boundary_attempt_3, const Mapped_boundary_3*> > attempts;
  for(const Boundary_attempt_3& attempt : boundary_attempts)
    for(const Mapped_boundary_3& boundary : boundaries)
      if(attempt.is_refined == !boundary.splits.empty())
        attempts.emplace_back(attempt, &boundary);
  std::optional<decltype(map(attempts[0].first, boundaries[0], true))> best;
  for(std::size_t i = 0; i < attempts.size() && !(best && (best->meets_boundary() || progress.is_interrupted())); ++i)
  {
    const auto& [attempt, boundary] = attempts[i];
    const bool is_last = i + 1 == attempts.size();
    progress.limit_to_part_of_time(is_last ? 1 : attempt.part_of_time);
    auto mapped = map(attempt, *boundary, is_last);
    if(!best || mapped.meets_boundary() || !best->has_valid_map())
      best = std::move(mapped);
    progress.limit_to_part_of_time(1);
  }
  CGAL_assertion(best.has_value());
  return std::move(*best);
}

// Maps a body to one of the images of its boundary, of which there is at least one.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Mapped_body_3 map_to_boundaries_3(Body_3 body, const Prescription_3& prescription,
                                  const std::vector<Mapped_boundary_3>& boundaries, const Map_problem_3& problem);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Boundary/map_to_boundaries_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_MAP_TO_BOUNDARIES_3_H
