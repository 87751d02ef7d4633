// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PARAMETERIZE_BODY_3_IMPL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PARAMETERIZE_BODY_3_IMPL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/find_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/make_result_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/refine_and_find_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/slide_and_bound_angles_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Measures the distortion with all points prescribed, so that the map is their target.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Distortion_3 distortion_of_soup_3(const Tetrahedron_soup_3& soup, const std::vector<std::array<double, 3> >& images)
{
  check_simplices(soup);
  require(images.size() == soup.points.size(), "images must have an element for each point.");
  const Numbered_mesh_3 mesh = Numbered_body_3(soup, std::vector<bool>(soup.points.size(), true), images).mesh;
  return measure_distortion_3(mesh, singular_values_of_cells_3(mesh, mesh.target));
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PARAMETERIZE_BODY_3_IMPL_H
