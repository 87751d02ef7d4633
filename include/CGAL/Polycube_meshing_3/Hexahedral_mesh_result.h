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

#include <CGAL/Volume_mesh_parameterization/Error_code.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

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

The quadrangles with one reference, each taken for two triangles.
*/
struct Hexahedral_mesh_patch
{
  int reference = 0;                      ///< the reference
  std::size_t number_of_quadrangles = 0;  ///< how many there are
  double area = 0;                        ///< the sum of areas, in the squared unit of the points
  std::array<double, 3> center = {};      ///< the center of mass
  /// the sum of the areas times the normals, which point outwards, as a unit vector; zero if the sum is, as of a closed patch
  std::array<double, 3> normal = {};
};

/*!
\ingroup PkgPolycubeMeshing3Hexahedra

The result of `make_hexahedral_mesh_3()`.

The scaled Jacobian of a corner of a hexahedron is the determinant of its three edges divided by their lengths: 1 if
they are orthogonal, and positive if and only if the corner is neither flat nor inverted. A hexahedron has the smallest
scaled Jacobian of its eight corners. A hexahedron is inverted if the Jacobian determinant of its trilinear map is not positive
all over it. This may happen although all corners are positive.
*/
struct Hexahedral_mesh_result
{
  Error_code status = OK;                ///< how the computation ended
  std::string message;                   ///< sentences about the status, and where it arises
  bool has_valid_mesh = false;           ///< whether no hexahedron is inverted: then the mesh is written
  std::size_t number_of_vertices = 0;          ///< all vertices of the mesh
  std::size_t number_of_boundary_vertices = 0; ///< vertices on the boundary of the body
  std::size_t number_of_cells = 0;             ///< hexahedra
  std::size_t number_of_inverted_corners = 0;  ///< inverted or flat corners, by exact predicates
  std::size_t number_of_inverted_hexahedra = 0; ///< hexahedra that are not positive all over, in exact arithmetic
  bool has_padding = false;                    ///< whether a layer of hexahedra has been added along faces of the domain
  bool is_interrupted = false;                 ///< whether a limit of time or a visitor ended the search for better hexahedra
  /// the least one of all hexahedra; not a number if there is none
  double minimum_scaled_jacobian = std::numeric_limits<double>::quiet_NaN();
  /// the mean of all hexahedra; not a number if there is none
  double mean_scaled_jacobian = std::numeric_limits<double>::quiet_NaN();
  /// the largest distance between the boundary of the body and that of the hexahedra: from the vertices of the body, and from the
  /// vertices and the middles of edges and diagonals of quadrangles; not a number if there are no hexahedra
  double boundary_distance = std::numeric_limits<double>::quiet_NaN();
  std::vector<Subdomain_volumes> volumes; ///< the volumes of each subdomain before and after, by ascending references
  /// the largest distance between interfaces of the subdomains and the quadrangles there: from the vertices, the middles of edges
  /// and the centers of quadrangles, and from the vertices of the interfaces; 0 if there is no interface, not a number if there
  /// are no hexahedra
  double interface_distance = std::numeric_limits<double>::quiet_NaN();
  /// the patches of the boundary, by ascending reference; none if there is no valid mesh
  std::vector<Hexahedral_mesh_patch> patches;
  /// the marked corners on the boundary of the body that are no vertices of the mesh, as there was no vertex near enough that
  /// had no corner yet, or hexahedra were inverted or poor there; none if there is no valid mesh
  std::vector<std::array<double, 3> > corners_given_up;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_POLYCUBE_MESHING_3_HEXAHEDRAL_MESH_RESULT_H
