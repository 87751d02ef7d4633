// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_UNTANGLING_SETTING_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_UNTANGLING_SETTING_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Scaled_cells_3.h>

#include <array>

namespace CGAL::Volume_mesh_parameterization::internal {

// Towards what reference cells to untangle, and how much their volumes count (theta in `Untangling_energy_3`).
struct Untangling_setting
{
  const char* name;
  bool has_regular_cells;
  double theta;
};

// They are tried in this order. Slivers of the source would stiffen the map, so regular cells of one size come first; a
// large and a smaller theta fail in different places. In some maps of large distortion the source serves better; there
// theta must be small, so that parts that shrink a million times do not dominate the energy.
constexpr std::array<Untangling_setting, 3> untangling_settings = {{
  {"regular cells, theta 20", true, 20}, {"regular cells, theta 0.5", true, 0.5}, {"cells of the source", false, 0.01}
}};

// From a map with few inverted cells on.
constexpr Untangling_setting setting_to_go_on = untangling_settings[0];

inline Scaled_cells_3 reference_cells(const Numbered_mesh_3& mesh, const Untangling_setting& setting)
{
  return setting.has_regular_cells ? regular_cells_scaled_to_target(mesh) : cells_scaled_to_target(mesh);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_UNTANGLING_SETTING_H
