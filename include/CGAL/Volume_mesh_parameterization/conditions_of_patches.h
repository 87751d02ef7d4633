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

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/Vertex_map.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Prescribed_position_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/sharp_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Vector_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

The condition of the images of the vertices of a surface patch: they keep their positions, are
at targets, in a plane, or slide on a surface.
*/
class Patch_condition_3
{
public:
  /// returns the condition of vertices that keep their positions.
  static Patch_condition_3 in_place() { return Patch_condition_3(IN_PLACE); }

  /// returns the condition of vertices at targets: `target(p)` is that of a vertex at the point `p`.
  static Patch_condition_3 at(const std::function<std::array<double, 3>(const std::array<double, 3>&)>& target)
  {
    Patch_condition_3 result(AT_TARGETS);
    result.m_target = target;
    return result;
  }

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
    Patch_condition_3 result(IN_PLANE);
    result.m_normal = plane.direction();
    result.m_offset = offset;
    return result;
  }

  /// returns the condition of vertices that slide on a surface.
  static Patch_condition_3 on_surface(const Any_surface_3& surface)
  {
    Patch_condition_3 result(ON_SURFACE);
    result.m_surface = surface;
    return result;
  }

  /// returns the condition of vertices that slide on the patch as it is. Between two such patches, and along edges with more than
  /// 60 degrees between normals, they slide on curves.
  static Patch_condition_3 on_own_surface() { return Patch_condition_3(ON_OWN_SURFACE); }

#ifndef DOXYGEN_RUNNING
  // Each vertex has a plane of its own, through its start.
  static Patch_condition_3 in_plane_at_start(const std::array<double, 3>& normal)
  {
    Patch_condition_3 result = in_plane(normal[0], normal[1], normal[2], 0);
    result.m_offset.reset();
    return result;
  }

  bool is_on_own_surface() const { return m_kind == ON_OWN_SURFACE; }

  void add_to(internal::Prescribed_position_3& position, const std::size_t source) const
  {
    if(m_kind == IN_PLACE)
      position.add_start(source);
    else if(m_kind == AT_TARGETS)
      position.add_target(m_target(position.start()), source);
    else if(m_kind == IN_PLANE)
      position.add_plane(m_normal, m_offset, source);
    else if(m_kind == ON_SURFACE)
      position.add_surface(Vertex_condition_3::on_surface(*m_surface), source);
  }
#endif

private:
  enum Kind { IN_PLACE, AT_TARGETS, IN_PLANE, ON_SURFACE, ON_OWN_SURFACE };

  explicit Patch_condition_3(const Kind kind) : m_kind(kind) {}

  Kind m_kind;
  std::function<std::array<double, 3>(const std::array<double, 3>&)> m_target;
  std::array<double, 3> m_normal = {};
  std::optional<double> m_offset;
  std::optional<Any_surface_3> m_surface;
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

// Facets on which their vertices slide, each with the number of its group.
template <typename Vertex>
class Own_surface_3
{
public:
  void add_facet(const std::array<Vertex, 3>& facet, const std::size_t group)
  {
    m_facets.push_back({});
    for(int i = 0; i < 3; ++i)
      m_facets.back()[i] = m_indices.emplace(facet[i], m_indices.size()).first->second;
    m_groups.push_back(group);
  }

  // Adds to the prescribed position of each vertex that it slides, on behalf of the first of its groups. `point(v)` is its point.
  template <typename PointOf, typename PositionOf>
  void add_to(const PointOf& point, const PositionOf& position) const
  {
    if(m_facets.empty())
      return;
    std::vector<std::array<double, 3> > points(m_indices.size());
    std::vector<std::size_t> groups(points.size());
    for(const auto& [v, i] : m_indices)
      points[i] = point(v);
    for(std::size_t f = m_facets.size(); f-- > 0;)
      for(const std::size_t i : m_facets[f])
        groups[i] = m_groups[f];
    auto features = sharp_edges_3(m_facets, {}, [&](const std::size_t i) { return to_vector(points[i]); });
    for_each_edge(m_facets, [&](const auto begin, const auto end)
    {
      if(m_groups[begin->second[0] / 3] != m_groups[(end - 1)->second[0] / 3])
        features.push_back(begin->first);
    });
    const Triangulated_surface_3 surface(points, m_facets, features);
    for(const auto& [v, i] : m_indices)
      if(const Vertex_condition_3& condition = surface.condition(i); condition.is_sliding())
        position(v).add_surface(condition, groups[i]);
      else
        position(v).add_start(groups[i]);
  }

private:
  std::map<Vertex, std::size_t> m_indices;
  std::vector<std::array<std::size_t, 3> > m_facets;
  std::vector<std::size_t> m_groups;
};

