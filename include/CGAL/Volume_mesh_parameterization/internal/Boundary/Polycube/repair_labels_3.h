// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_REPAIR_LABELS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_REPAIR_LABELS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Normal_labels_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Polycube_charts_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/straighten_chains_3.h>

#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The invalid chart of smallest area.
inline std::size_t smallest_invalid_chart(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts,
                                          const Normal_labels_3& costs)
{
  std::vector<double> area(charts.charts().size(), 0.);
  for(const auto f : mesh.faces())
    area[charts.chart_of_face()[f]] += costs.area(f);
  double smallest = (std::numeric_limits<double>::infinity)();
  std::size_t result = 0;
  for(std::size_t c = 0; c < area.size(); ++c)
    if(!charts.charts()[c].is_valid && area[c] < smallest)
    {
      smallest = area[c];
      result = c;
    }
  return result;
}

// Gives a chart the label of the neighbour for which the labels of the surface cost least. Returns whether it has one.
inline bool merge_chart(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts, const std::size_t chart,
                        const Normal_labels_3& costs, const double smoothing, std::vector<std::size_t>& labels)
{
  std::array<double, 6> cost = {};
  std::array<bool, 6> has_neighbour = {};
  for(const auto f : mesh.faces())
    for(std::size_t label = 0; label < 6 && charts.chart_of_face()[f] == chart; ++label)
      cost[label] += costs.cost(f, label);
  for(const auto h : mesh.halfedges())
  {
    const std::size_t neighbour = charts.chart(mesh.opposite(h));
    if(charts.chart(h) == chart && neighbour != chart)
    {
      has_neighbour[charts.charts()[neighbour].label] = true;
      cost[charts.charts()[neighbour].label] -= smoothing * costs.weight(mesh.edge(h));
    }
  }

  std::size_t best = 6;
  for(std::size_t label = 0; label < 6; ++label)
    if(has_neighbour[label] && (best == 6 || cost[label] < cost[best]))
      best = label;
  for(const auto f : mesh.faces())
    if(charts.chart_of_face()[f] == chart)
      labels[f] = (best < 6) ? best : labels[f];
  return best < 6;
}

// Makes all charts valid: straightens their borders, and merges those that are not valid into their neighbours.
// Returns whether there are enough of them.
inline bool repair_labels_3(const Boundary_mesh_3& mesh, const Normal_labels_3& costs, const double smoothing,
                            std::vector<std::size_t>& labels)
{
  while(true)
  {
    const Polycube_charts_3 charts(mesh, labels);
    if(charts.charts().size() < 6)
      return false;
    if(straighten_chains_3(mesh, charts, labels))
      continue;
    if(charts.are_valid())
      return true;
    if(!merge_chart(mesh, charts, smallest_invalid_chart(mesh, charts, costs), costs, smoothing, labels))
      return false;
  }
}

// Gives each of the faces to the neighbouring chart that suits it best. Returns whether any of them has one.
inline bool give_away_faces(const Boundary_mesh_3& mesh, const std::vector<Boundary_mesh_3::Face_index>& faces,
                            const Normal_labels_3& costs, std::vector<std::size_t>& labels)
{
  bool has_changed = false;
  for(const auto f : faces)
  {
    const std::size_t label = labels[f];
    for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
    {
      const std::size_t candidate = labels[mesh.face(mesh.opposite(h))];
      if(candidate != label && (labels[f] == label || costs.cost(f, candidate) < costs.cost(f, labels[f])))
        labels[f] = candidate;
    }
    has_changed = has_changed || labels[f] != label;
  }
  return has_changed;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_REPAIR_LABELS_3_H
