// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_DOMINANT_CELLS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_DOMINANT_CELLS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/measure_distortion_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/sentence.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The few cells that hold much of an energy, as those do which prescribed vertices make extremely flat.
struct Dominant_cells_3
{
  std::vector<std::size_t> cells; // the first one holds most
  double part_of_energy = 0;      // that all of them hold
  double logarithmic_mean = 0;    // of 1 + the energy of all cells, where those far above the median count as not so far

  bool hold_most() const { return part_of_energy > 0.5; }
};

// The cells whose energy is far above the median, and not below the mean.
inline Dominant_cells_3 dominant_cells_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy,
                                         const Eigen::Matrix3Xd& image)
{
  constexpr double far_above = 100;
  const std::vector<double> psi
    = energies_of_cells_3(singular_values_of_cells_3(mesh, image), energy, factor_to_source_volume(mesh, image));
  const std::vector<double> weights = cell_weights(mesh);
  const double mean = std::inner_product(psi.begin(), psi.end(), weights.begin(), 0.);
  std::vector<double> sorted = psi;
  const auto median = sorted.begin() + sorted.size() / 2;
  std::nth_element(sorted.begin(), median, sorted.end());
  const double high = far_above * *median, bound = (std::max)(high, mean);

  Dominant_cells_3 result;
  for(std::size_t c = 0; c < psi.size(); ++c)
  {
    result.logarithmic_mean += weights[c] * std::log1p((std::min)(psi[c], high));
    if(!(psi[c] > bound))
      continue;
    result.part_of_energy += weights[c] * psi[c] / mean;
    result.cells.push_back(c);
    if(psi[c] > psi[result.cells.front()])
      std::swap(result.cells.front(), result.cells.back());
  }
  return result;
}

// Why the minimization over all vertices was ended.
inline std::string describe(const Dominant_cells_3& dominant, const Numbered_mesh_3& mesh)
{
  return sentence(dominant.cells.size(), " of ", mesh.cells.size(), " cells, which the prescribed vertices make flat, hold ",
                  std::floor(100 * dominant.part_of_energy), " % of the energy, and further steps would hardly lower it, or "
                  "for them alone; most of it holds the cell at ",
                  describe(mesh.source.col(mesh.cells[dominant.cells.front()][0])),
                  ". A boundary with less distortion there, or vertices that slide, would help. The other vertices were "
                  "then moved alone, to where they hardly improve either.");
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_DOMINANT_CELLS_3_H
