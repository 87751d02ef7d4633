// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_LIMITS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_LIMITS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>
#include <CGAL/Volume_mesh_parameterization/internal/Budget.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

namespace CGAL::Volume_mesh_parameterization::internal {

// The type for a named parameter that will be modified: a copy of what was passed by value, a
// reference to what was passed by std::ref().
template <typename Reference>
using Mutable_parameter = std::conditional_t<
  std::is_const<std::remove_reference_t<Reference> >::value,
  std::remove_const_t<std::remove_reference_t<Reference> >,
  Reference>;

template <typename Visitor, typename = void>
struct Has_goes_on : std::false_type {};

template <typename Visitor>
struct Has_goes_on<Visitor, std::void_t<decltype(std::declval<Visitor&>().goes_on())> > : std::true_type {};

// The named parameters `visitor` and `maximum_running_time`, which end a computation early.
template <typename NamedParameters>
class Limits
{
public:
  explicit Limits(const NamedParameters& np)
    : m_visitor(parameters::choose_parameter(parameters::get_parameter_reference(np, internal_np::visitor), m_default)),
      m_seconds(parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_running_time),
                                             (std::numeric_limits<double>::infinity)()))
  {}

  Limits(const Limits&) = delete;
  Limits& operator=(const Limits&) = delete;

  auto& visitor() { return m_visitor; }
  double seconds() const { return m_seconds; }

  // Begins now. A visitor need not have the function `goes_on()`.
  Budget budget()
  {
    return Budget(m_seconds, [this]
    {
      if constexpr(Has_goes_on<std::remove_reference_t<Visitor> >::value)
        return m_visitor.goes_on();
      else
        return true;
    });
  }

private:
  using Visitor = Mutable_parameter<typename internal_np::Lookup_named_param_def<
    internal_np::visitor_t, NamedParameters, Default_visitor>::reference>;

  Default_visitor m_default;
  Visitor m_visitor;
  double m_seconds;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_LIMITS_H
