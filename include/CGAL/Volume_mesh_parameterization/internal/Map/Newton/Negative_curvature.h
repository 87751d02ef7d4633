// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_NEGATIVE_CURVATURE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_NEGATIVE_CURVATURE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Newton_iterate_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// The part of the negative curvature that a Hessian keeps: between 0, which makes it positive
// semi-definite and serves far from the optimum, and 1, which makes it the full one and converges
// quadratically near it. Raised after a full step; lowered where the Hessian proves indefinite.
class Negative_curvature
{
public:
  explicit Negative_curvature(const double part = 0) : m_part(part) {}

  double part() const { return m_part; }

  // A failure also slows down the next rises.
  void lower()
  {
    m_part = m_part > 0.01 ? m_part / 4 : 0;
    m_growth = 1.5;
  }

  void raise()
  {
    m_part = (std::min)(1., (std::max)(0.1, m_growth * m_part));
    m_growth = (std::min)(4., 1.2 * m_growth);
  }

private:
  double m_part;
  double m_growth = 4;
};

// Asks `step(part)` for a step with as much negative curvature of the Hessian as serves, less of it where that fails.
template <typename Step>
bool step_with_some_curvature(Negative_curvature& negative_curvature, const Newton_iterate_3& iterate, const Step& step)
{
  while(!step(negative_curvature.part()))
  {
    if(negative_curvature.part() == 0 || iterate.direction.status == Linear_solver_status::OUT_OF_MEMORY)
      return false;
    negative_curvature.lower();
  }
  return true;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_NEGATIVE_CURVATURE_H
