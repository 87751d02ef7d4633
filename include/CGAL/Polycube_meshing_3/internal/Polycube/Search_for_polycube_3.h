// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_SEARCH_FOR_POLYCUBE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_SEARCH_FOR_POLYCUBE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_map_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/repair_labels_3.h>

#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace CGAL::Polycube_meshing_3::internal {

// Search for the labels whose polycube has the least distortion. Labels are proposed with more and more smoothing. Where the
// boundary is too coarse, faces without room go over to neighboring charts. Slopes of bad polycubes get other labels.
class Search_for_polycube_3
{
public:
  Search_for_polycube_3(const Unit_surface_3& surface, const Budget& budget)
    : m_surface(surface), m_mesh(surface.mesh), m_budget(budget)
  {}

  // Returns the map to the best polycube; its status is an error if none is found.
  Surface_map_3 run()
  {
    const Normal_labels_3 costs(m_mesh, m_surface.is_sharp, m_budget);
    Surface_map_3 best = map_with_proposed_labels(costs);
    if(best.status == OK || m_surface.spacing > 0) // hexahedra are worth a search where no labels have a polycube
      try_second_directions(costs, best);
    return best;
  }

private:
  using Labels = Normal_labels_3::Labels;

  // Returns the finished map to a polycube of labels that are proposed for the costs and were not tried before. Of the maps that
  // can be finished, it is the one that has the least distortion before. Its status is an error if there is none.
  Surface_map_3 map_with_proposed_labels(Normal_labels_3 costs)
  {
    constexpr double first_smoothing = 0.001, bound_of_smoothing = 0.1; // guesses; weights of the lengths of borders
    constexpr int maximum_number_of_attempts = 10;                      // a guess; to make room for faces
    const double factor = std::sqrt(2.); // a guess; from one smoothing to the next one
    std::multimap<double, Polycube_map_3> maps; // by distortion
    for(double smoothing = first_smoothing; smoothing < bound_of_smoothing && !m_budget.is_exhausted(); smoothing *= factor)
    {
      Labels labels = costs.closest();
      costs.minimize(smoothing, labels);
      if(!m_proposed.insert(labels).second)
        continue;
      for(int attempt = 0;
          attempt < maximum_number_of_attempts && m_budget.may_begin_round(Phase::BOUNDARY, "labels of a polycube"); ++attempt)
      {
        if(!repair_labels_3(m_mesh, costs, smoothing, labels, m_budget) || !m_tried.insert(labels).second)
          break;
        Polycube_map_3 map(m_surface, labels);
        const Error_code status = map.start_close_to_surface(m_budget);
        const bool has_changed = give_away_faces(m_mesh, map.flipped_faces(), costs, labels);
        if(status == OK)
          maps.emplace(map.distortion(), std::move(map));
        if(!has_changed)
          break;
      }
    }
    for(auto& [distortion, map] : maps)
      if(Surface_map_3 result = finished_map_3(map, m_budget); result.status == OK)
        return result;
    return {};
  }

  // Replaces the best map, as long as it is bad, by better ones for which slopes prefer their second direction, the largest slopes
  // first. A slope with the direction of the faces at both of its ends joins these to one face.
  void try_second_directions(Normal_labels_3 costs, Surface_map_3& best)
  {
    constexpr double bad_distortion = 0.5;        // a guess; parts of CAD have less
    constexpr int maximum_number_of_failures = 4; // in sequence; a guess
    int failures = 0;
    for(const Normal_labels_3::Slope& slope : costs.slopes())
    {
      if(!(best.distortion > bad_distortion) || failures++ == maximum_number_of_failures)
        return;
      Normal_labels_3 turned = costs;
      turned.prefer_second_direction(slope);
      Surface_map_3 other = map_with_proposed_labels(turned);
      if(!(other.distortion < best.distortion))
        continue;
      best = std::move(other);
      costs.prefer_second_direction(slope);
      failures = 0;
    }
  }

  const Unit_surface_3& m_surface;
  const Boundary_mesh_3& m_mesh; // of the surface
  const Budget& m_budget;
  std::set<Labels> m_proposed, m_tried; // labels before and after repair
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_SEARCH_FOR_POLYCUBE_3_H
