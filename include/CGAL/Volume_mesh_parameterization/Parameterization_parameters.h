// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_PARAMETERS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_PARAMETERS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

The ways in which a map meets its boundary: see the named parameter `boundary_mode` of
`CGAL::stretch_minimizing_volume_parameterization()`.
*/
enum class Boundary_mode
{
  AUTO,  ///< first `FIXED`; if no valid map is found, `SOFT`
  FIXED, ///< prescribed vertices are at their targets from the beginning, and cells are untangled
  SOFT   ///< no cell is ever inverted, and a penalty pulls the prescribed vertices to their targets
};

/*!
\ingroup PkgVolumeMeshParameterizationResults

Which vertices refinement may add: see the named parameter `refinement_mode` of
`CGAL::stretch_minimizing_volume_parameterization()`, and Section \ref VMPRefinement.

A new vertex on the boundary is the midpoint of an edge of the boundary, with coordinates rounded to their number type. Therefore,
it lies on the edge up to rounding, and in exact arithmetic it may be off the edge.
*/
enum class Refinement_mode
{
  NONE,   ///< none
  NEEDED, ///< only those without which the boundary is not reached
  /// also vertices in bridges that make the map slow or distorted; bridges are interior simplices with prescribed vertices only
  HELPFUL,
  /// also vertices on the boundary, at edges that `boundary_parameterizer` splits: for polycubes, and for fits with a tolerance.
  /// New vertices have the surface patch or the curve of the edge. If the refined boundary has no map, the boundary as given is
  /// mapped to its polycube
  BOUNDARY
};

/*!
\ingroup PkgVolumeMeshParameterizationResults

The parameters of the map with soft boundary, after section 4 of Jin et al.\ \cgalCite{cgal:jqzctz-smvp-15}.
The mean of \f$\psi\f$ over the cells plus \f$w\,|P(u)|^2\f$ is minimized for growing weights \f$w\f$. The vector \f$P(u)\f$
collects the distances of the prescribed vertices to their targets and the residuals of further linear constraints. Lengths are
measured on a copy of the problem in which the target has volume 1. The authors take the sum over the cells, and units as they
are. With mean and unit volume, the parameters depend neither on the number of cells nor on units.

The minimization for one weight ends as soon as one of three criteria holds: the energy, the positions, or the gradient have
become stationary. The weight is then raised unless the constraints are satisfied. Tolerances are not negative.
*/
struct Soft_boundary_parameters
{
  /// the first weight, \f$w_0\f$; positive and finite
  double weight = 100;
  /// the factor between a weight and the next one, \f$\gamma\f$; finite and larger than 1
  double weight_factor = 25;
  /// the maximal number of times that the weight is raised
  std::size_t maximum_number_of_raises = 5;
  /// the constraints are satisfied if \f$|P(u)|_2\f$ is at most this number, \f$\eta\f$, where the target has volume 1
  double residual_tolerance = 1e-6;

  /// the minimization for a weight ends if the energy changes by less than \f$\varepsilon_f\f$ times the diameter of the
  /// bounding box of the source
  double energy_tolerance = 1e-8;
  /// the minimization ends if the energy changes by less than this number times itself, both with the penalty; not in the paper
  double relative_energy_tolerance = 0;
  /// the minimization ends if no vertex moves by this number times the diameter
  double step_tolerance = 1e-8;
  /// the minimization ends if the norm of the gradient is less than this number times the energy
  double gradient_tolerance = 1e-6;
  /// whether a minimization with fixed boundary takes over as soon as the prescribed vertices can be put on their targets
  /// without inverting a cell. Without effect if there are further constraints.
  bool do_snap = true;

  /// the number of Newton steps in a row with the current positions as target. They are taken if the Hessian is not positive
  /// definite, or if no step decreases both the energy and the norm of its gradient. With 0, a decrease of the energy suffices.
  std::size_t maximum_number_of_relaxations = 5;
  /// whether each step uses the full Hessian, as the authors do. Otherwise, the Hessian of each cell loses its negative
  /// eigenvalues far from the minimum
  bool use_full_hessian = false;
};

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns parameters with one large weight that is never raised, for easy targets.
*/
inline Soft_boundary_parameters single_weight_soft_boundary_parameters(const double weight = 1e8)
{
  Soft_boundary_parameters parameters;
  parameters.weight = weight;
  parameters.maximum_number_of_raises = 0;
  return parameters;
}

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

