// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_HEXAHEDRAL_MESH_RESULT_H
#define CGAL_POLYCUBE_MESHING_3_HEXAHEDRAL_MESH_RESULT_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/basic.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Polycube_meshing_3 {

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// The largest number of boxes of a grid. Each one needs about 4 kB of memory.
constexpr double maximum_number_of_boxes = 1e7;

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// The volumes of a subdomain.
struct Subdomain_volumes
{
  int reference = 0;              ///< the index of the subdomain
  double of_tetrahedra = 0;       ///< the volume of its tetrahedra
  double of_hexahedra = 0;        ///< the volume of its hexahedra, whose quadrangles are bilinear
};

/*!
\ingroup PkgPolycubeMeshing3Hexahedra

The quadrangles with one reference. Each quadrangle counts as two triangles.
*/
struct Hexahedral_mesh_patch
{
  int reference = 0;                      ///< the reference
  std::size_t number_of_quadrangles = 0;  ///< number of quadrangles
  double area = 0;                        ///< the sum of areas, in the squared unit of the points
  std::array<double, 3> center = {};      ///< the center of mass
  /// the mean of the outward normals, weighted by area, as a unit vector; zero if the mean is zero, as for a closed patch
  std::array<double, 3> normal = {};
};

/*!
\ingroup PkgPolycubeMeshing3Hexahedra

The corners, curves and patches of the boundary of a body that hexahedra keep. Curves are sharp edges; patches are the parts of the
boundary between them. A corner is kept if it is a vertex, a curve if edges of hexahedra follow it, and a patch if its curves are
kept and it has quadrangles. Tolerances are a tenth of an edge.
*/
struct Hexahedral_mesh_features
{
  std::size_t number_of_corners = 0;      ///< corners, where curves meet, end or turn
  std::size_t number_of_corners_kept = 0; ///< corners that are kept
  std::size_t number_of_curves = 0;       ///< curves
  std::size_t number_of_curves_kept = 0;  ///< curves that are kept
  std::size_t number_of_patches = 0;      ///< patches
  std::size_t number_of_patches_kept = 0; ///< patches that are kept
  std::vector<std::array<double, 3> > corners_given_up = {}; ///< the corners that are not kept
  std::vector<std::array<double, 3> > curves_given_up = {};  ///< a point of each curve that is not kept
  std::vector<std::array<double, 3> > patches_given_up = {}; ///< a point of each patch that is not kept
};

/*!
\ingroup PkgPolycubeMeshing3Hexahedra

The result of `make_hexahedral_mesh_3()`.

The scaled Jacobian of a corner of a hexahedron is the determinant of its three edges, divided by their lengths. It is 1 if the
edges are orthogonal, and positive if and only if the corner is neither flat nor inverted. The scaled Jacobian of a hexahedron is
the smallest one of its eight corners. A hexahedron is inverted if the Jacobian determinant of its trilinear map is not positive
everywhere. This may happen although all corners are positive.
*/
struct Hexahedral_mesh_result
{
  Error_code status = OK;                ///< how the computation ended
  std::string message;                   ///< sentences about the status and its place
  bool has_valid_mesh = false;           ///< whether no hexahedron is inverted and the mesh is written
  std::size_t number_of_vertices = 0;          ///< all vertices of the mesh
  std::size_t number_of_boundary_vertices = 0; ///< vertices on the boundary of the body
  std::size_t number_of_cells = 0;             ///< hexahedra
  std::size_t number_of_inverted_corners = 0;  ///< inverted or flat corners, by exact predicates
  std::size_t number_of_inverted_hexahedra = 0; ///< hexahedra that are not positive everywhere, in exact arithmetic
  bool has_padding = false;                    ///< whether a layer of hexahedra has been added along faces of the domain
  bool is_interrupted = false;                 ///< whether a limit of time or a visitor ended the search for better hexahedra
  /// the minimum over all hexahedra; not a number if there is none
  double minimum_scaled_jacobian = std::numeric_limits<double>::quiet_NaN();
  /// the mean over all hexahedra; not a number if there is none
  double mean_scaled_jacobian = std::numeric_limits<double>::quiet_NaN();
  /// the largest distance between the boundaries of body and hexahedra; not a number if there are no hexahedra. It is measured
  /// at vertices of the body, and at vertices and midpoints of edges and diagonals of quadrangles.
  double boundary_distance = std::numeric_limits<double>::quiet_NaN();
  std::vector<Subdomain_volumes> volumes; ///< the volumes of each subdomain before and after, by ascending references
  /// the largest distance between interfaces of subdomains and their quadrangles; 0 if there is no interface, not a number if
  /// there are no hexahedra. It is measured at vertices, midpoints of edges and centers of quadrangles, and at vertices of
  /// interfaces.
  double interface_distance = std::numeric_limits<double>::quiet_NaN();
  /// the patches of the boundary, by ascending reference; none if there is no valid mesh
  std::vector<Hexahedral_mesh_patch> patches;
  /// the marked corners on the boundary of the body that are no vertices of the mesh; none if there is no valid mesh. There was no
  /// free vertex near the corner, or hexahedra were inverted or poor there.
  std::vector<std::array<double, 3> > corners_given_up;
  Hexahedral_mesh_features features; ///< the features of the boundary; none if there is no valid mesh
};

} // namespace CGAL::Polycube_meshing_3

#endif // CGAL_POLYCUBE_MESHING_3_HEXAHEDRAL_MESH_RESULT_H
