// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_PLACEMENT_OF_VOXEL_FACES_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_PLACEMENT_OF_VOXEL_FACES_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Unit_surface_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Voxel_faces_3.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits.h>

#include <array>
#include <limits>

namespace CGAL::Polycube_meshing_3::internal {

// Finds among points with normals the one nearest to another point and normal, by a tree in six dimensions.
class Nearest_with_normal_3
{
public:
  // Takes the distance that counts as much as 60 degrees between normals; 0 if normals do not count.
  explicit Nearest_with_normal_3(const double weight) : m_weight(weight) {}

  void add(const Vector_3& p, const Vector_3& normal) { m_tree.insert(point_6(p, normal, m_tree.size())); }

  // Returns the number of the nearest point, in the order in which points were added.
  std::size_t nearest(const Vector_3& p, const Vector_3& normal) const
  { return Search(m_tree, point_6(p, normal, 0), 1).begin()->first.number; }

private:
  struct Point_6
  {
    std::array<double, 6> coordinates;
    std::size_t number;
  };

  struct Coordinates
  {
    using result_type = const double*;
    const double* operator()(const Point_6& p) const { return p.coordinates.data(); }
    const double* operator()(const Point_6& p, int) const { return p.coordinates.data() + 6; }
  };

  using Search = Orthogonal_k_neighbor_search<Search_traits<double, Point_6, const double*, Coordinates, Dimension_tag<6> > >;

  Point_6 point_6(const Vector_3& p, const Vector_3& normal, const std::size_t number) const
  {
    const Vector_3 n = m_weight * normal;
    return { { p[0], p[1], p[2], n[0], n[1], n[2] }, number };
  }

  double m_weight;
  Search::Tree m_tree;
};

// Places the vertices of faces of voxels on a surface, by rounds of smoothing and projection to planes of facets that are near in
// position and normal.
class Placement_of_voxel_faces_3
{
public:
  Placement_of_voxel_faces_3(const Facets_3& facets, const double spacing)
    : m_facets(facets), m_spacing(spacing), m_nearest(1.5 * spacing), m_nearest_in_position(0) // 1.5 is a guess
  {
    for(std::size_t f = 0; f < facets.areas.size(); ++f)
    {
      m_nearest.add(facets.centers[f], facets.normals[f]);
      m_nearest_in_position.add(facets.centers[f], facets.normals[f]);
    }
  }

  // Returns the faces after the number of rounds that leaves the fewest faces folded. More rounds make the faces smoother, but let
  // faces slide off thin parts.
  Voxel_faces_3 run(const Voxel_faces_3& faces) const
  {
    constexpr int maximum_number_of_rounds = 40, first_rounds = 5; // guesses; the first ones go half of the way
    Voxel_faces_3 present = faces, best = faces;
    std::size_t fewest = (std::numeric_limits<std::size_t>::max)();
    for(int round = 0; round < maximum_number_of_rounds && fewest > 0; ++round)
    {
      if(round > 0)
        smooth(present);
      project(present, round < first_rounds ? 0.5 : 1);
      if(const std::size_t number = number_of_folded_faces(present); round > 0 && number < fewest)
      {
        fewest = number;
        best = present;
      }
    }
    return best;
  }

private:
  // Moves each vertex half of the way to the mean of its neighbors.
  static void smooth(Voxel_faces_3& faces)
  {
    Boundary_mesh_3& mesh = faces.mesh;
    std::vector<Vector_3> sums(mesh.number_of_vertices(), Vector_3::Zero());
    for(const auto h : mesh.halfedges())
      sums[mesh.source(h)] += faces.point(mesh.target(h));
    for(const auto v : mesh.vertices())
      mesh.point(v) = exact_point((faces.point(v) + sums[v] / mesh.degree(v)) / 2);
  }

  // Moves each vertex a part of the way to the plane of the facet that is nearest in position and normal. The target is at most
  // half a voxel from the center of the facet, because the plane may leave the surface.
  void project(Voxel_faces_3& faces, const double part) const
  {
    const std::vector<Vector_3> normals = faces.normals_of_vertices();
    for(const auto v : faces.mesh.vertices())
    {
      const Vector_3 p = faces.point(v);
      const std::size_t f = m_nearest.nearest(p, normals[v]);
      const Vector_3 &center = m_facets.centers[f], &normal = m_facets.normals[f];
      Vector_3 offset = p - (p - center).dot(normal) * normal - center;
      if(const double distance = offset.norm(); distance > m_spacing / 2)
        offset = m_spacing / 2 / distance * offset;
      faces.mesh.point(v) = exact_point(p + part * (center + offset - p));
    }
  }

  // Counts faces with a corner whose normal makes a right angle or more with that of the facet nearest to the center.
  std::size_t number_of_folded_faces(const Voxel_faces_3& faces) const
  {
    std::size_t result = 0;
    for(const auto face : faces.mesh.faces())
    {
      const auto vertices = faces.vertices(face);
      const auto point = [&](const std::size_t k) { return faces.point(vertices[k % 4]); };
      const std::size_t f
        = m_nearest_in_position.nearest((point(0) + point(1) + point(2) + point(3)) / 4, Vector_3::Zero());
      bool is_folded = false;
      for(std::size_t k = 0; k < 4; ++k)
        is_folded = is_folded
          || (point(k + 1) - point(k)).cross(point(k + 3) - point(k)).dot(m_facets.normals[f]) <= 0;
      result += is_folded;
    }
    return result;
  }

  const Facets_3& m_facets;
  double m_spacing;
  Nearest_with_normal_3 m_nearest, m_nearest_in_position;
};

// Returns for each facet the face of voxels, as an index in the mesh, that is nearest in position and normal.
inline std::vector<std::size_t> nearest_voxel_faces_3(const Facets_3& facets, const Voxel_faces_3& faces, const double spacing)
{
  constexpr std::size_t samples = 5; // along each edge; a guess
  Nearest_with_normal_3 nearest(spacing);
  const std::vector<Vector_3> points = points_of(faces.mesh), normals = faces.normals_of_vertices();
  for(const auto f : faces.mesh.faces())
    for(std::size_t i = 0; i < samples; ++i)
      for(std::size_t j = 0; j < samples; ++j)
      {
        const double u = (static_cast<double>(i) + 0.5) / samples, v = (static_cast<double>(j) + 0.5) / samples;
        const auto bilinear = [&](const std::vector<Vector_3>& values) -> Vector_3
        {
          const auto [a, b, c, d] = faces.vertices(f);
          return (1 - v) * ((1 - u) * values[a] + u * values[b]) + v * (u * values[c] + (1 - u) * values[d]);
        };
        nearest.add(bilinear(points), bilinear(normals).normalized());
      }
  std::vector<std::size_t> result;
  for(std::size_t f = 0; f < facets.areas.size(); ++f)
    result.push_back(nearest.nearest(facets.centers[f], facets.normals[f]) / (samples * samples));
  return result;
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_PLACEMENT_OF_VOXEL_FACES_3_H
