// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_SURFACE_LINE_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_SURFACE_LINE_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Shortest_paths.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace CGAL::Polycube_meshing_3::internal {

using Volume_mesh_parameterization::internal::vertex_index; // not CGAL's

using Surface_line_3 = std::vector<Boundary_mesh_3::Halfedge_index>;

inline double length(const Boundary_mesh_3& mesh, const Boundary_mesh_3::Halfedge_index h) { return edge_vector(mesh, h).norm(); }

inline double length(const Boundary_mesh_3& mesh, const Surface_line_3& line)
{
  return std::accumulate(line.begin(), line.end(), 0., [&](const double sum, const auto h) { return sum + length(mesh, h); });
}

// Returns the halfedges that leave a closed line to one side, where its i-th halfedge begins.
inline Surface_line_3 leaving(const Boundary_mesh_3& mesh, const Surface_line_3& line, const std::size_t i, const bool is_left)
{
  const auto next = line[i], back = mesh.opposite(line[(i + line.size() - 1) % line.size()]);
  const auto turn = [&](const auto h) { return mesh.opposite(mesh.prev(h)); }; // to the left
  Surface_line_3 result;
  for(auto h = turn(is_left ? next : back); h != (is_left ? back : next); h = turn(h))
    result.push_back(h);
  return result;
}

// Returns four different vertices that divide a closed line into quarters. The first one is behind the vertex `first` by a part
// of the length of the line.
inline std::array<std::size_t, 4> quarters(const Boundary_mesh_3& mesh, const Surface_line_3& line, const std::size_t first,
                                           const double part)
{
  const std::size_t n = line.size();
  const double whole = length(mesh, line);
  std::array<std::size_t, 4> result;
  std::size_t i = 0;   // vertices that have been passed
  double position = 0; // of the next one
  const auto pass = [&]() { position += length(mesh, line[(first + i++) % n]); };
  for(std::size_t k = 0; k < 4; ++k)
  {
    const double wanted = whole * (part + static_cast<double>(k) / 4);
    const std::size_t last = n - 4 + k; // leaves vertices to the other quarters
    while(i < last && position + length(mesh, line[(first + i) % n]) / 2 < wanted)
      pass();
    result[k] = (first + i) % n;
    pass();
  }
  return result;
}

// Returns a closed line with two sides of a face in a row replaced by the third side.
inline Surface_line_3 without_shortcuts(const Boundary_mesh_3& mesh, Surface_line_3 line)
{
  for(std::size_t i = 0; i < line.size() && line.size() > 4; )
  {
    const std::size_t next = (i + 1) % line.size();
    const auto a = line[i], b = line[next], back_a = mesh.opposite(a), back_b = mesh.opposite(b);
    if(mesh.next(a) != b && mesh.next(back_b) != back_a)
    {
      ++i;
      continue;
    }
    line[i] = mesh.next(a) == b ? mesh.opposite(mesh.next(b)) : mesh.prev(back_b);
    line.erase(line.begin() + next);
    i = 0;
  }
  return line;
}

// Returns the shortest paths on a surface from some vertices, given the lengths of halfedges.
template <typename Length>
Shortest_paths shortest_paths_3(const Boundary_mesh_3& mesh, const std::vector<Boundary_mesh_3::Vertex_index>& sources,
                                const Length& length)
{
  const auto for_each_edge = [&](const std::size_t v, const auto& reach)
  {
    for(const auto h : CGAL::halfedges_around_source(vertex_index(v), mesh))
      reach(mesh.target(h), length(h));
  };
  return Shortest_paths(mesh.number_of_vertices(), sources, for_each_edge, [](std::size_t) { return false; });
}

inline Surface_line_3 line_along(const Boundary_mesh_3& mesh, const std::vector<std::size_t>& path)
{
  Surface_line_3 result;
  for(std::size_t i = 1; i < path.size(); ++i)
    result.push_back(mesh.halfedge(vertex_index(path[i - 1]), vertex_index(path[i])));
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_HANDLES_SURFACE_LINE_3_H
