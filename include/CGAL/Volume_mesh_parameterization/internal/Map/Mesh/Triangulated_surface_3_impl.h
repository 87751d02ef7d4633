// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_TRIANGULATED_SURFACE_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_TRIANGULATED_SURFACE_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/AABB_trees_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <map>

namespace CGAL::Volume_mesh_parameterization {

namespace internal {

inline Vector_3 nearest_point(const AABB_trees_3::Kernel::Segment_3& segment, const Vector_3& p)
{
  const Vector_3 a = to_vector(segment[0]), b = to_vector(segment[1]), d = b - a;
  const double t = d.dot(p - a) / d.squaredNorm();
  return t >= 1 ? b : t > 0 ? a + t * d : a;
}

// Combines the vertices with weights in [0, 1]. Therefore, the point is on the triangle within rounding, whatever its shape is.
inline Vector_3 nearest_point(const AABB_trees_3::Kernel::Triangle_3& triangle, const Vector_3& p)
{
  const Vector_3 a = to_vector(triangle[0]), u = to_vector(triangle[1]) - a, v = to_vector(triangle[2]) - a;
  const Vector_3 n = u.cross(v);
  const double s = n.dot((p - a).cross(v)) / n.squaredNorm(), t = n.dot(u.cross(p - a)) / n.squaredNorm();
  if(s >= 0 && t >= 0 && s + t <= 1)
    return a + (s * u + t * v);
  Vector_3 nearest = a;
  for(int i = 0; i < 3; ++i)
  {
    const Vector_3 q = nearest_point(AABB_trees_3::Kernel::Segment_3(triangle[i], triangle[i + 1]), p);
    if(i == 0 || (q - p).squaredNorm() < (nearest - p).squaredNorm())
      nearest = q;
  }
  return nearest;
}

inline Vector_3 direction_of(const AABB_trees_3::Kernel::Segment_3& segment) { return to_vector(segment.to_vector()); }

inline Vector_3 direction_of(const AABB_trees_3::Kernel::Triangle_3& triangle)
{ return to_vector(triangle[1] - triangle[0]).cross(to_vector(triangle[2] - triangle[0])); }

inline Vector_3 scaled(const Vector_3& p, const int exponent)
{ return p.unaryExpr([&](const double x) { return std::scalbn(x, exponent); }); }

// Triangles or segments with their tree, with coordinates that were divided by a power of two, so that none overflows.
template <typename Tree, typename Simplex>
class Simplices_with_tree_3
{
public:
  Simplices_with_tree_3(std::vector<Simplex> simplices, const int exponent)
    : m_simplices(std::make_shared<const std::vector<Simplex> >(std::move(simplices))), m_exponent(exponent)
  {
    auto tree = std::make_shared<Tree>(m_simplices->begin(), m_simplices->end());
    tree->build();
    tree->accelerate_distance_queries();
    m_tree = std::move(tree);
  }

  Surface_point_3 nearest_point(const std::array<double, 3>& p) const
  {
    constexpr double far_away = 1e50; // where the tree still works; in the unit of the surface
    const Vector_3 q_scaled = scaled({ p[0], p[1], p[2] }, -m_exponent);
    if(!(q_scaled.cwiseAbs().maxCoeff() < far_away) || q_scaled.hasNaN())
      return { p, {} };
    const Simplex& simplex = *m_tree->closest_point_and_primitive(exact_point(q_scaled)).second;
    Box_3 box;
    for(int i = 0; i < simplex_size; ++i)
      box.extend(to_vector(simplex[i]));
    // a coordinate that all vertices have is met to the bit
    const Vector_3 nearest = internal::nearest_point(simplex, q_scaled).cwiseMax(box.smallest).cwiseMin(box.largest);
    const bool is_on_simplex = (nearest - q_scaled).cwiseAbs().maxCoeff() <= rounding;
    return { coordinates(scaled(nearest, m_exponent)), coordinates(direction_at(is_on_simplex ? q_scaled : nearest, simplex)) };
  }

private:
  static constexpr double rounding = 1e-14; // a guess; far above errors of coordinates below 2

  // A traversal of the tree that adds the unit normals of all triangles at a point.
  struct Sum_of_normals
  {
    const Vector_3& p;
    Vector_3 sum = Vector_3::Zero();

    bool go_further() const { return true; }

    template <typename Node>
    bool do_intersect(const Bbox_3& box, const Node& node) const { return CGAL::do_overlap(box, node.bbox()); }

    void intersection(const Bbox_3&, const typename Tree::Primitive& triangle)
    {
      if((internal::nearest_point(*triangle.id(), p) - p).cwiseAbs().maxCoeff() <= rounding)
        sum += unit_vector_3(direction_of(*triangle.id()));
    }
  };

  // Returns the tangent of a segment, or the sum of the unit normals of all triangles at a point: rounding decides which of them
  // is found to be the nearest.
  Vector_3 direction_at(const Vector_3& p, const Simplex& nearest) const
  {
    Sum_of_normals normals{ p };
    if(simplex_size == 3)
      m_tree->traversal(Bbox_3(p[0] - rounding, p[1] - rounding, p[2] - rounding,
                               p[0] + rounding, p[1] + rounding, p[2] + rounding), normals);
    return normals.sum.norm() > rounding ? normals.sum : direction_of(nearest);
  }

  static constexpr int simplex_size = std::is_same_v<Simplex, AABB_trees_3::Kernel::Segment_3> ? 2 : 3;

