// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_CRAWL_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_CRAWL_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_step.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/dominant_cells_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// Notices that a minimization crawls: a few cells hold most of the energy, and the energy stagnates, or it falls for these
// cells alone. The latter is the case if the mean of the logarithms, in which these cells count as little as others, has
// not become notably lower for a hundred steps.
class Crawl_3
{
public:
  static constexpr double large_energy = 100; // a mean that hints at such cells

  Crawl_3(const Numbered_mesh_3& mesh, const Cell_energy_3& energy) : m_mesh(mesh), m_energy(energy) {}

  // Asked every few steps.
  bool notice(const Parameterization_step& step, const bool is_stagnating, const Eigen::Matrix3Xd& image)
  {
    constexpr std::size_t patience = 100;
    constexpr double notable = 1e-3;
    m_is_noticed = false;
    if(!(is_stagnating || step.energy > large_energy) || !is_dominated(image))
      return false;
    if(m_dominant.logarithmic_mean < m_lowest_mean - notable)
    {
      m_lowest_mean = m_dominant.logarithmic_mean;
      m_step_of_lowest_mean = step.iteration;
    }
    m_is_noticed = is_stagnating || step.iteration >= m_step_of_lowest_mean + patience;
    return m_is_noticed;
  }

  bool is_noticed() const { return m_is_noticed; }

  // Do a few cells hold most of the energy?
  bool is_dominated(const Eigen::Matrix3Xd& image)
  {
    if(m_mesh.communicator->is_alone()) // the median of a part is not that of all
      m_dominant = dominant_cells_3(m_mesh, m_energy, image);
    return m_dominant.hold_most();
  }

  const Dominant_cells_3& dominant() const { return m_dominant; } // of the last image

private:
  const Numbered_mesh_3& m_mesh;
  const Cell_energy_3& m_energy;
  Dominant_cells_3 m_dominant;
  double m_lowest_mean = std::numeric_limits<double>::infinity();
  std::size_t m_step_of_lowest_mean = 0;
  bool m_is_noticed = false;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_CRAWL_3_H
