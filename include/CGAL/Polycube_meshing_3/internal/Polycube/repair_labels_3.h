// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_REPAIR_LABELS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_REPAIR_LABELS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Normal_labels_3.h>

#include <optional>

namespace CGAL::Polycube_meshing_3::internal {

// Edge inside a chart that joins two vertices of a chain around the chart.
struct Chain_chord_3
{
  Boundary_mesh_3::Halfedge_index edge;
  Boundary_mesh_3::Halfedge_index cut_off; // a halfedge of the chain, in the chart, between the two vertices
  std::size_t chart, other_chart; // on both sides of the chain, that of the edge first
};

// Returns a chord of a chain, directed like the chain; none if there is no chord.
inline std::optional<Chain_chord_3> find_chord(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts,
                                               const Polycube_chain_3& chain)
{
  const std::vector<Polycube_charts_3::Vertex> path = charts.vertices(chain);
  std::vector<std::pair<Polycube_charts_3::Vertex, std::size_t> > positions; // in the order of vertices
  for(std::size_t i = 0; i < path.size(); ++i)
    positions.emplace_back(path[i], i);
  std::sort(positions.begin(), positions.end());
  const auto position = [&](const Polycube_charts_3::Vertex v) // on the chain; 0 for vertices beside it, too
  {
    const auto it = std::lower_bound(positions.begin(), positions.end(), std::pair(v, std::size_t(0)));
    return it != positions.end() && it->first == v ? it->second : 0;
  };
  for(std::size_t i = 0; i < path.size(); ++i)
    for(const auto h : CGAL::halfedges_around_source(path[i], mesh))
    {
      if(charts.separates(h) || position(mesh.target(h)) < i + 2)
        continue;
      if(charts.chart(h) == chain.charts[0])
        return Chain_chord_3{ h, chain.halfedges[i], chain.charts[0], chain.charts[1] };
      if(charts.chart(h) == chain.charts[1])
        return Chain_chord_3{ h, mesh.opposite(chain.halfedges[i]), chain.charts[1], chain.charts[0] };
    }
  return std::nullopt;
}

// Returns the faces of a chart between a chord and its chain.
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

// Gives faces that chords cut off to the chart on the other side of the chain: the image of a chord would lie on an edge of the
// polycube, and the images of these faces, too. Returns whether there were any.
inline bool straighten_chains_3(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts,
                                std::vector<std::size_t>& labels)
{
  std::vector<bool> has_changed(charts.number_of_charts(), false);
  for(const Polycube_chain_3& chain : charts.chains())
  {
    if(has_changed[chain.charts[0]] || has_changed[chain.charts[1]])
      continue;
    const std::optional<Chain_chord_3> chord = find_chord(mesh, charts, chain);
    if(!chord)
      continue;
    for(const auto f : faces_cut_off(mesh, charts, *chord))
      labels[f] = charts.labels()[chord->other_chart];
    has_changed[chain.charts[0]] = has_changed[chain.charts[1]] = true;
  }
  return std::find(has_changed.begin(), has_changed.end(), true) != has_changed.end();
}

// Gives charts with defects, and their neighbors, other labels, each at most once: the cheapest label with which there
// are fewer defects. Returns whether a label changed; none does if the budget is exhausted.
inline bool relabel_invalid_charts(const Polycube_charts_3& charts, const std::vector<Chart_relabelling_3>& changes,
                           std::vector<std::size_t>& labels, const Budget& budget)
{
  std::vector<std::size_t> best = charts.labels();
  int defects = charts.number_of_defects();
  for(const Chart_relabelling_3& change : changes)
  {
    if(budget.is_exhausted())
      return false;
    if(best[change.chart] != charts.labels()[change.chart] || !charts.is_beside_invalid(change.chart))
      continue;
    std::vector<std::size_t> candidate = best;
    candidate[change.chart] = change.label;
    if(const int n = charts.number_of_defects(candidate); n < defects)
    {
      best = candidate;
      defects = n;
    }
  }
  if(best == charts.labels())
    return false;
  for(std::size_t f = 0; f < labels.size(); ++f)
    labels[f] = best[charts.chart_of_face()[f]];
  return true;
}

// Makes all charts valid: straightens their borders, and relabels charts with defects or their neighbors. Returns whether all are
// valid, and at least six.
inline bool repair_labels_3(const Boundary_mesh_3& mesh, const Normal_labels_3& costs, const double smoothing,
                            std::vector<std::size_t>& labels, const Budget& budget)
{
  std::optional<std::size_t> steps;
  while(!budget.is_exhausted())
  {
    const Polycube_charts_3 charts(mesh, labels);
    if(!steps)
      steps = charts.number_of_charts() + charts.number_of_defects(); // each step removes a chart or a defect
    if(charts.number_of_charts() < 6)
      return false;
    if(straighten_chains_3(mesh, charts, labels))
      continue;
    if(charts.number_of_defects() == 0)
      return true;
    if((*steps)-- == 0
       || !relabel_invalid_charts(charts, costs.chart_relabellings(smoothing, labels, charts.chart_of_face()), labels, budget))
      return false;
  }
  return false;
}

// Gives each of some faces to the neighboring chart whose label costs least there. Returns whether any face changed its chart.
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

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_REPAIR_LABELS_3_H
