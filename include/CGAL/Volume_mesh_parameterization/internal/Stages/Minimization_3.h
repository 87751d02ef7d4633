// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MINIMIZATION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MINIMIZATION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cells/Cell_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Minimizer_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Negative_curvature.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Stagnation.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Stage_3.h>

#include <Eigen/Core>

#include <functional>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// Minimizes an energy from a map on that inverts no cell; vertices that are not unknown stay where they are.
class Minimization_3 : public Stage_3
{
public:
  // Is it to end after this step, where the energy stagnates or not, with these images of the vertices? Asked where a
  // stagnation may be noticed.
  using Ends_here = std::function<bool(const Parameterization_step&, bool, const Eigen::Matrix3Xd&)>;

  Minimization_3(Newton_system_3& system, const Cell_energy_3& energy, const Eigen::Matrix3Xd& positions,
                 Ends_here ends_here = nullptr, const Negative_curvature& negative_curvature = Negative_curvature())
    : m_system(system), m_minimizer(system, energy, system.unit() * positions, negative_curvature),
      m_energy_of_other_cells(system.energy_of_other_cells(energy, m_minimizer.positions())),
      m_ends_here(std::move(ends_here))
  {}

  void step() override
  {
    const Step_status status = m_minimizer.step();
    report(Phase::MINIMIZATION, m_minimizer, m_energy_of_other_cells);
    conclude(status, ERROR_NOT_CONVERGED, m_minimizer.direction());
    if(is_running() && m_ends_here && last_step().iteration % Stagnation::number_of_steps == 0
       && m_ends_here(last_step(), m_minimizer.is_stagnating(), positions()))
      end(ERROR_NOT_CONVERGED);
  }

  Eigen::Matrix3Xd positions() const override { return m_minimizer.positions() / m_system.unit(); }
  bool is_flip_free() const override { return true; }

private:
  Newton_system_3& m_system;
  Minimizer_3 m_minimizer;
  double m_energy_of_other_cells;
  Ends_here m_ends_here;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_MINIMIZATION_3_H
