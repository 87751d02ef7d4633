// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

// Puts the named parameters of this package in front of CGAL's list, by standing in for CGAL's header of the same name.
// There is no guard: CGAL reads the list several times, each time with another meaning of CGAL_add_named_parameter.

#ifdef __GNUC__
#  pragma GCC system_header // #include_next is an extension, which -pedantic would report
#endif

// Shows the public headers that this file was found before CGAL's.
#define CGAL_VOLUME_MESH_PARAMETERIZATION_NAMED_PARAMETERS

// List of named parameters used in Volume_mesh_parameterization
CGAL_add_named_parameter(energy_t, energy, energy)
CGAL_add_named_parameter(boundary_map_t, boundary_map, boundary_map)
CGAL_add_named_parameter(boundary_mode_t, boundary_mode, boundary_mode)
CGAL_add_named_parameter(boundary_parameterizer_t, boundary_parameterizer, boundary_parameterizer)
CGAL_add_named_parameter(do_slide_boundary_t, do_slide_boundary, do_slide_boundary)
CGAL_add_named_parameter(energy_tolerance_t, energy_tolerance, energy_tolerance)
CGAL_add_named_parameter(initial_map_t, initial_map, initial_map)
CGAL_add_named_parameter(maximum_angle_distortion_t, maximum_angle_distortion, maximum_angle_distortion)
CGAL_add_named_parameter(do_keep_interfaces_t, do_keep_interfaces, do_keep_interfaces)
CGAL_add_named_parameter(minimum_scaled_jacobian_t, minimum_scaled_jacobian, minimum_scaled_jacobian)
CGAL_add_named_parameter(positional_constraints_t, positional_constraints, positional_constraints)
CGAL_add_named_parameter(reference_scale_t, reference_scale, reference_scale)
CGAL_add_named_parameter(refinement_mode_t, refinement_mode, refinement_mode)
CGAL_add_named_parameter(soft_boundary_parameters_t, soft_boundary_parameters, soft_boundary_parameters)
CGAL_add_named_parameter(solver_traits_t, solver_traits, solver_traits)
CGAL_add_named_parameter(use_regular_references_t, use_regular_references, use_regular_references)
CGAL_add_named_parameter(use_volume_weights_t, use_volume_weights, use_volume_weights)
CGAL_add_named_parameter(vertex_condition_t, vertex_condition_map, vertex_condition_map)

// CGAL's own file comes last: since CGAL 6 it undefines CGAL_add_named_parameter. Compilers without extensions find it by
// a header that CMake writes.
#if defined(__GNUC__) && !defined(CGAL_VOLUME_MESH_PARAMETERIZATION_NO_EXTENSIONS)
#  include_next <CGAL/STL_Extension/internal/parameters_interface.h>
#else
#  include <CGAL_parameters_interface.h>
#endif
