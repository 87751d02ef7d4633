// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SLIDING_DIRECTIONS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SLIDING_DIRECTIONS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Block_sparse_matrix_3.h>

#include <Eigen/Dense>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The directions in which each unknown vertex may move, as an orthogonal projector P: space, a plane or
// a line. Newton steps stay in them if P H P d = -P g is solved in place of H d = -g.
class Sliding_directions_3
{
public:
  explicit Sliding_directions_3(std::vector<Eigen::Matrix3d> projectors) : m_projectors(std::move(projectors)) {}

  // One column a vertex; those of further vertices are left alone.
  void project(Eigen::Matrix3Xd& vectors) const
  {
    for(std::size_t v = 0; v < m_projectors.size(); ++v)
      vectors.col(v) = m_projectors[v] * vectors.col(v);
  }

  // P H P, made regular by a multiple of 1 - P that is as large as the block on the diagonal.
  template <typename NT>
  void project(Block_sparse_matrix_3<NT>& hessian) const
  {
    for(int row = 0; row < hessian.size(); ++row)
    {
      const Eigen::Matrix3d& P = m_projectors[row];
      for(int k = hessian.row_begin(row); k < hessian.row_end(row); ++k)
      {
        const int column = hessian.column(k);
        const Eigen::Matrix3d H = hessian.block(k).template cast<double>();
        Eigen::Matrix3d projected = P * H * m_projectors[column];
        if(row == column)
          projected += H.norm() * (Eigen::Matrix3d::Identity() - P);
        hessian.block(k) = projected.template cast<NT>();
      }
    }
  }

private:
  std::vector<Eigen::Matrix3d> m_projectors;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SLIDING_DIRECTIONS_3_H
