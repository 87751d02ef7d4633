// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_QUADRATIC_PENALTY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_QUADRATIC_PENALTY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/System/Unknowns_3.h>

#include <Eigen/Dense>

#include <cmath>

namespace CGAL::Volume_mesh_parameterization::internal {

// The penalty w |C x - p|^2 of linear constraints on vertices, unknown or not, as a function of u = scale x. The right side p
// can be replaced for a while by the current values of C x.
class Quadratic_penalty_3
{
public:
  using Positions = Matrix3Xd;

  Quadratic_penalty_3(std::vector<Linear_constraint_3<int> > constraints, const double weight, const double scale = 1)
    : m_constraints(std::move(constraints)), m_scale(scale)
  {
    for(const Linear_constraint_3<int>& constraint : m_constraints)
      m_values.push_back(scale * constraint.value);
    set_weight(weight);
    release();
  }

  void set_weight(const double weight) { m_weight = weight / (m_scale * m_scale); }

  // Takes the current positions as target.
  void hold(const Positions& u)
  {
    for(std::size_t i = 0; i < m_constraints.size(); ++i)
      m_targets[i] = left_side(m_constraints[i], u);
  }

  // Takes the constraints as target again.
  void release() { m_targets = m_values; }

  // |C x - p| for the constraints themselves
  double residual(const Positions& u) const { return std::sqrt(squared_distance(u, m_values)) / m_scale; }

  double value(const Positions& u) const { return m_weight * squared_distance(u, m_targets); }

  // Adds the derivatives by the unknown vertices, in their rows.
  void add_gradient(const Positions& u, const Unknowns_3& unknowns, Positions& gradient) const
  {
    for(std::size_t i = 0; i < m_constraints.size(); ++i)
    {
      const double factor = 2 * m_weight * (left_side(m_constraints[i], u) - m_targets[i]);
      for(const auto& term : m_constraints[i].terms)
        if(unknowns.contains(term.vertex))
          gradient.col(unknowns.row(term.vertex)) += factor * term.coefficient;
    }
  }

  template <typename NT>
  void add_hessian(const Unknowns_3& unknowns, Block_sparse_matrix_3<NT>& hessian) const
  {
    for(const Linear_constraint_3<int>& constraint : m_constraints)
      for(const auto& a : constraint.terms)
        for(const auto& b : constraint.terms)
          if(unknowns.contains(a.vertex) && unknowns.contains(b.vertex))
            hessian.block(hessian.position(unknowns.row(a.vertex), unknowns.row(b.vertex)))
              += (2 * m_weight * a.coefficient * b.coefficient.transpose()).template cast<NT>();
  }

  // The vertices that are coupled, for each constraint.
  std::vector<std::vector<int> > groups() const
  {
    std::vector<std::vector<int> > result;
    for(const Linear_constraint_3<int>& constraint : m_constraints)
    {
      result.emplace_back();
      for(const auto& term : constraint.terms)
        result.back().push_back(term.vertex);
    }
    return result;
  }

private:
  double squared_distance(const Positions& u, const std::vector<double>& right_side) const
  {
    double sum = 0;
    for(std::size_t i = 0; i < m_constraints.size(); ++i)
      sum += square(left_side(m_constraints[i], u) - right_side[i]);
    return sum;
  }

  static double square(const double x) { return x * x; }

  static double left_side(const Linear_constraint_3<int>& constraint, const Positions& u)
  {
    double sum = 0;
    for(const auto& term : constraint.terms)
      sum += u.col(term.vertex).dot(term.coefficient);
    return sum;
  }

  std::vector<Linear_constraint_3<int> > m_constraints;
  std::vector<double> m_values, m_targets; // the right sides of the constraints times the scale, and those that count now
  double m_scale, m_weight;                 // the weight for u
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_NEWTON_SYSTEM_QUADRATIC_PENALTY_3_H
