// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_ARGUMENTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_ARGUMENTS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>
#include <boost/type_traits/detected.hpp>
#include <boost/type_traits/detected_or.hpp>
#include <boost/type_traits/is_detected.hpp>

#include <type_traits>

// Checks of arguments, so that the compiler answers mistakes in calls with one sentence. Models of concepts are checked by
// expressions that call them.
namespace CGAL::Volume_mesh_parameterization::internal {

template <typename T, typename = void>
struct Is_complex : std::false_type {};

template <typename T>
struct Is_complex<T, std::void_t<typename T::Triangulation, typename T::Subdomain_index> > : std::true_type {};

template <typename Triangulation>
using Periodic_tag_of = typename Triangulation::Periodic_tag;

template <typename Triangulation>
constexpr bool is_periodic = boost::detected_or_t<Tag_false, Periodic_tag_of, Triangulation>::value;

// True for property maps with these keys; a map whose key type is void takes any.
template <typename Map>
using Key_of = typename boost::property_traits<Map>::key_type;

template <typename Map, typename Key, typename Key_of_map = boost::detected_t<Key_of, Map> >
using Is_map_of = std::disjunction<std::is_convertible<Key, Key_of_map>, std::is_void<Key_of_map> >;

template <typename Map>
using Value_of = typename boost::property_traits<Map>::value_type;

template <typename Map, typename Value>
using Can_hold = std::is_convertible<Value, boost::detected_t<Value_of, Map> >;

template <typename Visitor>
using Answer_of_visitor = decltype(std::declval<Visitor&>().after_step(std::declval<const Parameterization_step&>()));

template <typename Visitor>
using Is_visitor = std::is_convertible<boost::detected_t<Answer_of_visitor, Visitor>, bool>;

template <typename Tag, bool is_known>
struct Named_parameter
{
  static_assert(is_known, "A named parameter is passed that this function does not know: see the type of Named_parameter.");
};

// Returns the named parameter, or the default if none was passed.
template <typename NamedParameters, typename Tag, typename Otherwise>
auto parameter_or(const NamedParameters& np, const Tag tag, const Otherwise& otherwise)
{ return parameters::choose_parameter(parameters::get_parameter(np, tag), otherwise); }

// Refuses named parameters that a function does not read: all but `Tags` and the limits that all functions read.
template <typename... Tags, typename T, typename Tag, typename Base>
constexpr void check_named_parameters(const Named_function_parameters<T, Tag, Base>& np)
{
  constexpr bool is_limit = std::is_same<Tag, internal_np::visitor_t>::value
                            || std::is_same<Tag, internal_np::maximum_running_time_t>::value;
  Named_parameter<Tag, (std::is_same<Tag, Tags>::value || ... || is_limit)
                       || std::is_same<Tag, internal_np::all_default_t>::value>();
  if constexpr(!std::is_same<Base, internal_np::No_property>::value)
    check_named_parameters<Tags...>(static_cast<const Base&>(np));
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_ARGUMENTS_H
