// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_UNTANGLING_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_UNTANGLING_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_direction_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/System/Newton_system_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/Untangler_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Newton/harmonic_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Stage_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace CGAL::Volume_mesh_parameterization::internal {

// With the prescribed vertices on their targets: untangles until no cell is inverted.
class Untangling_3 : public Stage_3
{
public:
  // Starts from these images of all vertices, in the units of the target.
  Untangling_3(const Numbered_mesh_3& mesh, Newton_system_3& system, const Eigen::Matrix3Xd& start, const double theta)
    : m_mesh(mesh), m_unit(system.unit()), m_untangler(system, m_unit * start, theta)
  {
    if(is_flip_free())
      end(OK);
  }

  void step() override
  {
    const Step_status status = m_untangler.step();
    report(Phase::UNTANGLING, m_untangler);
    conclude(status, ERROR_NOT_FLIP_FREE, m_untangler.direction());
  }

  Eigen::Matrix3Xd positions() const override { return snapped(m_mesh, m_untangler.positions() / m_unit); }
  bool is_flip_free() const override { return m_untangler.evaluation().is_flip_free(); }
  std::size_t number_of_inverted_cells() const { return m_untangler.evaluation().number_of_inverted_cells; }

private:
  const Numbered_mesh_3& m_mesh;
  double m_unit;
  Untangler_3 m_untangler;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAGES_UNTANGLING_UNTANGLING_3_H
