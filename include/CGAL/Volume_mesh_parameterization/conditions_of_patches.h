// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_CONDITIONS_OF_PATCHES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_CONDITIONS_OF_PATCHES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/projector_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <limits>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

The condition of the images of the vertices of a surface patch: they keep their positions, or are in a plane.
*/
class Patch_condition_3
{
public:
  /// returns the condition of vertices that keep their positions.
  static Patch_condition_3 in_place() { return Patch_condition_3(); }

  /// returns the condition of vertices with the coordinate `value` along an axis, 0 for x, 1 for y, 2 for z.
  /// \pre The axis is 0, 1 or 2, and the value is finite.
  static Patch_condition_3 coordinate(const int axis, const double value)
  { return in_plane(axis == 0, axis == 1, axis == 2, value); }

  /// returns the condition of vertices in the plane of the points whose scalar product with the normal (x, y, z) is `offset`.
  /// \pre All numbers are finite, and the normal is not zero.
  static Patch_condition_3 in_plane(const double x, const double y, const double z, const double offset)
  {
    const Vertex_condition_3 plane = Vertex_condition_3::in_plane(x, y, z); // with the checks
    internal::require(std::isfinite(offset), "The offset of a plane must be finite.");
    Patch_condition_3 result;
    result.m_is_in_place = false;
    result.m_normal = plane.direction();
    result.m_offset = offset;
    return result;
  }

#ifndef DOXYGEN_RUNNING
  bool is_in_place() const { return m_is_in_place; }
  const std::array<double, 3>& normal() const { return m_normal; }
  double offset() const { return m_offset; }
#endif

private:
  Patch_condition_3() = default;

  bool m_is_in_place = true;
  std::array<double, 3> m_normal = {};
  double m_offset = 0;
};

/*!
\ingroup PkgVolumeMeshParameterizationResults

The conditions of the vertices of some patches, for `vertex_condition_map`, with the targets to which they refer.

\tparam Conditions a container of `Vertex_condition_3` by vertices
\tparam Targets a container of points by vertices
*/
template <typename Conditions, typename Targets>
struct Conditions_and_targets_3
{
  Conditions conditions; ///< the condition of each vertex; a vertex without an entry is free
  Targets targets;       ///< the target of each vertex that is not free
};

namespace internal {

// The positions that the planes of several patches leave to a vertex: a point, and a projector onto the directions around it.
class Common_position_3
{
public:
  explicit Common_position_3(const Eigen::Vector3d& point) : m_start(point), m_point(point) {}

  void add(const Patch_condition_3& condition)
  {
    if(condition.is_in_place())
      for(int i = 0; i < 3; ++i)
        add_plane(Eigen::Vector3d::Unit(i), m_start[i]);
    else
    {
      const Eigen::Vector3d n = Eigen::Vector3d(condition.normal().data());
      add_plane(unit_vector_3(n), condition.offset() / length_3(n));
    }
  }

  // Throws if the plane has no point in common with the others.
  void add_plane(const Eigen::Vector3d& n, const double offset)
  {
    constexpr double rounding = 1e-9; // of angles and, relative to the coordinates, of distances
    const Eigen::Vector3d free_part = m_projector * n;
    const double distance = offset - n.dot(m_point);
    if(free_part.norm() > rounding)
    {
      m_point += free_part * (distance / free_part.dot(n));
      const Eigen::Vector3d d = unit_vector_3(free_part);
      m_projector = ++m_rank == 3 ? Eigen::Matrix3d(Eigen::Matrix3d::Zero()) : Eigen::Matrix3d(m_projector - d * d.transpose());
      for(int i = 0; i < 3; ++i)
        if(std::abs(n[i]) == 1)
          m_point[i] = n[i] * offset; // to the bit
    }
    else if(std::abs(distance) > rounding * (std::abs(offset) + m_point.norm()))
      throw Input_error(sentence("The conditions of the patches of the vertex at ", describe(m_start), " contradict each other, "
                                 "because no point meets all of them."));
  }

  const Eigen::Vector3d& start() const { return m_start; }
  const Eigen::Vector3d& point() const { return m_point; }

