// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_RESULT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_RESULT_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>

#include <cstddef>
#include <limits>
#include <string>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

The distortions \f$D = (D_{aa}, D_{ma}, D_{av}, D_{mv})\f$ of a map as in
Jin et al.\ \cgalCite{cgal:jqzctz-smvp-15}, section 5. They are the mean and the maximum over the cells of the distortion of
angles \f$\sigma_1/\sigma_3 + \sigma_3/\sigma_1\f$ and of volumes \f$\det J + 1/\det J\f$. Here,
\f$\sigma_1 \ge \sigma_2 \ge \sigma_3\f$ are the singular values of the differential \f$J\f$ of the map in a cell. In the means,
a cell is weighted by its volume in the source. The values have no unit. The minimum is 2, without distortion. If rounding makes
a cell of the image flat, a value is infinite. Without a valid map, the values are not numbers.
*/
struct Distortion_3
{
  double angle_mean = std::numeric_limits<double>::quiet_NaN();  ///< the mean distortion of angles, \f$D_{aa}\f$
  double angle_max = std::numeric_limits<double>::quiet_NaN();   ///< the largest distortion of angles, \f$D_{ma}\f$
  double volume_mean = std::numeric_limits<double>::quiet_NaN(); ///< the mean distortion of volumes, \f$D_{av}\f$
  double volume_max = std::numeric_limits<double>::quiet_NaN();  ///< the largest distortion of volumes, \f$D_{mv}\f$
};

/*!
\ingroup PkgVolumeMeshParameterizationResults

The distortions of one cell by a map with the differential \f$J\f$ there, as in `Distortion_3`. They have no unit; for
inverted cells, where \f$\det J\f$ is negative, those of angles and volumes are not defined.
*/
struct Cell_distortion_3
{
  double angle;  ///< the distortion of angles, 2 at least
  double volume; ///< the distortion of volumes, 2 at least
  double det_J;  ///< the volume of the image relative to that of the cell
};

/*!
\ingroup PkgVolumeMeshParameterizationResults

The worst shapes of tetrahedra, by measures of simulations. Without a cell, the values are not numbers.
*/
struct Cell_quality_3
{
  double smallest_dihedral_angle = std::numeric_limits<double>::quiet_NaN(); ///< in degrees; 70.5 if all cells are regular
  double largest_dihedral_angle = std::numeric_limits<double>::quiet_NaN();  ///< in degrees; 70.5 if all cells are regular
  /// \f$\sqrt{2}\f$ times the determinant of the three edges at a vertex, divided by the product of their lengths. The value is
  /// the least of all vertices of all cells: 1 if all cells are regular, 0 if one is flat
  double minimum_scaled_jacobian = std::numeric_limits<double>::quiet_NaN();
  /// the longest edge of a cell by \f$2\sqrt{6}\f$ times the radius of its inscribed sphere; 1 if all cells are regular
  double largest_aspect_ratio = std::numeric_limits<double>::quiet_NaN();
};

/*!
\ingroup PkgVolumeMeshParameterizationResults

The result of `CGAL::stretch_minimizing_volume_parameterization()`. Times are wall-clock times in seconds.
*/
struct Parameterization_result
{
  Error_code status = OK;     ///< how the computation ended
  bool has_valid_map = false; ///< whether the map, one without inverted cells, has been written
  std::string message;        ///< sentences about the status, with data such as an index or a volume

  std::size_t number_of_vertices = 0;          ///< vertices of cells, including added ones
  std::size_t number_of_cells = 0;             ///< cells of the complex, after refinement
  std::size_t number_of_boundary_vertices = 0; ///< vertices of facets between the complex and the outside
  std::size_t number_of_added_vertices = 0;    ///< vertices that refinement has added
  std::size_t number_of_added_boundary_vertices = 0; ///< those of them at edges of the boundary (see `Refinement_mode::BOUNDARY`)
  /// vertices that slide on the boundary with `do_slide_boundary(true)`, or stay in planes or on lines by their conditions
  std::size_t number_of_sliding_vertices = 0;

  /// whether a boundary that is partly free intersects itself. Such a map is valid, but only locally one to one. If the time
  /// limit ends the comparison of facets, the value is `false`.
  bool boundary_crosses_itself = false;

  /// number of exact proofs that no map with this connectivity meets this boundary; one suffices
  std::size_t number_of_infeasibility_proofs = 0;

  std::size_t number_of_inverted_cells_at_start = 0; ///< inverted cells of the harmonic or the initial map
  std::size_t number_of_inverted_cells = 0;          ///< inverted or flat cells of the result, by exact predicates
  /// largest distance to the prescribed points, relative to the diagonal of their bounding box; not a number without a valid map.
  /// For sliding vertices, it is the distance to the plane or line through their point, and rounding errors count as 0.
  double boundary_residual = std::numeric_limits<double>::quiet_NaN();

  std::size_t number_of_iterations = 0;            ///< Newton steps, in all stages
  std::size_t number_of_untangling_iterations = 0; ///< Newton steps that untangled

  std::size_t number_of_linear_solver_iterations = 0; ///< iterations in all stages; 0 if the solver counts none

  /// name of the method that found the first map without inverted cells. This is the harmonic extension of the boundary alone,
  /// patches of cells, one of the settings of untangling, or the soft boundary
  std::string untangling_method;

  /// mean of \f$\psi\f$ over the cells, weighted as in the minimization; not a number without a valid map. Both meshes are scaled
  /// to one volume. If a part of the boundary is free, the conditions prescribe the scale.
  double energy = std::numeric_limits<double>::quiet_NaN();
  Distortion_3 distortion;                  ///< distortion of the map as it is; not numbers without a valid map
  Distortion_3 distortion_at_source_volume; ///< distortion of the map scaled as for the energy
  Cell_quality_3 quality;                   ///< shapes of the cells of the image; not numbers without a valid map
  /// distortion of the map of the boundary: the mean over its area of the root of \f$\log^2 s + \log^2 t\f$. The map is scaled to
  /// the area of the boundary, and \f$s\f$ and \f$t\f$ are its singular values. A similarity has 0, a close polycube 0.1 to 0.5,
  /// and a box as the image of a branching body 1 or more. Not a number without a valid map, and for distributed meshes
  double boundary_distortion = std::numeric_limits<double>::quiet_NaN();

  /// proved lower bound of the largest distortion of angles of all maps with these prescribed vertices;
  /// 0 unless `minimize_maximum_angle_distortion(true)` was passed
  double unavoidable_angle_distortion = 0;
  /// largest bound below which no map was found. The least distortion seems to be between this bound and that of the
  /// map. Only `unavoidable_angle_distortion` is a proved lower bound.
  double missed_angle_distortion = 0;

  double seconds_total = 0;        ///< time of the call
  double seconds_boundary = 0;     ///< time of the boundary parameterizer, if the call has one
  double seconds_to_flip_free = 0; ///< time until no cell was inverted, or untangling ended
  double seconds_numbering = 0;    ///< conversion of the complex to arrays, with the checks of the input
  double seconds_start = 0;        ///< set-up and harmonic map
  double seconds_untangling = 0;   ///< Newton steps that untangled
  double seconds_minimization = 0; ///< Newton steps that minimized
  double seconds_check = 0;        ///< exact check and distortions
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_RESULT_H
