// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SCALED_CELLS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SCALED_CELLS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Cells with which those of the image are compared.
enum class Reference_cells { SOURCE, REGULAR };

// Cells of a mesh for images that are multiplied by a scale. The source is scaled to the same volume. The scale is a power of two,
// which makes its products exact.
struct Scaled_cells_3
{
  double scale;
  std::vector<Matrix_3> inverse_sources; // X^{-1} of each cell
  std::vector<double> weights;                  // of the cells; the sum is 1
};

// The inverse edge matrices X^{-1} of the cells in the source, times a factor.
inline std::vector<Matrix_3> scaled_inverse_sources(const Numbered_mesh_3& mesh, const double factor)
{
  return values_of_cells(mesh, mesh.cells.size(), [&](const std::array<int, 4>& cell) -> Matrix_3
  { return source_edges(mesh, cell).inverse() * factor; });
}

// Gives cells with this mean volume a volume near 1.
inline double scale_of_cells(const double mean_volume) { return std::exp2(-std::round(std::log2(mean_volume) / 3)); }

// The scale gives the cells of the target a volume near 1.
inline Scaled_cells_3 cells_scaled_to_target(const Numbered_mesh_3& mesh)
{
  const double volume = reference_volume(mesh);
  const double scale = scale_of_cells(volume / mesh.global_number_of_cells());
  const double factor = std::cbrt(source_volume(mesh) / volume) / scale;
  return { scale, scaled_inverse_sources(mesh, factor), cell_weights(mesh) };
}

// Returns regular cells of one size instead of those of the source: where only some map without inverted cells is looked
// for, slivers of the source must not stiffen it.
inline Scaled_cells_3 regular_cells_scaled_to_target(const Numbered_mesh_3& mesh)
{
  const double mean_volume = reference_volume(mesh) / mesh.global_number_of_cells();
  const double scale = scale_of_cells(mean_volume);
  const Matrix_3 inverse = regular_edges().inverse() / (std::cbrt(3 * mean_volume) * scale);
  return { scale, std::vector<Matrix_3>(mesh.cells.size(), inverse), cell_weights(mesh) };
}

// Gives a body whose volume has this cube root a volume near 1.
inline double scale_of_length(const double length) { return std::exp2(-std::round(std::log2(length))); }

// The scale gives the whole target a volume near 1, where `length` is the cube root of that volume.
inline Scaled_cells_3 cells_scaled_to_length(const Numbered_mesh_3& mesh, const double length)
{
  const double scale = scale_of_length(length);
  const double factor = std::cbrt(source_volume(mesh)) / (scale * length);
  return { scale, scaled_inverse_sources(mesh, factor), cell_weights(mesh) };
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_SCALED_CELLS_3_H
