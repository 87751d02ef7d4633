// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_ERROR_CODE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_ERROR_CODE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <stdexcept>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

The ways in which a parameterization can end.

With `OK`, `OK_WITHIN_TOLERANCE`, `ERROR_NOT_CONVERGED`, `ERROR_ANGLE_BOUND_NOT_REACHED` and `ERROR_BOUNDARY_NOT_REACHED` there
is a map without inverted cells, with `ERROR_INTERRUPTED` and `ERROR_LINEAR_SOLVER_FAILED` there may be one: see
`Parameterization_result::has_valid_map`. With the other values there is none. The values from
`ERROR_NON_MANIFOLD_BOUNDARY` on come from models of `BoundaryParameterizer_3`, the last three from
`Volume_mesh_parameterization::make_hexahedral_mesh_3()`.
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
  ERROR_NO_POLYCUBE,                 ///< no polycube was found, or none with the labels given
  ERROR_INVALID_CORNERS,             ///< the corners of a cube are not eight different vertices of the boundary
  ERROR_MIRRORED_CORNERS,            ///< the corners of a cube fit its mirror image
  ERROR_INVALID_LANDMARK,            ///< a landmark of a ball is no vertex of the boundary, or its point is not finite
  ERROR_SPACING_TOO_COARSE,          ///< the faces of a polycube cannot have different multiples of the spacing
  ERROR_DOMAIN_NOT_AXIS_PARALLEL,    ///< a boundary facet of the domain of hexahedra is not orthogonal to an axis
  ERROR_INVERTED_HEXAHEDRON,         ///< the Jacobian determinant of a hexahedron is not positive all over it
  ERROR_POOR_HEXAHEDRON,             ///< the hexahedra are valid, but a scaled Jacobian is below the bound
  ERROR_INCOMPLETE_HEXAHEDRA         ///< the hexahedra are valid, but leave out a subdomain or a part of the body
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
    case ERROR_NO_POLYCUBE:
      return "No polycube was found for the boundary, or for the given labels of its facets.";
    case ERROR_INVALID_CORNERS:
      return "The corners of a cube must be eight different vertices of the boundary of the complex.";
    case ERROR_MIRRORED_CORNERS:
      return "The corners are those of a mirrored cube. Exchange opposite faces along one axis, for instance corners "
             "0 and 1, 2 and 3, 4 and 5, 6 and 7.";
    case ERROR_INVALID_LANDMARK:
      return "Each landmark must be a vertex of the boundary of the complex, and its point must be finite.";
    case ERROR_SPACING_TOO_COARSE:
      return "At multiples of the spacing, faces of the polycube would merge. Make the spacing smaller.";
    case ERROR_DOMAIN_NOT_AXIS_PARALLEL:
      return "A boundary facet of the domain is not orthogonal to an axis. Map the body to a box or a polycube.";
    case ERROR_INVERTED_HEXAHEDRON:
      return "A hexahedron is flat or inverted at a corner or inside.";
    case ERROR_POOR_HEXAHEDRON:
      return "The hexahedra are valid, but the scaled Jacobian of one is below the bound.";
    case ERROR_INCOMPLETE_HEXAHEDRA:
      return "The hexahedra are valid, but leave out a part of the body. Map the body with less distortion there, or to a "
             "domain that has this part. If the part is thinner than the spacing, make the spacing smaller.";
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

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_ERROR_CODE_H
