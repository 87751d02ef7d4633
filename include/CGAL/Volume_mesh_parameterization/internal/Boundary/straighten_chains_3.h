// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_STRAIGHTEN_CHAINS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_STRAIGHTEN_CHAINS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Polycube/Polycube_charts_3.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
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

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_STRAIGHTEN_CHAINS_3_H
