// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_HANDLES_SURFACE_LINE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_HANDLES_SURFACE_LINE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <queue>

namespace CGAL::Volume_mesh_parameterization::internal {

using Surface_line_3 = std::vector<Boundary_mesh_3::Halfedge_index>;

inline double length(const Boundary_mesh_3& mesh, const Boundary_mesh_3::Halfedge_index h)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
}

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
  double sum = 0;
  for(std::size_t i = 0, k = 0; k < 4; ++k, sum += length(mesh, line[(first + i) % n]), ++i)
  {
    const double wanted = whole * (part + static_cast<double>(k) / 4);
    for(; i + 4 < n + k && sum + length(mesh, line[(first + i) % n]) / 2 < wanted; ++i)
      sum += length(mesh, line[(first + i) % n]);
    result[k] = (first + i) % n;
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

// Shortest paths on a surface from several vertices, along halfedges that have lengths; halfedges of infinite length are not
// used.
struct Shortest_paths_3
{
  using Vertex = Boundary_mesh_3::Vertex_index;
  using Halfedge = Boundary_mesh_3::Halfedge_index;
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  std::vector<double> distance;
  std::vector<Halfedge> last; // last halfedge of the path to each vertex

  template <typename Length>
  Shortest_paths_3(const Boundary_mesh_3& mesh, const std::vector<Vertex>& sources, const Length& length)
    : distance(mesh.number_of_vertices(), infinity), last(mesh.number_of_vertices())
  {
    using Entry = std::pair<double, Vertex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    const auto reach = [&](const Vertex v, const double d)
    {
      distance[v] = d;
      queue.push({ d, v });
    };
    for(const Vertex v : sources)
      reach(v, 0);
    while(!queue.empty())
    {
      const auto [d, v] = queue.top();
      queue.pop();
      if(d == distance[v])
        for(const Halfedge h : CGAL::halfedges_around_source(v, mesh))
          if(const double candidate = d + length(h); candidate < distance[mesh.target(h)])
          {
            last[mesh.target(h)] = h;
            reach(mesh.target(h), candidate);
          }
    }
  }

  // Returns the path from a source to a vertex that has been reached.
  Surface_line_3 path_to(const Boundary_mesh_3& mesh, Vertex v) const
  {
    Surface_line_3 result;
    for(; distance[v] > 0; v = mesh.source(last[v]))
      result.push_back(last[v]);
    std::reverse(result.begin(), result.end());
    return result;
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_POLYCUBE_HANDLES_SURFACE_LINE_3_H
