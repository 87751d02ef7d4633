// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_MUTABLE_PARAMETER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_MUTABLE_PARAMETER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <type_traits>

namespace CGAL::Volume_mesh_parameterization::internal {

// The type for a named parameter that will be modified: a copy of what was passed by value, a
// reference to what was passed by std::ref().
template <typename Reference>
using Mutable_parameter = std::conditional_t<
  std::is_const<std::remove_reference_t<Reference> >::value,
  std::remove_const_t<std::remove_reference_t<Reference> >,
  Reference>;

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_MUTABLE_PARAMETER_H
