// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_POLYCUBE_RESULT_H
#define CGAL_POLYCUBE_MESHING_3_POLYCUBE_RESULT_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgPolycubeMeshing3Polycubes

The properties of a polycube that `Polycube_boundary_parameterizer_3` finds.
*/
struct Polycube_result
{
  /// a sequence of points of the boundary, of which each is joined to the next one by an edge
  using Polyline = std::vector<std::array<double, 3> >;

  /// the rows of the rotation matrix of the body into the axes of the polycube: the identity for given axes or labels
  std::array<std::array<double, 3>, 3> rotation = {};
  /// number of sharp edges of the boundary
  std::size_t number_of_sharp_edges = 0;
  /// polylines of the sharp edges whose images are not parallel to an axis, in the body as it is given; the longest one is first.
  /// Grids do not follow them.
  std::vector<Polyline> features_given_up = {};
  /// label of the facet opposite to each vertex of each cell, as `Polycube_boundary_parameterizer_3::parameterize()` takes it:
  /// 0 for +x, 1 for -x, 2 for +y, 3 for -y, 4 for +z, 5 for -z, in the axes of the polycube; `no_label` for facets inside. Cells
  /// are in the order of the arrays, or of the cells in the complex, after refinement. If the body has been turned, rotate it
  /// before these labels are passed on. Labels of a box with holes are not close to the normals, and may have no polycube.
  std::vector<std::array<std::size_t, 4> > labels = {};

  static constexpr std::size_t no_label = 6; ///< label of a facet that is not on the boundary

  /// returns the number of edges of the polylines.
  std::size_t number_of_edges_given_up() const
  {
    std::size_t result = 0;
    for(const Polyline& polyline : features_given_up)
      result += polyline.size() - 1;
    return result;
  }
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_POLYCUBE_MESHING_3_POLYCUBE_RESULT_H
