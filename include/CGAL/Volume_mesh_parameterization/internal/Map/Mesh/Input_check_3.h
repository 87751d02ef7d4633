// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_INPUT_CHECK_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_INPUT_CHECK_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Blames the surface, and not the map.
constexpr const char* fault_of_surface
  = "The surface or curve itself puts no point there: Newton's method diverges, or a value or slope is not finite.";

// Completes advice to refine by what compiles: constant complexes and arrays cannot be refined.
constexpr const char* way_to_refine = "refinement_mode(Refinement_mode::HELPFUL), for a mesh that is not constant";

// The fault of an input, with the data that make it concrete; OK if there is none.
struct Input_check_3
{
  Error_code status = OK;
  std::string message;
  bool is_refinable = true; // could new vertices inside help?

  bool allows_fixed_boundary() const { return status == OK; }
  bool allows_soft_boundary() const { return status == OK || status == ERROR_PRESCRIBED_CELL_INVERTED; }
  bool allows(const Boundary_mode mode) const
  { return allows_fixed_boundary() || (allows_soft_boundary() && mode != Boundary_mode::FIXED); }
};

template <typename... Parts>
Input_check_3 failed_check(const Error_code status, const Parts&... parts) { return { status, sentence(parts...), true }; }

// Bounds of the diagonal. If all points coincide, it is 0, and the input is refused. The volume of a cell is a product of three
// lengths, and energies have their fourth powers.
inline Input_check_3 check_size(const Box_3& box, const char* const name)
{
  constexpr double smallest = 1e-70, largest = 1e70;
  const double diagonal = box.is_empty() ? 0 : length_3(box.diagonal());
  if(diagonal == 0 || (smallest <= diagonal && diagonal <= largest))
    return {};
  return failed_check(ERROR_SIZE_OUT_OF_RANGE, "The bounding box of the ", name, " has the diagonal ", diagonal,
                      ", which is not between ", smallest, " and ", largest, ".");
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_INPUT_CHECK_3_H
