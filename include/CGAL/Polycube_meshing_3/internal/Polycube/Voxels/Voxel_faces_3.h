// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VOXEL_FACES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VOXEL_FACES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Voxels_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Boundary_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Disjoint_sets.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace CGAL::Polycube_meshing_3::internal {

// Faces of voxels are numbered by the voxel inside and the direction of the outward normal.
inline std::size_t face_of_voxel(const std::size_t voxel, const std::size_t direction) { return 6 * voxel + direction; }
inline std::size_t voxel_of_face(const std::size_t face) { return face / 6; }
inline std::size_t direction_of_face(const std::size_t face) { return face % 6; }

// Returns the face of the boundary of voxels that shares with a face the edge in an orthogonal direction.
inline std::size_t face_across(const Voxels_3& voxels, const std::size_t face, const std::size_t direction)
{
  const Eigen::Vector3i beside = voxels.voxel(voxel_of_face(face)) + step_of_direction(direction),
                        above = beside + step_of_direction(direction_of_face(face));
  if(!voxels.contains(beside))
    return face_of_voxel(voxel_of_face(face), direction);
  return voxels.contains(above) ? face_of_voxel(voxels.index(above), opposite_direction(direction))
                                : face_of_voxel(voxels.index(beside), direction_of_face(face));
}

// Returns the numbers of the faces of the boundary, in ascending order.
inline std::vector<std::size_t> boundary_faces(const Voxels_3& voxels)
{
  std::vector<std::size_t> result;
  for(std::size_t v = 0; v < voxels.is_inside.size(); ++v)
    for(std::size_t d = 0; d < 6 && voxels.is_inside[v]; ++d)
      if(!voxels.contains(voxels.voxel(v) + step_of_direction(d)))
        result.push_back(face_of_voxel(v, d));
  return result;
}

// Charts of the boundary of voxels: coplanar faces that are connected by edges. The charts are the faces of a polycube.
struct Charts_of_voxels_3
{
  const Voxels_3& voxels;
  std::vector<std::size_t> faces;         // numbers of the faces of the boundary
  std::vector<std::size_t> chart_of_face; // by the number of the face; `none` for faces that are not on the boundary
  std::vector<std::size_t> labels;        // directions of the charts

  explicit Charts_of_voxels_3(const Voxels_3& v)
    : voxels(v), faces(boundary_faces(v)), chart_of_face(6 * v.is_inside.size(), none)
  {
    std::vector<std::size_t> chart;
    for(const std::size_t face : faces)
    {
      if(chart_of_face[face] != none)
        continue;
      chart_of_face[face] = labels.size();
      chart.assign(1, face);
      for(std::size_t i = 0; i < chart.size(); ++i)
        for_each_orthogonal_direction(direction_of_face(face), [&](const std::size_t e)
        {
          const std::size_t next = face_across(voxels, chart[i], e);
          if(direction_of_face(next) != direction_of_face(face) || chart_of_face[next] != none)
            return;
          chart_of_face[next] = labels.size();
          chart.push_back(next);
        });
      labels.push_back(direction_of_face(face));
    }
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
};

// Boundary of voxels as a mesh of quadrangles, whose vertices may move.
struct Voxel_faces_3
{
  using Face = Boundary_mesh_3::Face_index;
  using Vertex = Boundary_mesh_3::Vertex_index;

  std::vector<std::size_t> faces; // numbers of the faces of the voxels, in the order of the mesh
  Boundary_mesh_3 mesh;

  explicit Voxel_faces_3(const Voxels_3& voxels) : faces(boundary_faces(voxels))
  {
    std::map<std::array<int, 3>, Vertex> vertices;
    for(const std::size_t face : faces)
    {
      std::array<Vertex, 4> quadrangle;
      for(unsigned int k = 0; k < 4; ++k)
      {
        const Eigen::Vector3i p = voxels.voxel(voxel_of_face(face)) + corner(direction_of_face(face), k);
        const auto [it, is_new] = vertices.emplace(std::array<int, 3>{ p[0], p[1], p[2] }, mesh.number_of_vertices());
        if(is_new)
          mesh.add_vertex(exact_point(voxels.origin + voxels.spacing * p.cast<double>()));
        quadrangle[sign_of_direction(direction_of_face(face)) > 0 ? k : 3 - k] = it->second;
      }
      mesh.add_face(quadrangle);
    }
  }

  // Returns the vertices of a face, counterclockwise as seen from outside.
  std::array<Vertex, 4> vertices(const Face f) const
  {
    const auto h = mesh.halfedge(f), opposite = mesh.next(mesh.next(h));
    return { mesh.target(h), mesh.source(opposite), mesh.target(opposite), mesh.source(h) };
  }

  // Returns the unit normal of each vertex, the mean of those of its faces weighted by area, or 0.
  std::vector<Vector_3> normals_of_vertices() const
  {
    std::vector<Vector_3> result(mesh.number_of_vertices(), Vector_3::Zero());
    for(const Face f : mesh.faces())
    {
      const auto [a, b, c, d] = vertices(f);
      const Vector_3 area_vector = (point(c) - point(a)).cross(point(d) - point(b)); // of the length of twice the area
      for(const Vertex v : { a, b, c, d })
        result[v] += area_vector;
    }
    for(Vector_3& n : result)
      n = n.normalized();
    return result;
  }

