// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_MEASURE_DISTORTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_MEASURE_DISTORTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/cell_quality_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

inline double angle_distortion(const double largest, const double smallest)
{ return largest / smallest + smallest / largest; }

inline void add_cell(Distortion_3& distortion, const double cell_volume, const Vector_3& s)
{
  const double angle = angle_distortion(s[0], s[2]);
  const double determinant = s.prod();
  const double change = determinant + 1 / determinant;
  distortion.angle_mean += cell_volume * angle;
  distortion.angle_max = (std::max)(distortion.angle_max, angle);
  distortion.volume_mean += cell_volume * change;
  distortion.volume_max = (std::max)(distortion.volume_max, change);
}

// The distortions that are no numbers: cells may be so flat that rounding leaves no singular value above 0.
inline void replace_by_infinity(Distortion_3& distortion)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if(std::isnan(distortion.angle_mean))
    distortion.angle_mean = distortion.angle_max = infinity;
  if(std::isnan(distortion.volume_mean))
    distortion.volume_mean = distortion.volume_max = infinity;
}

// The signed singular values of a map in each cell that this process owns.
inline std::vector<Vector_3> singular_values_of_cells_3(const Numbered_mesh_3& mesh, const Matrix3Xd& image)
{
  return values_of_cells(mesh, mesh.number_of_own_cells(), [&](const std::array<int, 4>& cell) -> Vector_3
  { return signed_singular_values_3(edge_matrix(image, cell) * source_edges(mesh, cell).inverse()); });
}

// Returns the factor of the singular values if the image is scaled as for the energy: back from the scale of reference, or to the
// volume of the source.
inline double factor_to_source_volume(const Numbered_mesh_3& mesh, const Matrix3Xd& image)
{ return std::cbrt(source_volume(mesh) / (mesh.reference_scale ? reference_volume(mesh) : volume(mesh, image))); }

// Returns the distortions of a map by its singular values in each cell, times a factor.
inline Distortion_3 measure_distortion_3(const Numbered_mesh_3& mesh, const std::vector<Vector_3>& s,
                                         const double factor = 1)
{
  const double total = source_volume(mesh);
  Distortion_3 result = {0, 0, 0, 0};
  for(std::size_t c = 0; c < s.size(); ++c)
    add_cell(result, source_edges(mesh, mesh.cells[c]).determinant() / 6 / total, factor * s[c]);
  const Communicator_3& communicator = *mesh.communicator;
  result = { communicator.sum(result.angle_mean), communicator.maximum(result.angle_max),
             communicator.sum(result.volume_mean), communicator.maximum(result.volume_max) };
  replace_by_infinity(result);
  return result;
}

inline Cell_quality_3 measure_quality_3(const Numbered_mesh_3& mesh, const Matrix3Xd& image)
{
  const Cell_quality_3 own = worst_quality(values_of_cells(mesh, mesh.number_of_own_cells(), [&](const std::array<int, 4>& cell)
  {
    return quality_of_cell({ image.col(cell[0]), image.col(cell[1]), image.col(cell[2]), image.col(cell[3]) });
  }));
  const Communicator_3& communicator = *mesh.communicator;
  return { communicator.minimum(own.minimum_dihedral_angle), communicator.maximum(own.maximum_dihedral_angle),
           communicator.minimum(own.minimum_scaled_jacobian), communicator.maximum(own.maximum_aspect_ratio) };
}

inline double largest_angle_distortion_3(const Numbered_mesh_3& mesh, const Matrix3Xd& image)
{ return measure_distortion_3(mesh, singular_values_of_cells_3(mesh, image)).angle_max; }

// Psi of each cell, with the singular values multiplied by a factor.
inline std::vector<double> energies_of_cells_3(const std::vector<Vector_3>& s, const Cell_energy_3& energy,
                                               const double factor)
{
  std::vector<double> result(s.size());
  for(std::size_t first = 0; first < s.size(); first += cells_per_pack)
  {
    Packed_vector_3 packed;
    Packed_number psi;
    for(std::size_t lane = 0; lane < cells_per_pack; ++lane)
      for(int i = 0; i < 3; ++i)
        packed[i][lane] = factor * s[(std::min)(first + lane, s.size() - 1)][i];
    energy.value(packed, psi);
    std::copy_n(psi, (std::min)(s.size() - first, std::size_t(cells_per_pack)), result.begin() + first);
  }
  return result;
}

// The mean of psi over the cells, with the singular values multiplied by a factor.
inline double mean_energy_3(const Numbered_mesh_3& mesh, const std::vector<Vector_3>& s,
                            const Cell_energy_3& energy, const double factor)
{
  const std::vector<double> psi = energies_of_cells_3(s, energy, factor), weights = cell_weights(mesh);
  const double result = mesh.communicator->sum(std::inner_product(psi.begin(), psi.end(), weights.begin(), 0.));
  return std::isnan(result) ? std::numeric_limits<double>::infinity() : result;
}

inline double mean_energy_3(const Numbered_mesh_3& mesh, const Matrix3Xd& image, const Cell_energy_3& energy)
{ return mean_energy_3(mesh, singular_values_of_cells_3(mesh, image), energy, factor_to_source_volume(mesh, image)); }

inline double angle_distortion_of_facet(const Facet_edges_3& X, const Facet_edges_3& U)
{
  const auto [a, b] = squared_singular_values_of_facet(X, U);
  return angle_distortion(std::sqrt(a), std::sqrt(b));
}

// The largest distortion of angles that the prescribed vertices force alone: that of a cell with four of
// them, and that of a facet with three, which is a lower bound for its cells.
inline double unavoidable_angle_distortion_3(const Numbered_mesh_3& mesh)
{
  double result = 2;
  for(std::array<int, 4> cell : mesh.cells)
  {
    // the vertices at their targets come first
    const auto first_free = std::stable_partition(cell.begin(), cell.end(), [&](const int v) { return mesh.is_fixed(v); });
    const auto number_of_prescribed = first_free - cell.begin();
    if(number_of_prescribed < 3)
      continue;
    const Matrix_3 X = source_edges(mesh, cell), U = edge_matrix(mesh.target, cell);
    if(number_of_prescribed == 4)
    {
      const Vector_3 s = signed_singular_values_3(U * X.inverse());
      result = (std::max)(result, angle_distortion(s[0], s[2]));
    }
    else
      result = (std::max)(result, angle_distortion_of_facet({ X.col(0), X.col(1) }, { U.col(0), U.col(1) }));
  }
  return result;
}

constexpr double large_prescribed_distortion = 10; // a guess: no other bound was tried

// Finds the cells with four prescribed vertices whose distortion of angles is large.
inline std::vector<std::size_t> distorted_prescribed_cells_3(const Numbered_mesh_3& mesh)
{
  std::vector<std::size_t> result;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
  {
    const std::array<int, 4>& cell = mesh.cells[c];
    if(!std::all_of(cell.begin(), cell.end(), [&](const int v) { return mesh.is_fixed(v); }))
      continue;
    const Vector_3 s
      = signed_singular_values_3(edge_matrix(mesh.target, cell) * source_edges(mesh, cell).inverse());
    if(angle_distortion(s[0], s[2]) > large_prescribed_distortion)
      result.push_back(c);
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_MEASURE_DISTORTION_3_H
