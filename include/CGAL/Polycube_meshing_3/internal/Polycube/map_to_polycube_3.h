// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_POLYCUBE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_POLYCUBE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Surface_map_3.h>
#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>

#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <vector>

namespace CGAL::Polycube_meshing_3::internal {

// Returns the sharp edges of a surface whose images lead along no axis, joined to polylines, the longest one first.
inline std::vector<std::vector<Vector_3> > features_given_up_3(const Numbered_surface_3& surface,
                                                               const std::vector<Vector_3>& images)
{
  using Graph = boost::adjacency_list<boost::setS, boost::vecS, boost::undirectedS>;
  struct Visitor // of split_graph_into_polylines()
  {
    const std::vector<Vector_3>& points;
    std::vector<std::vector<Vector_3> >& polylines;

    void start_new_polyline() { polylines.emplace_back(); }
    void add_node(const std::size_t v) { polylines.back().push_back(points[v]); }
    void end_polyline() {}
  };
  Graph graph(surface.points.size());
  for(const auto& [v, w] : surface.sharp_edges)
    if(!leads_along_axis(images[v], images[w]))
      add_edge(v, w, graph);
  std::vector<std::vector<Vector_3> > result;
  Visitor visitor = { surface.points, result };
  CGAL::split_graph_into_polylines(graph, visitor);
  const auto is_point = [](const std::vector<Vector_3>& polyline) { return polyline.size() < 2; };
  result.erase(std::remove_if(result.begin(), result.end(), is_point), result.end());

  const auto length = [](const std::vector<Vector_3>& polyline)
  {
    double sum = 0;
    for(std::size_t i = 1; i < polyline.size(); ++i)
      sum += (polyline[i] - polyline[i - 1]).norm();
    return sum;
  };
  std::stable_sort(result.begin(), result.end(), [&](const auto& a, const auto& b) { return length(a) > length(b); });
  return result;
}

// Surface that is to be mapped to a polycube, and how.
struct Polycube_problem_3
{
  Numbered_surface_3 surface;
  std::vector<std::size_t> labels = {}; // axis directions that images of facets are normal to; none if they are to be proposed
  double spacing = 0;                   // that coordinates of faces are multiples of, or 0 for any coordinates
  bool do_find_axes = false; // may the surface be turned, if it has no labels, and the polycube be moved to be close to it?
  bool may_split = false;    // may edges of the surface be split for a better map?
};

// Polycube that a surface is mapped to, after it has been turned about the center of its bounding box.
struct Polycube_candidate_3
{
  const char* strategy; // that found it
  Matrix_3 rotation;
  Surface_map_3 map;
  double cost;          // of the map, and the part of sharp edges given up
};

// Polycubes of a surface, the cheapest one first. The status is OK, or the reason why there are none.
struct Found_polycubes_3
{
  Error_code status = ERROR_NO_POLYCUBE;
  std::vector<Polycube_candidate_3> candidates = {};
};

// Maps a surface onto polycubes. Without labels, those that keep as many details as possible are proposed.
CGAL_POLYCUBE_MESHING_3_INLINE
Found_polycubes_3 map_to_polycube_3(const Polycube_problem_3& problem, const Budget& budget);

} // namespace CGAL::Polycube_meshing_3::internal

#ifndef CGAL_POLYCUBE_MESHING_3_COMPILED_ENGINE
#  include <CGAL/Polycube_meshing_3/internal/Polycube/map_to_polycube_3_impl.h>
#endif

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_MAP_TO_POLYCUBE_3_H
