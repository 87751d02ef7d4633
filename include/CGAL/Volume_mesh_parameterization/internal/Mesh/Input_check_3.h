// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_INPUT_CHECK_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_INPUT_CHECK_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/sentence.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// What is wrong with the input, with the data that make it concrete.
struct Input_check_3
{
  Error_code status = OK;
  std::string message;
  bool is_refinable = true; // could new vertices inside help?

  bool allows_fixed_boundary() const { return status == OK; }
  bool allows_soft_boundary() const { return status == OK || status == ERROR_PRESCRIBED_CELL_INVERTED; }
};

template <typename... Parts>
Input_check_3 failed_check(const Error_code status, const Parts&... parts)
{
  return { status, sentence(parts...), true };
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MESH_INPUT_CHECK_3_H
