// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_JUDGE_HEXAHEDRA_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_JUDGE_HEXAHEDRA_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedral_mesh_result.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/to_vector.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/hexahedron_corners_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Input_check_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/sentence.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The result where the input does not allow a mesh.
inline Hexahedral_mesh_result refused_result(const Input_check_3& check)
{
  Hexahedral_mesh_result result;
  result.status = check.status;
  result.message = check.message;
  return result;
}

// The result for a mesh.
inline Hexahedral_mesh_result judged(const Hexahedron_soup_3& mesh, const bool has_padding)
{
  Hexahedral_mesh_result result;
  result.number_of_vertices = mesh.points.size();
  result.number_of_cells = mesh.cells.size();
  result.has_padding = has_padding;
  const std::vector<bool> is_outer = is_on_boundary(mesh);
  result.number_of_boundary_vertices = std::count(is_outer.begin(), is_outer.end(), true);

  std::string place;
  for_each_corner(mesh, [&](const std::array<std::size_t, 4>& corner)
  {
    if(!is_positive_corner(mesh, corner) && result.number_of_inverted_corners++ == 0)
      place = " The first one is at " + describe(to_vector(mesh.points[corner[0]]))
              + (is_outer[corner[0]] ? ", on the boundary." : ", inside.");
  });
  const std::vector<double> quality = scaled_jacobians(mesh);
  result.minimal_scaled_jacobian = *std::min_element(quality.begin(), quality.end());
  result.mean_scaled_jacobian = std::accumulate(quality.begin(), quality.end(), 0.) / quality.size();
  result.status = result.number_of_inverted_corners == 0 ? OK : ERROR_INVERTED_HEXAHEDRON;
  result.message = get_error_message(result.status) + place;
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_JUDGE_HEXAHEDRA_3_H
