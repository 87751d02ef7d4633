// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_DRAWN_POLYCUBE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_DRAWN_POLYCUBE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Label_functional_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Placement_of_voxel_faces_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Routed_charts_3.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the charts of the facets that share a vertex with a facet, in their order around that facet. Each run of facets in one
// chart counts once.
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

// Returns whether the topology of charts stays if a facet goes over to the chart of a neighbor: its chart has one or
// two of the three neighbors, and around the facet, its chart and one or two others have one run of facets each.
inline bool may_change_chart(const Boundary_mesh_3& mesh, const Boundary_mesh_3::Face_index f,
                             const std::vector<std::size_t>& chart_of_facet)
{
  const auto edges = CGAL::halfedges_around_face(mesh.halfedge(f), mesh);
  const auto number_of_own = std::count_if(edges.begin(), edges.end(), [&](const auto h)
  { return chart_of_facet[mesh.face(mesh.opposite(h))] == chart_of_facet[f]; });
  if(number_of_own == 0 || number_of_own == 3)
    return false;
  std::vector<std::size_t> around = charts_around(mesh, f, chart_of_facet);
  std::sort(around.begin(), around.end());
  return around.size() <= 3 && std::unique(around.begin(), around.end()) == around.end()
         && std::binary_search(around.begin(), around.end(), chart_of_facet[f]);
}

// Gives facets to neighboring charts as long as that lowers the cost of labels and borders and keeps the topology of the charts.
inline void relax_charts_3(const Unit_surface_3& surface, const std::vector<std::size_t>& label_of_chart,
                           std::vector<std::size_t>& chart_of_facet)
{
  constexpr double smoothing = 0.02;             // weight of the lengths of borders, as for moves of charts
  constexpr int maximum_number_of_rounds = 200;  // a guess
  const Boundary_mesh_3& mesh = surface.mesh;
  const Label_functional_3 functional(mesh, surface.is_sharp);
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
      if(sizes[chart] < 2 || !may_change_chart(mesh, f, chart_of_facet))
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

// Polycube of voxels: faces of the voxels, placed on the surface, and their charts.
struct Polycube_of_voxels_3
{
  double size_of_voxels;
  Voxel_faces_3 faces;
  Polycube_charts_3 charts;
  std::vector<int> plane_of_chart; // number of the plane between layers of voxels, along the axis of the chart

  // Takes the labels of the faces, and the planes of their images.
  Polycube_of_voxels_3(const double size, Voxel_faces_3 placed, const std::vector<std::size_t>& labels,
                       const std::vector<int>& planes)
    : size_of_voxels(size), faces(std::move(placed)), charts(faces.mesh, labels), plane_of_chart(charts.number_of_charts())
  {
    for(std::size_t f = 0; f < planes.size(); ++f)
      plane_of_chart[charts.chart_of_face()[f]] = planes[f];
  }
  Polycube_of_voxels_3(const Polycube_of_voxels_3&) = delete; // the charts refer to the mesh
};

// Lengths of the edges of a surface near the chains of a polycube: at first twice the size of voxels. They become shorter near
// chains that cannot be drawn or mapped, and only there, as short edges multiply the cells of the body.
class Lengths_at_chains_3
{
public:
  explicit Lengths_at_chains_3(const Polycube_of_voxels_3& polycube)
    : m_nearest(0), m_lengths(polycube.charts.chains().size(), 2 * polycube.size_of_voxels) // by distance alone, a guess
  {
    for(std::size_t i = 0; i < m_lengths.size(); ++i)
      for(const auto v : polycube.charts.vertices(polycube.charts.chains()[i]))
      {
        m_points.push_back(polycube.faces.point(v));
        m_chain_of_point.push_back(i);
        m_nearest.add(m_points.back(), Vector_3::Zero());
      }
  }

  // Returns the number of the chain that is nearest to a point.
  std::size_t nearest_chain(const Vector_3& p) const { return m_chain_of_point[m_nearest.nearest(p, Vector_3::Zero())]; }

  // Returns the length of edges at a point: that of the nearest chain, or the distance from it.
  double operator()(const Vector_3& p) const
  {
    const std::size_t i = m_nearest.nearest(p, Vector_3::Zero());
    return (std::max)(m_lengths[m_chain_of_point[i]], (m_points[i] - p).norm());
  }

  // Halves the lengths at some chains, or at all if none is given, unless they are the least one. Returns whether one has changed.
  bool halve(const std::set<std::size_t>& chains, const double least)
  {
    bool has_changed = false;
    for(std::size_t i = 0; i < m_lengths.size(); ++i)
      if(m_lengths[i] > least && (chains.empty() || chains.count(i) > 0))
      {
        m_lengths[i] /= 2;
        has_changed = true;
      }
    return has_changed;
  }

private:
  Nearest_with_normal_3 m_nearest;
  std::vector<double> m_lengths; // by chain
  std::vector<Vector_3> m_points;
  std::vector<std::size_t> m_chain_of_point;
};

// Surface with the charts of a polycube.
struct Drawn_polycube_3
{
  Unit_surface_3 surface;
  std::vector<std::size_t> chart_of_facet = {}; // none if the charts cannot be drawn
  std::set<std::size_t> blocked_chains = {};    // by others, in some order of the chains
};

// Draws the charts on a surface, whose edges are split first.
inline Drawn_polycube_3 draw_polycube_3(const Polycube_of_voxels_3& polycube, const Unit_surface_3& surface,
                                        const Lengths_at_chains_3& lengths, const Budget& budget)
{
  Drawn_polycube_3 result = { surface };
  split_long_edges_3(lengths, result.surface);
  Routed_charts_3 charts(result.surface, polycube.faces, polycube.charts, polycube.size_of_voxels);
  result.chart_of_facet = charts.run(budget);
  result.blocked_chains = charts.blocked_chains();
  return result;
}

// Splits edges inside charts between two vertices of borders: the map cannot move facets whose vertices are all on borders.
inline void split_between_borders(Drawn_polycube_3& drawn)
{
  const Boundary_mesh_3& mesh = drawn.surface.mesh;
  std::vector<bool> is_on_border(mesh.number_of_vertices(), false);
  const auto is_border = [&](const auto h)
  { return drawn.chart_of_facet[mesh.face(h)] != drawn.chart_of_facet[mesh.face(mesh.opposite(h))]; };
  for(const auto h : mesh.halfedges())
    if(is_border(h))
      is_on_border[mesh.target(h)] = true;
  std::vector<Boundary_mesh_3::Edge_index> edges;
  for(const auto e : mesh.edges())
    if(const auto h = mesh.halfedge(e); !is_border(h) && is_on_border[mesh.source(h)] && is_on_border[mesh.target(h)])
      edges.push_back(e);
  std::vector<std::size_t> charts;
  for(const std::size_t parent : split_edges_3(std::move(edges), drawn.surface))
    charts.push_back(drawn.chart_of_facet[parent]);
  drawn.chart_of_facet = std::move(charts);
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_DRAWN_POLYCUBE_3_H