  Vertex_condition_3 condition() const
  {
    const Eigen::Matrix3d Q = Eigen::Matrix3d::Identity() - m_projector;
    const Eigen::Matrix3d& M = m_rank == 1 ? Q : m_projector; // of the normal of a plane, or of the direction of a line
    int k;
    M.colwise().norm().maxCoeff(&k);
    const Eigen::Vector3d d = M.col(k);
    return m_rank == 0 ? Vertex_condition_3() : m_rank == 1 ? Vertex_condition_3::in_plane(d[0], d[1], d[2])
         : m_rank == 2 ? Vertex_condition_3::on_line(d[0], d[1], d[2]) : Vertex_condition_3::at_target();
  }

private:
  Eigen::Vector3d m_start, m_point;
  Eigen::Matrix3d m_projector = Eigen::Matrix3d::Identity();
  int m_rank = 0; // of the planes
};

// Finds the positions of the vertices of patches. `for_each_facet(f)` calls `f(patch, vertices)` for each facet of a patch.
template <typename Vertex, typename Patch, typename ForEachFacet, typename PointOf>
std::unordered_map<Vertex, Common_position_3> positions_of_patches(const std::map<Patch, Patch_condition_3>& conditions,
                                                             const ForEachFacet& for_each_facet, const PointOf& point)
{
  std::map<Vertex, std::map<Patch, const Patch_condition_3*> > patches; // of each vertex
  std::map<Patch, bool> is_found;
  for_each_facet([&](const Patch& patch, const auto& vertices)
  {
    const auto found = conditions.find(patch);
    if(found == conditions.end())
      return;
    is_found[patch] = true;
    for(const Vertex& v : vertices)
      patches[v].emplace(patch, &found->second);
  });
  for(const auto& [patch, condition] : conditions)
    if(!is_found[patch])
      throw Input_error(sentence("No facet is of the patch ", patch, ", which has a condition."));
  std::unordered_map<Vertex, Common_position_3> result;
  for(const auto& [v, conditions_of_vertex] : patches)
  {
    Common_position_3& position = result.emplace(v, Common_position_3(point(v))).first->second;
    for(const auto& [patch, condition] : conditions_of_vertex)
      position.add(*condition);
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns the conditions of the vertices of some surface patches of a complex. A vertex of several patches has the conditions of
all. Vertices of no such patch are free.

\tparam C3t3 a model of `MeshComplex_3InTriangulation_3`, whose surface patch index can be written to a stream

\param c3t3 the complex
\param conditions the condition of each patch, by its index

\return the conditions, to be passed by `boost::make_assoc_property_map()`, and the targets, by `make_vertex_point_map()`

Throws `Input_error` if a vertex cannot meet the conditions of all its patches, with its coordinates, or if no facet is of a
patch. The time is O(n log n) for n facets.
*/
template <typename C3t3, typename = typename C3t3::Triangulation>
auto conditions_of_patches(const C3t3& c3t3, const std::map<typename C3t3::Surface_patch_index, Patch_condition_3>& conditions)
{
  using Vertex_handle = typename C3t3::Vertex_handle;
  using Point_3 = typename C3t3::Triangulation::Geom_traits::Point_3;
  Conditions_and_targets_3<std::unordered_map<Vertex_handle, Vertex_condition_3>,
                           std::unordered_map<Vertex_handle, Point_3> > result;
  const auto for_each_facet = [&](const auto& f)
  {
    for(auto it = c3t3.facets_in_complex_begin(); it != c3t3.facets_in_complex_end(); ++it)
    {
      std::array<Vertex_handle, 3> vertices;
      for(int i = 0; i < 3; ++i)
        vertices[i] = it->first->vertex((it->second + 1 + i) % 4);
      f(c3t3.surface_patch_index(*it), vertices);
    }
  };
  const auto point = [&](const Vertex_handle v)
  { return internal::to_vector(internal::point_of_vertex(c3t3.triangulation(), v)); };
  for(const auto& [v, position] : internal::positions_of_patches<Vertex_handle>(conditions, for_each_facet, point))
  {
    result.conditions[v] = position.condition();
    result.targets.emplace(v, Point_3(position.point()[0], position.point()[1], position.point()[2]));
  }
  return result;
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns the conditions of the points of marked facets of a soup, by their references. The arrays have an element for each
point: points of no such facet are free, and their targets are no numbers.
*/
inline auto conditions_of_patches(const Tetrahedron_soup_3& soup, const std::map<int, Patch_condition_3>& conditions)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Conditions_and_targets_3<std::vector<Vertex_condition_3>, std::vector<std::array<double, 3> > > result;
  result.conditions.resize(soup.points.size());
  result.targets.resize(soup.points.size(), { nan, nan, nan });
  const auto for_each_facet = [&](const auto& f)
  {
    for(std::size_t i = 0; i < soup.facets.size(); ++i)
      f(soup.facet_references[i], soup.facets[i]);
  };
  const auto point = [&](const std::size_t v) { return internal::to_vector(soup.points[v]); };
  for(const auto& [v, position] : internal::positions_of_patches<std::size_t>(conditions, for_each_facet, point))
  {
    result.conditions[v] = position.condition();
    result.targets[v] = internal::coordinates(position.point());
  }
  return result;
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

does the same for groups of facets, by the names that a soup has for them. Throws `Input_error` if there is no group with a name.
*/
inline auto conditions_of_patches(const Tetrahedron_soup_3& soup, const std::map<std::string, Patch_condition_3>& conditions)
{
  std::map<int, Patch_condition_3> of_references;
  for(const auto& condition : conditions)
  {
    const auto group = std::find_if(soup.group_names.begin(), soup.group_names.end(), [&](const auto& entry)
    { return entry.first.first == 2 && entry.second == condition.first; });
    if(group == soup.group_names.end())
      throw Input_error("There is no group of facets with the name '" + condition.first + "'.");
    of_references.emplace(group->first.second, condition.second);
  }
  return conditions_of_patches(soup, of_references);
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_CONDITIONS_OF_PATCHES_H