// Finds what the vertices of patches may do. `for_each_facet(f)` calls `f(patch, vertices)` for each facet of a patch.
template <typename Vertex, typename Patch, typename ForEachFacet, typename PointOf>
std::map<Vertex, Prescribed_position_3::Solution> solutions_of_patches(const std::map<Patch, Patch_condition_3>& conditions,
                                                                       const double size, const ForEachFacet& for_each_facet,
                                                                       const PointOf& point)
{
  std::map<Vertex, std::set<std::size_t> > patches_of_vertices; // patches by their numbers in the conditions
  Own_surface_3<Vertex> own_surface;
  std::vector<bool> is_found(conditions.size(), false);
  for_each_facet([&](const Patch& patch, const auto& vertices)
  {
    const auto found = conditions.find(patch);
    if(found == conditions.end())
      return;
    const std::size_t number = static_cast<std::size_t>(std::distance(conditions.begin(), found));
    is_found[number] = true;
    for(const Vertex& v : vertices)
      patches_of_vertices[v].insert(number);
    if(found->second.is_on_own_surface())
      own_surface.add_facet(vertices, number);
  });
  const auto patch = [&](const std::size_t number) -> const auto&
  { return *std::next(conditions.begin(), static_cast<std::ptrdiff_t>(number)); };
  for(std::size_t number = 0; number < conditions.size(); ++number)
    if(!is_found[number])
      throw Input_error(sentence("No facet is of the patch ", patch(number).first, ", which has a condition."));

  std::map<Vertex, Prescribed_position_3> positions;
  for(const auto& [v, numbers] : patches_of_vertices)
    for(const std::size_t number : numbers)
      patch(number).second.add_to(positions.try_emplace(v, point(v), size).first->second, number);
  own_surface.add_to(point, [&](const Vertex& v) -> Prescribed_position_3& { return positions.at(v); });

  std::map<Vertex, Prescribed_position_3::Solution> result;
  for(const auto& [v, position] : positions)
  {
    const Prescribed_position_3::Solution solution = position.solution();
    if(!solution.fault.empty())
      throw Input_error(sentence("The conditions of the patches ",
        listed(solution.sources, [&](const std::size_t number) { return sentence(patch(number).first); }), " ", solution.fault,
        " at the vertex at ", describe(to_vector(point(v))), ": ", solution.reason, "."));
    result.emplace(v, solution);
  }
  return result;
}

// Returns the references of the groups of facets with a name: several groups may have it.
inline std::set<int> references_of_facets(const Tetrahedron_soup_3& soup, const std::string_view name)
{
  std::set<int> result;
  for(const auto& [dimension_and_reference, name_of_group] : soup.group_names)
    if(dimension_and_reference.first == 2 && name_of_group == name)
      result.insert(dimension_and_reference.second);
  return result;
}

// Returns the diagonal of the bounding box of the cells.
inline double diagonal_of_cells(const Tetrahedron_soup_3& soup)
{
  Box_3 box;
  for(const std::array<std::size_t, 4>& cell : soup.cells)
    for(const std::size_t v : cell)
      box.extend(to_vector(soup.points[v]));
  return box.is_empty() ? 0 : length_3(box.diagonal());
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns the conditions of the vertices of some surface patches of a complex. A vertex of several patches has the conditions of
all. Vertices of no such patch are free.

\tparam C3t3 a model of `MeshComplex_3InTriangulation_3`, whose surface patch index can be written to a stream

\param c3t3 the complex
\param conditions the condition of each patch, by its index

\return the conditions, to be passed by `make_vertex_condition_map()`, and the targets, by `make_vertex_point_map()`

A vertex of two surfaces, or of a surface and a plane, slides on the curve in which they intersect. A vertex of more of them is at
a point of all.

Throws `Input_error` if no facet is of a patch, or if a vertex cannot meet the conditions of all its patches. Planes must meet
within rounding, relative to the diagonal of the complex, and must not be nearly parallel, with an angle below 1e-9 radians. The
time is O(n log n) for n facets.
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
  { return internal::coordinates(internal::point_of_vertex(c3t3.triangulation(), v)); };
  internal::Box_3 box;
  for(auto it = c3t3.cells_in_complex_begin(); it != c3t3.cells_in_complex_end(); ++it)
    for(int i = 0; i < 4; ++i)
      box.extend(internal::to_vector(point(it->vertex(i))));
  for(const auto& [v, solution] : internal::solutions_of_patches<Vertex_handle>(conditions, internal::length_3(box.diagonal()),
                                                                                for_each_facet, point))
  {
    result.conditions[v] = solution.condition;
    result.targets.emplace(v, Point_3(solution.target[0], solution.target[1], solution.target[2]));
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
  const auto point = [&](const std::size_t v) { return soup.points[v]; };
  for(const auto& [v, solution] : internal::solutions_of_patches<std::size_t>(conditions, internal::diagonal_of_cells(soup),
                                                                              for_each_facet, point))
  {
    result.conditions[v] = solution.condition;
    result.targets[v] = solution.target;
  }
  return result;
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

does the same for groups of facets, by the names that a soup has for them. All groups with the name have the condition. Throws
`Input_error` if there is no group with a name.
*/
inline auto conditions_of_patches(const Tetrahedron_soup_3& soup, const std::map<std::string, Patch_condition_3>& conditions)
{
  std::map<int, Patch_condition_3> of_references;
  for(const auto& [name, condition] : conditions)
  {
    const std::set<int> references = internal::references_of_facets(soup, name);
    if(references.empty())
      throw Input_error("There is no group of facets with the name '" + name + "'.");
    for(const int reference : references)
      of_references.emplace(reference, condition);
  }
  return conditions_of_patches(soup, of_references);
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_CONDITIONS_OF_PATCHES_H
