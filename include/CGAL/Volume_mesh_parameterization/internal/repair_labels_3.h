// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REPAIR_LABELS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REPAIR_LABELS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Normal_labels_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Polycube_charts_3.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The faces on the left of an edge that can be reached without crossing the edge or leaving the chart.
inline std::vector<Boundary_mesh_3::Face_index> faces_beside(const Boundary_mesh_3& mesh,
                                                             const Polycube_charts_3& charts,
                                                             const Boundary_mesh_3::Halfedge_index edge)
{
  std::vector<bool> is_reached(mesh.number_of_faces(), false);
  std::vector<Boundary_mesh_3::Face_index> faces(1, mesh.face(edge));
  is_reached[mesh.face(edge)] = true;
  for(std::size_t i = 0; i < faces.size(); ++i)
    for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(faces[i]), mesh))
    {
      const auto opposite = mesh.opposite(h);
      if(h == edge || opposite == edge || charts.chart(opposite) != charts.chart(edge)
         || is_reached[mesh.face(opposite)])
        continue;
      is_reached[mesh.face(opposite)] = true;
      faces.push_back(mesh.face(opposite));
    }
  return faces;
}

// An edge inside a chart that joins two vertices of a chain would become part of the edge of the polycube, and the
// faces that it cuts off flat: they get the label of the chart on the other side of the chain. Returns whether there were any.
inline bool straighten_chains(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts,
                              std::vector<std::size_t>& labels)
{
  bool has_changed = false;
  std::vector<bool> is_taken(charts.charts().size(), false); // once a round, the chart is not what it was
  for(const Polycube_chain_3& chain : charts.chains())
  {
    if(is_taken[chain.charts[0]] || is_taken[chain.charts[1]])
      continue;
    const std::vector<Polycube_charts_3::Vertex> path = charts.vertices(chain);
    std::map<Polycube_charts_3::Vertex, std::size_t> position;
    for(std::size_t i = 0; i < path.size(); ++i)
      position[path[i]] = i;
    for(std::size_t i = 0; i < path.size() && !is_taken[chain.charts[0]]; ++i)
      for(const auto h : CGAL::halfedges_around_source(path[i], mesh))
      {
        const auto found = position.find(mesh.target(h));
        if(found == position.end() || found->second < i + 2)
          continue;
        const std::size_t c = charts.chart(h);
        if(charts.chart(mesh.opposite(h)) != c || (c != chain.charts[0] && c != chain.charts[1]))
          continue;
        const std::size_t other = (c == chain.charts[0]) ? chain.charts[1] : chain.charts[0];
        const auto border = (c == chain.charts[0]) ? chain.halfedges[i] : mesh.opposite(chain.halfedges[i]);
        auto faces = faces_beside(mesh, charts, h);
        if(std::find(faces.begin(), faces.end(), mesh.face(border)) == faces.end())
          faces = faces_beside(mesh, charts, mesh.opposite(h));
        for(const auto f : faces)
          labels[f] = charts.charts()[other].label;
        is_taken[chain.charts[0]] = is_taken[chain.charts[1]] = has_changed = true;
        break;
      }
  }
  return has_changed;
}

// Gives the smallest chart that is not valid the label of the neighbour that suits it best.
inline void merge_invalid_chart(const Boundary_mesh_3& mesh, const Polycube_charts_3& charts,
                                const Normal_labels_3& costs, const double smoothing, std::vector<std::size_t>& labels)
{
  std::vector<double> area(charts.charts().size(), 0.);
  std::vector<std::array<double, 6> > cost(charts.charts().size(), std::array<double, 6>{});
  std::vector<std::array<bool, 6> > has_neighbour(charts.charts().size(), std::array<bool, 6>{});
  for(const auto h : mesh.halfedges())
  {
    const std::size_t c = charts.chart(h), d = charts.chart(mesh.opposite(h)), label = charts.charts()[d].label;
    if(c == d)
      continue;
    has_neighbour[c][label] = true;
    cost[c][label] -= smoothing * costs.weight(mesh.edge(h));
  }
  for(const auto f : mesh.faces())
  {
    const std::size_t c = charts.chart_of_face()[f];
    area[c] += costs.area(f);
    for(std::size_t label = 0; label < 6; ++label)
      cost[c][label] += costs.cost(f, label);
  }

  std::size_t smallest = area.size(), best = 6;
  for(std::size_t c = 0; c < area.size(); ++c)
    if(!charts.charts()[c].is_valid && (smallest == area.size() || area[c] < area[smallest]))
      smallest = c;
  for(std::size_t label = 0; label < 6; ++label)
    if(has_neighbour[smallest][label] && (best == 6 || cost[smallest][label] < cost[smallest][best]))
      best = label;
  for(const auto f : mesh.faces())
    if(charts.chart_of_face()[f] == smallest)
      labels[f] = best;
}

// Gives faces to a neighbouring chart. Returns whether any of them has one.
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

// Returns whether the charts are valid in the end.
inline bool repair_labels_3(const Boundary_mesh_3& mesh, const Normal_labels_3& costs, const double smoothing,
                            std::vector<std::size_t>& labels)
{
  while(true)
  {
    const Polycube_charts_3 charts(mesh, labels);
    if(charts.charts().size() < 6)
      return false;
    if(straighten_chains(mesh, charts, labels))
      continue;
    if(charts.are_valid())
      return true;
    merge_invalid_chart(mesh, charts, costs, smoothing, labels);
  }
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REPAIR_LABELS_3_H