  Vector_3 point(const Vertex v) const { return to_vector(mesh.point(v)); }

private:
  // Returns the steps from the lowest corner of a voxel to corner k of its face in a direction; k leads around the axis.
  static Eigen::Vector3i corner(const std::size_t direction, const unsigned int k)
  {
    const int axis = axis_of_direction(direction);
    Eigen::Vector3i result = Eigen::Vector3i::Zero();
    result[axis] = sign_of_direction(direction) > 0;
    result[(axis + 1) % 3] = k == 1 || k == 2;
    result[(axis + 2) % 3] = k >= 2;
    return result;
  }
};

inline std::vector<std::pair<std::size_t, std::size_t> >
without_repetitions(std::vector<std::pair<std::size_t, std::size_t> > pairs)
{
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// Returns whether the pieces in each chart of the voxels as they are now are connected, and have the same neighbors as the charts.
// The pieces, one for each old face of the boundary, are given by the faces that they are in now.
inline bool are_neighbors_those_of_charts(const Charts_of_voxels_3& charts, const Voxel_faces_3& old_faces,
                                          const std::vector<std::size_t>& face_of_piece)
{
  const auto chart_of_piece = [&](const std::size_t piece) { return charts.chart_of_face[face_of_piece[piece]]; };
  std::vector<std::pair<std::size_t, std::size_t> > neighbors, neighbors_of_pieces;
  for(const std::size_t face : charts.faces)
    for_each_orthogonal_direction(direction_of_face(face), [&](const std::size_t e)
    {
      if(const std::size_t a = charts.chart_of_face[face], b = charts.chart_of_face[face_across(charts.voxels, face, e)]; a < b)
        neighbors.emplace_back(a, b);
    });
  Disjoint_sets sets(face_of_piece.size());
  for(const auto h : old_faces.mesh.halfedges())
  {
    const std::size_t piece = old_faces.mesh.face(h), other = old_faces.mesh.face(old_faces.mesh.opposite(h));
    if(const std::size_t a = chart_of_piece(piece), b = chart_of_piece(other); a == b)
      sets.unite(piece, other);
    else if(a < b)
      neighbors_of_pieces.emplace_back(a, b);
  }
  std::vector<std::size_t> number_of_parts(charts.labels.size(), 0);
  for(std::size_t piece = 0; piece < face_of_piece.size(); ++piece)
    number_of_parts[chart_of_piece(piece)] += sets.find(piece) == piece;
  return std::all_of(number_of_parts.begin(), number_of_parts.end(), [](const std::size_t n) { return n == 1; })
         && without_repetitions(std::move(neighbors)) == without_repetitions(std::move(neighbors_of_pieces));
}

// Returns the ends of the edge of a face in an orthogonal direction, as numbers of corners of all voxels in the box.
inline std::array<std::size_t, 2> points_of_edge(const Voxels_3& voxels, const std::size_t face, const std::size_t direction)
{
  const auto number = [&](const Eigen::Vector3i& p)
  { return static_cast<std::size_t>((p[2] * (voxels.size[1] + 1) + p[1]) * (voxels.size[0] + 1) + p[0]); };
  Eigen::Vector3i p = voxels.voxel(voxel_of_face(face));
  for(const std::size_t d : { direction_of_face(face), direction })
    p[axis_of_direction(d)] += sign_of_direction(d) > 0;
  const int along = 3 - axis_of_direction(direction_of_face(face)) - axis_of_direction(direction);
  return { number(p), number(p + Eigen::Vector3i::Unit(along)) };
}

// Returns the charts around each corner, a point where more than two edges of borders end; all in ascending order. The ends of
// these edges are pairs of a point and a chart, for both charts beside an edge.
inline std::vector<std::vector<std::size_t> > charts_at_corners(std::vector<std::pair<std::size_t, std::size_t> > ends)
{
  std::vector<std::vector<std::size_t> > result;
  std::sort(ends.begin(), ends.end());
  for(auto first = ends.begin(), last = first; first != ends.end(); first = last)
  {
    std::vector<std::size_t> charts;
    for(; last != ends.end() && last->first == first->first; ++last)
      charts.push_back(last->second);
    if(charts.size() > 2 * 2) // two charts of each edge
      result.push_back(std::move(charts));
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Returns whether the corners at which pieces of several charts meet are those of the charts of the voxels, with the same charts
// around each. Otherwise, an edge of the polycube would begin and end at one point.
inline bool are_corners_those_of_charts(const Charts_of_voxels_3& charts, const Voxel_faces_3& old_faces,
                                        const std::vector<std::size_t>& face_of_piece)
{
  std::vector<std::pair<std::size_t, std::size_t> > ends, ends_of_pieces;
  for(const std::size_t face : charts.faces)
    for_each_orthogonal_direction(direction_of_face(face), [&](const std::size_t e)
    {
      if(const std::size_t chart = charts.chart_of_face[face]; chart != charts.chart_of_face[face_across(charts.voxels, face, e)])
        for(const std::size_t p : points_of_edge(charts.voxels, face, e))
          ends.emplace_back(p, chart);
    });
  const Boundary_mesh_3& mesh = old_faces.mesh;
  const auto chart = [&](const auto h) { return charts.chart_of_face[face_of_piece[mesh.face(h)]]; };
  for(const auto h : mesh.halfedges())
    if(chart(h) != chart(mesh.opposite(h)))
      for(const std::size_t v : { mesh.source(h), mesh.target(h) })
        ends_of_pieces.emplace_back(v, chart(h));
  return charts_at_corners(std::move(ends)) == charts_at_corners(std::move(ends_of_pieces));
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VOXEL_FACES_3_H
