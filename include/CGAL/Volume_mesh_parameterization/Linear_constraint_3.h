// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_LINEAR_CONSTRAINT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_LINEAR_CONSTRAINT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

A linear equation \f$\sum_k c_k \cdot u_{v_k} = p\f$ between the images of vertices: a row of the
positional constraints \f$P(u) = C u - p = 0\f$ of Jin et al.\ \cgalCite{cgal:jqzctz-smvp-15}, equation (7).

For example, a vertex `v` stays on the plane through `q` with normal `n` by the term `{v, n}` and the
value `n.dot(q)`, and the vertices `v` and `w` keep their distance in that direction by the terms
`{v, n}` and `{w, -n}`. The meaning of the residual is a distance if the coefficients have length 1.

Constraints have an effect with `Boundary_mode::SOFT` only. They act like the targets of the boundary, by the square of
their residual.

\tparam Vertex_ a type that names a vertex: `C3t3::Vertex_handle` in what is passed to
        `CGAL::stretch_minimizing_volume_parameterization()`
*/
template <typename Vertex_>
struct Linear_constraint_3
{
  /// a summand \f$c_k \cdot u_{v_k}\f$
  struct Term
  {
    Vertex_ vertex;              ///< the vertex \f$v_k\f$, one of a cell of the complex
    Eigen::Vector3d coefficient; ///< the vector \f$c_k\f$
  };

  std::vector<Term> terms; ///< the left-hand side
  double value = 0;        ///< the right-hand side \f$p\f$, in the unit of the target if the coefficients have none
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_LINEAR_CONSTRAINT_3_H
