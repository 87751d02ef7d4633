// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_RELAX_CHARTS_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_RELAX_CHARTS_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Label_functional_3.h>

#include <algorithm>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the charts of the facets that have a vertex with a facet, in their order around it: each run of facets with one chart
// counts once.
inline std::vector<std::size_t> charts_around(const Boundary_mesh_3& mesh, const Boundary_mesh_3::Face_index f,
                                              const std::vector<std::size_t>& chart_of_facet)
{
  std::vector<std::size_t> ring, result;
  for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) // clockwise around the target of each edge
    for(auto g = mesh.opposite(h); mesh.face(g) != f; g = mesh.opposite(mesh.prev(g)))
      ring.push_back(chart_of_facet[mesh.face(g)]);
  for(std::size_t i = 0; i < ring.size(); ++i)
    if(ring[i] != ring[(i + 1) % ring.size()])
      result.push_back(ring[i]);
  return result;
}

// Gives facets to neighboring charts as long as that lowers the cost of the labels and the length of borders, and keeps the
// topology of the charts: around the facet, its chart and the other one, and perhaps a third one, have one run of facets each.
inline void relax_charts_3(const Boundary_mesh_3& mesh, const Label_functional_3& functional,
                           const std::vector<std::size_t>& label_of_chart, std::vector<std::size_t>& chart_of_facet)
{
  constexpr double smoothing = 0.02;             // in units of the body, as for moves of charts
  constexpr int maximum_number_of_rounds = 200;  // a guess
  std::vector<std::size_t> sizes(label_of_chart.size(), 0);
  for(const std::size_t c : chart_of_facet)
    ++sizes[c];
  bool has_changed = true;
  for(int round = 0; round < maximum_number_of_rounds && has_changed; ++round)
  {
    has_changed = false;
    for(const auto f : mesh.faces())
    {
      const std::size_t chart = chart_of_facet[f];
      const auto edges = CGAL::halfedges_around_face(mesh.halfedge(f), mesh);
      const auto chart_across = [&](const auto h) { return chart_of_facet[mesh.face(mesh.opposite(h))]; };
      const auto number_of_own = std::count_if(edges.begin(), edges.end(), [&](const auto h) { return chart_across(h) == chart; });
      if(sizes[chart] < 2 || number_of_own == 0 || number_of_own == 3)
        continue;
      std::vector<std::size_t> around = charts_around(mesh, f, chart_of_facet);
      std::sort(around.begin(), around.end());
      if(around.size() > 3 || std::unique(around.begin(), around.end()) != around.end()
         || !std::binary_search(around.begin(), around.end(), chart))
        continue;
      const auto cost = [&](const std::size_t c)
      {
        double result = functional.cost(f, label_of_chart[c]);
        for(const auto h : edges)
          result += smoothing * (chart_across(h) != c) * functional.length(h);
        return result;
      };
      double least = cost(chart) - 1e-12; // more than rounding
      for(const auto h : edges)
        if(const std::size_t c = chart_across(h); c != chart && cost(c) < least)
        {
          least = cost(c);
          chart_of_facet[f] = c;
        }
      if(chart_of_facet[f] == chart)
        continue;
      --sizes[chart];
      ++sizes[chart_of_facet[f]];
      has_changed = true;
    }
  }
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_RELAX_CHARTS_3_H
