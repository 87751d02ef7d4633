// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_VERTEX_MAP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_VERTEX_MAP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Vertex_condition_3.h>

#include <boost/property_map/property_map.hpp>

#include <limits>
#include <stdexcept>
#include <type_traits>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

A property map from vertices to points or conditions over an associative container. Reading never changes the container. A missing
vertex is free, or has a point with coordinates that are not numbers. `CGAL::stretch_minimizing_volume_parameterization()` takes
this point for a missing target.

\tparam Container a model of `UniqueAssociativeContainer` and `PairAssociativeContainer`, for instance
        `std::unordered_map<C3t3::Vertex_handle, Point_3>`, with points or `Vertex_condition_3` as values; `const` if the map is
        only read

\cgalModels{ReadablePropertyMap}
\cgalModels{ReadWritePropertyMap} if `Container` is not `const`

\sa `make_vertex_point_map()`
\sa `make_vertex_condition_map()`
*/
template <typename Container>
class Vertex_map
{
public:
  using key_type = typename Container::key_type;      ///< the vertices
  using value_type = typename Container::mapped_type; ///< the points or conditions
  using reference = value_type;                       ///< they are returned by value
  /// the concept of the map, for Boost
  using category = std::conditional_t<std::is_const<Container>::value, boost::readable_property_map_tag,
                                      boost::read_write_property_map_tag>;

  /// stores a reference to the container, which must outlive the map.
  explicit Vertex_map(Container& container) : m_container(&container) {}

  /// returns the value of a vertex. A missing vertex is free, or has a point with coordinates that are not numbers. If the type of
  /// the coordinates has no such value, as in exact kernels, `std::out_of_range` is thrown instead.
  friend value_type get(const Vertex_map& map, const key_type& vertex)
  {
    const auto found = map.m_container->find(vertex);
    if(found != map.m_container->end())
      return found->second;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if constexpr(std::is_same<value_type, Vertex_condition_3>::value)
      return Vertex_condition_3::free();
    else if constexpr(std::is_floating_point<std::decay_t<decltype(found->second.x())> >::value)
      return value_type(nan, nan, nan);
    else
      throw std::out_of_range("A vertex has no point in the container.");
  }

  /// puts a value into the container.
  friend void put(const Vertex_map& map, const key_type& vertex, const value_type& value)
  { (*map.m_container)[vertex] = value; }

private:
  Container* m_container;
};

/// \ingroup PkgVolumeMeshParameterizationFunctions
///
/// returns the property map over a container of points.
template <typename Container>
Vertex_map<Container> make_vertex_point_map(Container& container) { return Vertex_map<Container>(container); }

/// \ingroup PkgVolumeMeshParameterizationFunctions
///
/// returns the property map over a container of conditions.
template <typename Container>
Vertex_map<Container> make_vertex_condition_map(Container& container) { return Vertex_map<Container>(container); }

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_VERTEX_MAP_H
