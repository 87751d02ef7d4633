// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_IS_PROPERTY_MAP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_IS_PROPERTY_MAP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace CGAL::Volume_mesh_parameterization::internal {

// Tells what is no property map, and whether a map takes what is put into it, for errors of the compiler that can be
// read.
template <typename Map, typename = void>
struct Is_property_map : std::false_type {};

template <typename Map>
struct Is_property_map<Map, std::void_t<typename boost::property_traits<Map>::value_type> > : std::true_type {};

template <typename Map, typename Value, typename = void>
struct Can_hold : std::false_type {};

template <typename Map, typename Value>
struct Can_hold<Map, Value, std::void_t<typename boost::property_traits<Map>::value_type> >
  : std::is_convertible<Value, typename boost::property_traits<Map>::value_type>
{};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_IS_PROPERTY_MAP_H
