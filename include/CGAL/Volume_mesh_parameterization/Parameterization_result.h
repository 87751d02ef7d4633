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

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

The ways in which a parameterization can end.

With `OK`, `OK_WITHIN_TOLERANCE`, `ERROR_NOT_CONVERGED`, `ERROR_ANGLE_BOUND_NOT_REACHED` and `ERROR_BOUNDARY_NOT_REACHED`, there
is a map without inverted cells. With `ERROR_INTERRUPTED` and `ERROR_LINEAR_SOLVER_FAILED`, there may be one:
`Parameterization_result::has_valid_map` reports it. With the other values, there is none. The values from
`ERROR_NON_MANIFOLD_BOUNDARY` to `ERROR_FIT_TOLERANCE_NOT_REACHED` come from models of `BoundaryParameterizer_3`. The last six are
codes of the package \ref Chapter_Polycube_Meshing_3 "Polycube Meshing". They are in this list because the call for a map returns
the status of its boundary parameterizer. Hexahedra also share the codes for bad input.
*/
enum Error_code
{
  OK = 0,                        ///< the map has no inverted cell, meets the boundary exactly, and is a minimizer
  OK_WITHIN_TOLERANCE,           ///< the same with a soft boundary that is met up to `residual_tolerance`, as in the paper
  ERROR_NOT_CONVERGED,           ///< the map is valid, but the minimization of the energy did not come to its end
  ERROR_INTERRUPTED,             ///< the visitor or the time limit ended the computation
  ERROR_ANGLE_BOUND_NOT_REACHED, ///< the map is valid, but the distortion of angles exceeds the bound in some cell
  ERROR_BOUNDARY_NOT_REACHED,    ///< the map has no inverted cell, but does not meet the boundary
  ERROR_NOT_FLIP_FREE,           ///< no map without inverted cells was found
  ERROR_INVERTED_BY_ROUNDING,    ///< the type in which images are stored, `float` for instance, is too coarse for the map
  ERROR_LINEAR_SOLVER_FAILED,    ///< the linear solver failed
  ERROR_EMPTY_COMPLEX,           ///< the complex has no cell
  ERROR_NON_FINITE_COORDINATE,   ///< a coordinate is infinite or not a number
  ERROR_SIZE_OUT_OF_RANGE,       ///< the diagonal of source or target is not between 1e-70 and 1e70
  ERROR_INVERTED_SOURCE_CELL,    ///< a cell of the source has no positive volume
  ERROR_MISSING_BOUNDARY_TARGET, ///< a boundary vertex has no target
  ERROR_INVERTED_TARGET_BOUNDARY,///< the target boundary is flat, or turned inside out
  ERROR_PRESCRIBED_CELL_INVERTED,///< the prescribed vertices alone make a cell of the target flat or invert it
  ERROR_ENERGY_WITHOUT_MINIMUM,  ///< a part of the boundary is free, and the energy has no minimum then
  ERROR_NON_MANIFOLD_BOUNDARY,       ///< the boundary is not a manifold at its `non_manifold_boundary_vertices()`
  ERROR_SEVERAL_BOUNDARY_COMPONENTS, ///< the boundary of the complex has several connected components
  ERROR_BOUNDARY_NOT_OF_GENUS_ZERO,  ///< the boundary of the complex has handles
  ERROR_BOUNDARY_TOO_COARSE,         ///< the boundary has not enough vertices for the edges of the target
  ERROR_BOUNDARY_MAP_NOT_BIJECTIVE,  ///< rounding made the map of the boundary not one to one
  ERROR_OTHER_CONNECTIVITY,          ///< the surface for the target has another connectivity than the boundary
  ERROR_INVALID_CORNERS,             ///< the corners of a cube are not eight different vertices of the boundary
  ERROR_MIRRORED_CORNERS,            ///< the corners of a cube fit its mirror image
  ERROR_INVALID_LANDMARK,            ///< a landmark of a ball is no vertex of the boundary, or its point is not finite
  ERROR_TARGET_NOT_A_SPHERE,         ///< the surface to fit to is not closed, not a manifold, not connected or has handles
  ERROR_BOUNDARY_NOT_FITTED,         ///< on the surface to fit to, facets of the boundary are turned over or intersect others
  ERROR_FIT_TOLERANCE_NOT_REACHED,   ///< the boundary would need too many vertices to be as close to the surface to fit to
  // codes of the package Polycube_meshing_3
  ERROR_NO_POLYCUBE,                 ///< no polycube was found, or none with the labels given
  ERROR_SPACING_TOO_COARSE,          ///< the faces of a polycube cannot have different multiples of the spacing
  ERROR_DOMAIN_NOT_AXIS_PARALLEL,    ///< a boundary facet of the domain of hexahedra is not orthogonal to an axis
  ERROR_INVERTED_HEXAHEDRON,         ///< the Jacobian determinant of a hexahedron is not positive all over it
  ERROR_POOR_HEXAHEDRON,             ///< the hexahedra are valid, but a scaled Jacobian is below the bound
  ERROR_INCOMPLETE_HEXAHEDRA         ///< the hexahedra are valid, but deviate from the body or its subdomains
};

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns a sentence that explains the code. The text is static: it need not be freed.
*/
inline const char* get_error_message(const Error_code code)
{
  switch(code)
  {
    case OK: return "Success.";
    case OK_WITHIN_TOLERANCE: return "Success: the soft boundary meets its targets within its tolerance.";
    case ERROR_NOT_CONVERGED: return "The map is valid, but the minimization ended before its energy was minimal.";
    case ERROR_INTERRUPTED: return "The visitor or the time limit ended the computation.";
    case ERROR_ANGLE_BOUND_NOT_REACHED:
      return "The map is valid, but the distortion of angles is not below the bound in every cell.";
    case ERROR_BOUNDARY_NOT_REACHED: return "The map has no inverted cell, but it does not meet the boundary.";
    case ERROR_NOT_FLIP_FREE: return "No map without inverted cells was found for this boundary and this connectivity.";
    case ERROR_INVERTED_BY_ROUNDING:
      return "Rounding the images to their type inverts cells. Store them as double, or move the target nearer to the origin.";
    case ERROR_LINEAR_SOLVER_FAILED: return "The linear solver failed. Use another one.";
    case ERROR_EMPTY_COMPLEX: return "The complex has no cell.";
    case ERROR_NON_FINITE_COORDINATE: return "A coordinate is infinite or not a number.";
    case ERROR_SIZE_OUT_OF_RANGE:
      return "The source or the target is too large or too small for floating-point numbers. Scale it.";
    case ERROR_INVERTED_SOURCE_CELL: return "A cell of the source has no positive volume.";
    case ERROR_MISSING_BOUNDARY_TARGET: return "A boundary vertex has no target.";
    case ERROR_INVERTED_TARGET_BOUNDARY:
      return "The target boundary is flat or turned inside out: it encloses no positive volume.";
    case ERROR_PRESCRIBED_CELL_INVERTED:
      return "The prescribed vertices alone make a cell of the target flat or invert it.";
    case ERROR_ENERGY_WITHOUT_MINIMUM:
      return "A part of the boundary is free, but the energy has no minimum for a free boundary.";
    case ERROR_NON_MANIFOLD_BOUNDARY:
      return "The boundary of the complex is not a manifold: cells meet in a vertex or an edge only. Around such a vertex, give "
             "each set of cells that facets connect a vertex of its own.";
    case ERROR_SEVERAL_BOUNDARY_COMPONENTS: return "The boundary of the complex has several connected components.";
    case ERROR_BOUNDARY_NOT_OF_GENUS_ZERO:
      return "The boundary of the complex has handles, but it must be a topological sphere.";
    case ERROR_BOUNDARY_TOO_COARSE:
      return "The boundary has too few vertices for the edges of the target. Refine the boundary or choose another target.";
    case ERROR_BOUNDARY_MAP_NOT_BIJECTIVE: return "After rounding, the map of the boundary is not one to one.";
    case ERROR_OTHER_CONNECTIVITY:
      return "The surface for the target and the boundary of the complex have different connectivities.";
    case ERROR_INVALID_CORNERS:
      return "The corners of a cube must be eight different vertices of the boundary of the complex.";
    case ERROR_MIRRORED_CORNERS:
      return "The corners are those of a mirrored cube. Exchange opposite faces along one axis, for instance corners "
             "0 and 1, 2 and 3, 4 and 5, 6 and 7.";
    case ERROR_INVALID_LANDMARK:
      return "Each landmark must be a vertex of the boundary of the complex, and its point must be finite.";
    case ERROR_TARGET_NOT_A_SPHERE:
      return "The target surface must be a topological sphere: closed, connected, and without handles. Repair it, or choose "
             "another target.";
    case ERROR_BOUNDARY_NOT_FITTED:
      return "On the target surface, facets of the boundary would be turned over or intersect each other. Thin limbs are "
             "the usual cause: compose maps of both bodies to a ball instead, as the example body_to_body.cpp does.";
    case ERROR_FIT_TOLERANCE_NOT_REACHED:
      return "The boundary would need too many vertices to be as close to the target surface as the tolerance. Use a larger one.";
    case ERROR_NO_POLYCUBE:
      return "No polycube was found for the boundary, or for the given labels of its facets. Permit splits of boundary edges: "
             "refinement_mode(Refinement_mode::BOUNDARY). If they are permitted, simplify the boundary.";
    case ERROR_SPACING_TOO_COARSE:
      return "At multiples of the spacing, faces of the polycube would merge. Make the spacing smaller.";
    case ERROR_DOMAIN_NOT_AXIS_PARALLEL:
      return "A boundary facet of the domain is not orthogonal to an axis. Map the body to a box or a polycube.";
    case ERROR_INVERTED_HEXAHEDRON:
      return "A hexahedron is flat or inverted at a corner or inside.";
    case ERROR_POOR_HEXAHEDRON:
      return "The hexahedra are valid, but the scaled Jacobian of one is below the bound.";
    case ERROR_INCOMPLETE_HEXAHEDRA:
      return "The hexahedra are valid, but deviate from the body. Make the spacing smaller, or map the body with less "
             "distortion there. If the domain lacks a part of the body, choose another domain.";
  }
  return "Unknown error code.";
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// The exception of functions that read files or take arrays. `what()` is one sentence with the place and the kind of the fault.
class Input_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

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
  double minimum_dihedral_angle = std::numeric_limits<double>::quiet_NaN(); ///< in degrees; 70.5 if all cells are regular
  double maximum_dihedral_angle = std::numeric_limits<double>::quiet_NaN();  ///< in degrees; 70.5 if all cells are regular
  /// \f$\sqrt{2}\f$ times the determinant of the three edges at a vertex, divided by the product of their lengths. The value is
  /// the least of all vertices of all cells: 1 if all cells are regular, 0 if one is flat
  double minimum_scaled_jacobian = std::numeric_limits<double>::quiet_NaN();
  /// the longest edge of a cell by \f$2\sqrt{6}\f$ times the radius of its inscribed sphere; 1 if all cells are regular
  double maximum_aspect_ratio = std::numeric_limits<double>::quiet_NaN();
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
  /// vertices that slide on the boundary with `do_slide_boundary(true)`, or by their conditions stay in planes, on lines or on
  /// surfaces
  std::size_t number_of_sliding_vertices = 0;

  /// whether a boundary that is partly free, or slides on curved surfaces, intersects itself. Such a map is valid, but only
  /// locally one to one. If the time limit ends the comparison of facets, the value is `false`.
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

  /// name of the method that found the first map without inverted cells. This is the harmonic extension of the boundary,
  /// patches of cells, one of the settings of untangling, or the soft boundary
  std::string untangling_method;

  /// the scale of the source at which its cells have the least energy: see the named parameter `reference_scale`; not a number
  /// without a valid map
  double reference_scale = std::numeric_limits<double>::quiet_NaN();
  /// mean of \f$\psi\f$ over the cells at the scale of reference, weighted as in the minimization; not a number without a valid
  /// map
  double energy = std::numeric_limits<double>::quiet_NaN();
  Distortion_3 distortion;                  ///< distortion of the map as it is; not numbers without a valid map
  Distortion_3 distortion_at_source_volume; ///< distortion of the map scaled as for the energy
  Cell_quality_3 quality;                   ///< shapes of the cells of the image; not numbers without a valid map
  /// distortion of the map of the boundary: the mean over its area of the root of \f$\log^2 s + \log^2 t\f$. The map is scaled to
  /// the area of the boundary, and \f$s\f$ and \f$t\f$ are its singular values. A similarity has 0, a close polycube 0.1 to 0.5,
  /// and a box as the image of a branching body 1 or more. Not a number without a valid map, and for distributed meshes
  double boundary_distortion = std::numeric_limits<double>::quiet_NaN();

  /// proved lower bound of the largest distortion of angles of all maps with these prescribed vertices;
  /// 0 unless `maximum_angle_distortion(least_angle_distortion)` was passed
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
