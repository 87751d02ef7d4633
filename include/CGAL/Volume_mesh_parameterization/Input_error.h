// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INPUT_ERROR_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INPUT_ERROR_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <stdexcept>

namespace CGAL::Volume_mesh_parameterization {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// The exception of the functions that read files and of `tetrahedron_soup_to_mesh_complex_3()`;
/// `what()` is one sentence that says where the input is wrong and how.
class Input_error
  : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INPUT_ERROR_H