  std::shared_ptr<const std::vector<Simplex> > m_simplices;
  std::shared_ptr<const Tree> m_tree;
  int m_exponent;
};

using Segments_with_tree_3 = Simplices_with_tree_3<AABB_trees_3::Of_segments, AABB_trees_3::Kernel::Segment_3>;
using Triangles_with_tree_3 = Simplices_with_tree_3<AABB_trees_3::Of_triangles, AABB_trees_3::Kernel::Triangle_3>;

inline void check_surface(const std::vector<std::array<double, 3> >& points,
                          const std::vector<std::array<std::size_t, 3> >& triangles,
                          const std::vector<std::array<std::size_t, 2> >& features)
{
  const auto check = [&](const auto& simplices, const char* const name)
  {
    for(const auto& simplex : simplices)
      for(const std::size_t v : simplex)
        if(v >= points.size())
          throw Input_error(sentence("A ", name, " of a surface has the point ", v, ", but there are ", points.size(), "."));
        else if(!is_finite_point(exact_point(points[v])))
          throw Input_error(sentence("The point ", v, " of a surface has a coordinate that is not finite."));
  };
  check(triangles, "triangle");
  check(features, "feature edge");
}

// Builds a tree for the simplices of each number.
template <typename Tree, typename Simplex>
std::vector<Any_surface_3> trees_of_groups(const std::vector<Simplex>& simplices, const std::vector<std::size_t>& numbers,
                                           const int exponent)
{
  std::vector<std::vector<Simplex> > groups;
  for(std::size_t i = 0; i < simplices.size(); ++i)
  {
    groups.resize((std::max)(groups.size(), numbers[i] + 1));
    groups[numbers[i]].push_back(simplices[i]);
  }
  std::vector<Any_surface_3> result;
  for(const std::vector<Simplex>& group : groups)
    result.emplace_back(Tree(group, exponent));
  return result;
}

} // namespace internal

CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Triangulated_surface_3::Triangulated_surface_3(const std::vector<std::array<double, 3> >& points,
                                               std::vector<std::array<std::size_t, 3> > triangles,
                                               const std::vector<std::array<std::size_t, 2> >& features)
  : m_conditions(points.size(), Vertex_condition_3::at_target())
{
  using namespace internal;
  check_surface(points, triangles, features);
  double largest = 0; // coordinate
  for(const std::array<double, 3>& p : points)
    if(is_finite_point(exact_point(p)))
      largest = (std::max)(largest, to_vector(p).cwiseAbs().maxCoeff());
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  const auto point = [&](const std::size_t v) { return exact_point(scaled(to_vector(points[v]), -exponent)); };
  std::vector<AABB_trees_3::Kernel::Triangle_3> in_space;
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), [&](const auto& t)
  {
    constexpr double smallest = 1e-280; // squared length of a normal by which the tree can divide
    const AABB_trees_3::Kernel::Triangle_3 triangle(point(t[0]), point(t[1]), point(t[2]));
    const bool has_area = direction_of(triangle).squaredNorm() > smallest;
    if(has_area)
      in_space.push_back(triangle);
    return !has_area;
  }), triangles.end());
  if(triangles.empty())
    throw Input_error("No triangle of a surface has an area.");

  const auto marked = sharp_edges_3(triangles, features, [&](const std::size_t v) { return to_vector(points[v]); });
  std::vector<std::array<std::size_t, 2> > edges;
  for_each_edge(triangles, [&](const auto begin, const auto end)
  {
    if(end - begin > 2 || std::binary_search(marked.begin(), marked.end(), begin->first))
      edges.push_back(begin->first);
  });
  const std::vector<std::size_t> patches = patches_of_facets(triangles, edges);
  m_patches = trees_of_groups<Triangles_with_tree_3>(in_space, patches, exponent);
  m_surface = m_patches.size() == 1 ? m_patches : std::vector{ Any_surface_3(Triangles_with_tree_3(in_space, exponent)) };

  const Neighbors_along_edges neighbors = neighbors_along_edges(edges);
  const std::set<std::size_t> corners
    = corners_of_curves(neighbors, [&](const std::size_t v) { return to_vector(points[v]); });
  const std::vector<std::vector<std::size_t> > curves = curves_along_edges(neighbors, corners);
  std::vector<AABB_trees_3::Kernel::Segment_3> segments;
  std::vector<std::size_t> curves_of_segments;
  for(std::size_t c = 0; c < curves.size(); ++c)
    for(std::size_t i = 1; i < curves[c].size(); ++i)
    {
      segments.emplace_back(point(curves[c][i - 1]), point(curves[c][i]));
      curves_of_segments.push_back(c);
    }
  m_curves = trees_of_groups<Segments_with_tree_3>(segments, curves_of_segments, exponent);

  std::map<std::size_t, std::set<std::size_t> > patches_of_points;
  for(std::size_t t = 0; t < triangles.size(); ++t)
    for(const std::size_t v : triangles[t])
      patches_of_points[v].insert(patches[t]);
  for(const auto& [v, around] : patches_of_points)
    if(around.size() == 1) // even at the end of a curve inside of it: that vertex is a corner below
      m_conditions[v] = Vertex_condition_3::on_surface(m_patches[*around.begin()]);
  for(std::size_t c = 0; c < curves.size(); ++c)
    for(const std::size_t v : curves[c])
      m_conditions[v] = corners.count(v) > 0 ? Vertex_condition_3::at_target() : Vertex_condition_3::on_curve(m_curves[c]);
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_TRIANGULATED_SURFACE_3_IMPL_H
