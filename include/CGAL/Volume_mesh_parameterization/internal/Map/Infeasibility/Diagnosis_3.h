// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_INFEASIBILITY_DIAGNOSIS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_INFEASIBILITY_DIAGNOSIS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Why no map was found with fixed boundary.
struct Diagnosis_3
{
  std::vector<std::size_t> inverted_cells;
  std::size_t number_of_proofs = 0; // that there is none
  std::string message;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_INFEASIBILITY_DIAGNOSIS_3_H
