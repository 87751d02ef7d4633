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

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Normal_labels_3.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// An edge inside a chart that joins two vertices of a chain around the chart.
struct Chain_chord_3
{
  Boundary_mesh_3::Halfedge_index edge;
  Boundary_mesh_3::Halfedge_index cut_off; // a halfedge of the chain, in the chart, between the two vertices
  std::size_t chart, other_chart;
};

inline std::optional<Chain_chord_3> find_chord(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts,
                                               const Polycube_chain_3& chain)
{
  const std::vector<Polycube_charts_3::Vertex> path = charts.vertices(chain);
  std::map<Polycube_charts_3::Vertex, std::size_t> position;
  for(std::size_t i = 0; i < path.size(); ++i)
    position[path[i]] = i;
  for(std::size_t i = 0; i < path.size(); ++i)
    for(const auto h : CGAL::halfedges_around_source(path[i], mesh))
    {
      const auto end = position.find(mesh.target(h));
      if(end == position.end() || end->second < i + 2 || charts.chart(h) != charts.chart(mesh.opposite(h)))
        continue;
      if(charts.chart(h) == chain.charts[0])
        return Chain_chord_3{ h, chain.halfedges[i], chain.charts[0], chain.charts[1] };
      if(charts.chart(h) == chain.charts[1])
        return Chain_chord_3{ h, mesh.opposite(chain.halfedges[i]), chain.charts[1], chain.charts[0] };
    }
  return std::nullopt;
}

// The faces of a chart that a chord cuts off, together with a halfedge of the chain.
inline std::vector<Boundary_mesh_3::Face_index> faces_cut_off(const Boundary_mesh_3& mesh,
                                                              const Polycube_charts_3& charts,
                                                              const Chain_chord_3& chord)
{
  std::vector<bool> is_reached(mesh.number_of_faces(), false);
  std::vector<Boundary_mesh_3::Face_index> faces(1, mesh.face(chord.cut_off));
  is_reached[faces[0]] = true;
  for(std::size_t i = 0; i < faces.size(); ++i)
    for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(faces[i]), mesh))
    {
      const auto f = mesh.face(mesh.opposite(h));
      if(mesh.edge(h) == mesh.edge(chord.edge) || charts.chart_of_face()[f] != chord.chart || is_reached[f])
        continue;
      is_reached[f] = true;
      faces.push_back(f);
    }
  return faces;
}

// The image of a chord would lie on the edge of the polycube, and the faces that it cuts off be flat: they
// are given to the chart on the other side of the chain. Returns whether there were any.
inline bool straighten_chains_3(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts,
                                std::vector<std::size_t>& labels)
{
  std::vector<bool> has_changed(charts.charts().size(), false);
  for(const Polycube_chain_3& chain : charts.chains())
  {
    if(has_changed[chain.charts[0]] || has_changed[chain.charts[1]])
      continue;
    const std::optional<Chain_chord_3> chord = find_chord(mesh, charts, chain);
    if(!chord)
      continue;
    for(const auto f : faces_cut_off(mesh, charts, *chord))
      labels[f] = charts.charts()[chord->other_chart].label;
    has_changed[chain.charts[0]] = has_changed[chain.charts[1]] = true;
  }
  return std::find(has_changed.begin(), has_changed.end(), true) != has_changed.end();
}

// Another label for a chart, and by how much the labels of the surface cost more then.
struct Chart_relabelling_3
{
  std::size_t chart, label;
  double cost;
};

// Those of the charts that are not valid, and of their neighbours; the cheapest first.
inline std::vector<Chart_relabelling_3> relabellings_3(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts,
                                                       const Normal_labels_3& costs)
{
  std::vector<std::array<double, 6> > cost(charts.charts().size(), std::array<double, 6>{});
  std::vector<bool> is_candidate(cost.size(), false);
  for(const auto f : mesh.faces())
    for(std::size_t label = 0; label < 6; ++label)
      cost[charts.chart_of_face()[f]][label] += costs.cost(f, label);
  for(const auto h : mesh.halfedges())
  {
    const std::size_t c = charts.chart(h), neighbour = charts.chart(mesh.opposite(h));
    is_candidate[c] = is_candidate[c] || !charts.charts()[c].is_valid() || !charts.charts()[neighbour].is_valid();
    if(c != neighbour)
      cost[c][charts.charts()[neighbour].label] -= costs.cost(mesh.edge(h));
  }

  std::vector<Chart_relabelling_3> result;
  for(std::size_t c = 0; c < cost.size(); ++c)
    for(std::size_t label = 0; label < 6; ++label)
      if(is_candidate[c] && label != charts.charts()[c].label)
        result.push_back({ c, label, cost[c][label] - cost[c][charts.charts()[c].label] });
  std::stable_sort(result.begin(), result.end(), [](const Chart_relabelling_3& a, const Chart_relabelling_3& b)
  {
    return a.cost < b.cost;
  });
  return result;
}

// Gives charts other labels, each at most once and to the cheapest one with which there are fewer defects. If there is
// none, a chart that is not valid is merged into a neighbour. Returns whether anything changed.
inline bool relabel_charts(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts, const Normal_labels_3& costs,
                           std::vector<std::size_t>& labels, const Budget& budget)
{
  int defects = charts.number_of_defects();
  std::vector<bool> is_relabelled(charts.charts().size(), false);
  std::optional<std::vector<std::size_t> > merged;
  for(const Chart_relabelling_3& change : relabellings_3(mesh, charts, costs))
  {
    if(budget.is_exhausted())
      return false;
    if(is_relabelled[change.chart])
      continue;
    std::vector<std::size_t> candidate = labels;
    for(const auto f : mesh.faces())
      if(charts.chart_of_face()[f] == change.chart)
        candidate[f] = change.label;
    const Polycube_charts_3 next(mesh, candidate);
    if(next.number_of_defects() < defects)
    {
      labels = candidate;
      defects = next.number_of_defects();
      is_relabelled[change.chart] = true;
    }
    else if(!merged && !charts.charts()[change.chart].is_valid() && next.charts().size() < charts.charts().size())
      merged = candidate;
  }
  if(defects == charts.number_of_defects() && merged)
    labels = *merged;
  return defects < charts.number_of_defects() || merged;
}

// Makes all charts valid: straightens their borders, and relabels those that are not valid, or their neighbours.
// Returns whether that was possible.
inline bool repair_labels_3(const Boundary_mesh_3& mesh, const Normal_labels_3& costs, std::vector<std::size_t>& labels,
                            const Budget& budget)
{
  const Polycube_charts_3 start(mesh, labels);
  std::size_t steps = start.charts().size() + start.number_of_defects(); // each step takes one of them, or more
  while(!budget.is_exhausted())
  {
    const Polycube_charts_3 charts(mesh, labels);
    if(charts.charts().size() < 6)
      return false;
    if(straighten_chains_3(mesh, charts, labels))
      continue;
    if(charts.are_valid())
      return true;
    if(steps-- == 0 || !relabel_charts(mesh, charts, costs, labels, budget))
      return false;
  }
  return false;
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
