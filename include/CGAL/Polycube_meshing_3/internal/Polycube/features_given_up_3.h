// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_FEATURES_GIVEN_UP_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_FEATURES_GIVEN_UP_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>

#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the sharp edges of a surface whose images lead along no axis, joined to polylines of its points, the longest one first.
inline std::vector<std::vector<Eigen::Vector3d> > features_given_up_3(const Numbered_surface_3& surface,
                                                                      const std::vector<Eigen::Vector3d>& images)
{
  using Graph = boost::adjacency_list<boost::setS, boost::vecS, boost::undirectedS>;
  struct Visitor // of split_graph_into_polylines()
  {
    const std::vector<Eigen::Vector3d>& points;
    std::vector<std::vector<Eigen::Vector3d> >& polylines;

    void start_new_polyline() { polylines.emplace_back(); }
    void add_node(const std::size_t v) { polylines.back().push_back(points[v]); }
    void end_polyline() {}
  };
  Graph graph(surface.points.size());
  for(const auto& [v, w] : surface.sharp_edges)
    if(!leads_along_axis(images[v], images[w]))
      add_edge(v, w, graph);
  std::vector<std::vector<Eigen::Vector3d> > result;
  Visitor visitor = { surface.points, result };
  CGAL::split_graph_into_polylines(graph, visitor);
  const auto is_point = [](const std::vector<Eigen::Vector3d>& polyline) { return polyline.size() < 2; };
  result.erase(std::remove_if(result.begin(), result.end(), is_point), result.end());

  const auto length = [](const std::vector<Eigen::Vector3d>& polyline)
  {
    double sum = 0;
    for(std::size_t i = 1; i < polyline.size(); ++i)
      sum += (polyline[i] - polyline[i - 1]).norm();
    return sum;
  };
  std::stable_sort(result.begin(), result.end(), [&](const auto& a, const auto& b) { return length(a) > length(b); });
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_FEATURES_GIVEN_UP_3_H