returns parameters for a boundary that ends exactly at its targets. Many weights have a coarse minimization each, until a
minimization with fixed boundary can take over.
*/
inline Soft_boundary_parameters approaching_soft_boundary_parameters()
{
  Soft_boundary_parameters parameters;
  parameters.maximum_number_of_raises = 12;
  parameters.residual_tolerance = 0;
  parameters.relative_energy_tolerance = 3e-3;
  parameters.maximum_number_of_relaxations = 0;
  return parameters;
}

/*!
\ingroup PkgVolumeMeshParameterizationResults

A linear equation \f$\sum_k c_k \cdot u_{v_k} = p\f$ between the images of vertices: a row of the
positional constraints \f$P(u) = C u - p = 0\f$ of Jin et al.\ \cgalCite{cgal:jqzctz-smvp-15}, equation (7).

For example, the term `{v, n}` and the value `n.dot(q)` keep a vertex `v` on the plane through `q` with
normal `n`. The terms `{v, n}` and `{w, -n}` keep the distance of the vertices `v` and `w` in that
direction. The meaning of the residual is a distance if the coefficients have length 1.

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

/// \ingroup PkgVolumeMeshParameterizationResults
///
/// The value of the named parameter `maximum_angle_distortion` that makes the largest distortion of angles as small as possible.
/// A map without distortion of angles has this value.
constexpr double least_angle_distortion = 2;

/// \ingroup PkgVolumeMeshParameterizationResults
///
/// The value of the named parameter `reference_scale` that takes the scale from what is prescribed. If the boundary is prescribed,
/// it is that of equal volumes. If a part of the boundary is free, it is the median stretch of edges between vertices at their
/// targets, or of distances between other conditions.
constexpr double found_reference_scale = 0;

/// \ingroup PkgVolumeMeshParameterizationResults
/// The phases of a parameterization. With soft boundary, all steps are minimization.
enum class Phase
{
  START,       ///< before the first step
  BOUNDARY,    ///< a boundary parameterizer finds the images of the boundary
  /// edges of a fitted boundary are split. Who ends this phase ends it alone: the map to the boundary so far is found
  SPLITS,
  UNTANGLING,  ///< cells are inverted, and an energy that is finite for them is minimized
  MINIMIZATION, ///< no cell is inverted, and the energy is minimized
  HEXAHEDRA    ///< `make_hexahedral_mesh_3()` improves hexahedra
};

/// \ingroup PkgVolumeMeshParameterizationResults
/// The kinds of steps.
enum class Step_kind
{
  NEWTON, ///< a Newton step over all vertices that move
  PATCH,  ///< inverted cells with the cells around them are untangled, as a problem of their own
  ROUND,  ///< a round of a loop over the boundary or over hexahedra begins; it has a name, a number and a time only
  /// an attempt to untangle a patch with edges split, to find the necessary splits
  SPLIT
};

/*!
\ingroup PkgVolumeMeshParameterizationResults

The report of a step to a visitor: see the named parameter `visitor` of
`CGAL::stretch_minimizing_volume_parameterization()`.
*/
struct Parameterization_step
{
  std::size_t iteration = 0;                ///< number of steps so far, in all stages; rounds have numbers of their own
  Phase phase = Phase::START;               ///< the phase that the step belonged to
  Step_kind kind = Step_kind::NEWTON;       ///< the kind of the step; only `NEWTON` has energy, gradient, decrement and length
  std::string attempt;                      ///< the name of the stage or of the attempt to untangle, for a progress bar
  /// mean over the cells of the energy that the step lowered, with a penalty if the boundary is soft. While cells are untangled,
  /// it is the mean over the cells with a free vertex. Values of different phases and stages are not comparable
  double energy = 0;
  std::size_t number_of_inverted_cells = 0; ///< inverted or flat cells after the step, by floating-point determinants
  /// the Newton decrement at the beginning of the step: half of its square is about what there is to gain
  double decrement = 0;
  double gradient_norm = 0;                 ///< Euclidean norm of the gradient at the beginning of the step
  double step_length = 0;                   ///< 1 is a full Newton step, 0 means that no step was acceptable
  double seconds = 0;                       ///< wall-clock time since the beginning
};

/*!
\ingroup PkgVolumeMeshParameterizationResults

The default visitor, which does nothing.

\cgalModels{ParameterizationVisitor_3}
*/
struct Default_visitor
{
  /// returns `true`: the computation continues.
  bool after_step(const Parameterization_step&) { return true; }

  /// returns `true`: the computation continues.
  bool goes_on() { return true; }
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_PARAMETERS_H
