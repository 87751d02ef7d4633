// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_CHECK_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_CHECK_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/to_vector.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Input_check_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/sentence.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Has the map a cell, and only finite coordinates at the vertices of cells?
inline Input_check_3 check_map_3(const std::vector<std::array<double, 3> >& points,
                                 const std::vector<std::array<std::size_t, 4> >& cells,
                                 const std::vector<std::array<double, 3> >& images)
{
  if(cells.empty())
    return failed_check(ERROR_EMPTY_COMPLEX, get_error_message(ERROR_EMPTY_COMPLEX));
  for(const std::array<std::size_t, 4>& cell : cells)
    for(const std::size_t v : cell)
      if(!to_vector(points.at(v)).allFinite() || !to_vector(images.at(v)).allFinite())
        return failed_check(ERROR_NON_FINITE_COORDINATE, "Point ", v, " has the coordinates ",
                            describe(to_vector(points[v])), " and the image ", describe(to_vector(images[v])), ".");
  return {};
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_CHECK_MAP_3_H
