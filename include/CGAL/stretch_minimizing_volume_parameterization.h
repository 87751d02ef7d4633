// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_STRETCH_MINIMIZING_VOLUME_PARAMETERIZATION_H
#define CGAL_STRETCH_MINIMIZING_VOLUME_PARAMETERIZATION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Arrays/volume_parameterization_of_arrays.h>
#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Vertex_point_map.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Vertex_insertion_3.h>

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_NAMED_PARAMETERS
#  error "The include directory of Volume_mesh_parameterization must precede the one of CGAL."
#endif

namespace CGAL {

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

computes a map from a tetrahedral complex to a domain with prescribed boundary that has no inverted cell and a low
distortion of angles and volumes. The map is linear on each cell and given by the images of the vertices.

The method is the stretch-minimizing parameterization of Jin et al.\ \cgalCite{cgal:jqzctz-smvp-15}. With fixed boundary, a
harmonic map is untangled \cgalCite{cgal:gkkrs-ffm-21} and a distortion energy minimized by Newton steps that never invert a
cell. With soft boundary, the method of the paper, no cell is ever inverted, and the boundary may be missed. At the end,
exact predicates on the coordinates that are written check that no cell is inverted.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
        `Sequential_tag`, `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it.
\tparam C3t3 a model of `MeshComplex_3InTriangulation_3`; if it is not `const`, of
        `MeshComplexWithFeatures_3InTriangulation_3` too
\tparam VertexUVWMap a model of `WritablePropertyMap` with `C3t3::Vertex_handle` as key type and
        `C3t3::Triangulation::Geom_traits::Point_3` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param c3t3 the complex; it is modified only if it may be refined (see `do_refine`), and may be constant otherwise. Its
       cells may have several subdomains and connected components; vertices without a cell are ignored.
\param uvw_map receives the image of each vertex of a cell of the complex, if the map is valid
       (see `Parameterization_result::has_valid_map`); otherwise it is left alone. If its points have coordinates of a type
       narrower than `double`, as those of `Simple_cartesian<float>`, targets are rounded to this type before the computation,
       and images before the exact check. If rounding inverts cells, vertices inside move by a few units in the last place;
       if this does not help, the status is `ERROR_INVERTED_BY_ROUNDING`.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{boundary_map}
    \cgalParamDescription{the image of each vertex of the boundary of the complex}
    \cgalParamType{a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
                   `C3t3::Triangulation::Geom_traits::Point_3` as value type}
    \cgalParamDefault{the images that `boundary_parameterizer` finds}
    \cgalParamExtra{A point with a coordinate that is not a number stands for a missing target. For a container, pass
                    `Volume_mesh_parameterization::make_vertex_point_map()`: the map of
                    `boost::make_assoc_property_map()` inserts a point without values for each vertex that has been
                    forgotten, which is undefined behavior and may end as `OK`. Prescribed vertices receive exactly
                    the points given, those of an exact kernel rounded to `double`, and all rounded to the number
                    type of `uvw_map`, unless they slide or the boundary
                    is missed.}
  \cgalParamNEnd
  \cgalParamNBegin{boundary_parameterizer}
    \cgalParamDescription{finds the image of each vertex of the boundary, such that the user needs no map for them}
    \cgalParamType{a model of `BoundaryParameterizer_3`}
    \cgalParamDefault{`Volume_mesh_parameterization::Ball_boundary_parameterizer_3()`}
    \cgalParamExtra{Where it finds none, the result has the status that it returns. Its time is
                    `Parameterization_result::seconds_boundary`, and `Parameterization_result::boundary_distortion` tells
                    how far the images are from the boundary.}
    \cgalParamPrecondition{`boundary_map` is not given; otherwise the program is not compiled.}
  \cgalParamNEnd
  \cgalParamNBegin{initial_map}
    \cgalParamDescription{the images of the vertices at which the search starts, for instance of a map to a similar boundary}
    \cgalParamType{a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
                   `C3t3::Triangulation::Geom_traits::Point_3` as value type}
    \cgalParamDefault{the harmonic map}
    \cgalParamExtra{Vertices with a target are moved there, and the displacements are extended to the others by a harmonic
                    function. If cells are inverted then, they are untangled; if untangling fails, the search starts again
                    without an initial map. A point with a coordinate that is not a number stands for a missing image, also
                    of a vertex that refinement has inserted: the start is harmonic there. Infinite
                    coordinates are answered by `ERROR_NON_FINITE_COORDINATE`. A soft boundary ignores the initial map.
                    `initial_map` is read before `uvw_map` is written, so both may be the same.}
  \cgalParamNEnd
  \cgalParamNBegin{energy}
    \cgalParamDescription{the energy whose mean over the cells is minimized}
    \cgalParamType{a model of `DistortionEnergy_3`}
    \cgalParamDefault{`Volume_mesh_parameterization::Stretch_energy_3()`}
    \cgalParamExtra{The energy is evaluated with source and target scaled to the same volume.}
  \cgalParamNEnd
  \cgalParamNBegin{use_volume_weights}
    \cgalParamDescription{whether a cell counts by its volume in the source, as in the mean distortions of
                          `Volume_mesh_parameterization::Distortion_3`; otherwise all cells count alike, as in the
                          paper}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{use_regular_references}
    \cgalParamDescription{whether each image of a cell is compared with a regular tetrahedron in place of the cell, all of
                          one size: cells of the source may be inverted or flat then, as of the source only its connectivity
                          counts. A tangled mesh gets positive cells within its own boundary if its own points are the
                          boundary map and the initial map (\ref VMPTangled).}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
    \cgalParamExtra{The boundary is fixed then, whatever `boundary_mode` is, and distortions are those of the images of regular
                    cells. `Volume_mesh_parameterization::MIPS_energy_3` does not compare sizes, so small cells stay small.
                    Cells around a facet lie on different sides of it by the order of their vertices, also where they are
                    inverted.}
  \cgalParamNEnd
  \cgalParamNBegin{energy_tolerance}
    \cgalParamDescription{the part of the energy that does not matter: the minimization ends when five Newton steps gain
                          less than this part, or a step promises less than a hundredth of it}
    \cgalParamType{`double`}
    \cgalParamDefault{`0.001`}
    \cgalParamExtra{With 0, the minimization continues to a minimum, which may take hundreds of steps for the last percent.}
    \cgalParamPrecondition{The value is not negative.}
  \cgalParamNEnd
  \cgalParamNBegin{maximal_angle_distortion}
    \cgalParamDescription{a bound for the distortion of angles \f$\sigma_1/\sigma_3 + \sigma_3/\sigma_1\f$ of every cell}
    \cgalParamType{`double`}
    \cgalParamDefault{no bound}
    \cgalParamExtra{After the minimization, `Volume_mesh_parameterization::Bounded_angle_energy_3` is minimized further
                    if a cell exceeds the bound: relaxed as long as one does, then as a barrier that no cell passes.
                    The status tells whether the bound is met, and the distortion of
                    `Volume_mesh_parameterization::Parameterization_result` what is reached. Prescribed facets may force more than
                    the bound; then the message says so. Ignored if the boundary is missed.}
    \cgalParamPrecondition{The value is larger than 2.}
  \cgalParamNEnd
  \cgalParamNBegin{minimize_maximal_angle_distortion}
    \cgalParamDescription{whether the largest distortion of angles is made as small as possible, up to 2 %}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
    \cgalParamExtra{Bounds as for `maximal_angle_distortion` are tried by bisection, which takes several times as long as
                    the minimization; the result is the map of least energy below the lowest bound that is met.
                    `Volume_mesh_parameterization::Parameterization_result` has the largest bound that was missed.
                    Ignored if the boundary is missed.}
  \cgalParamNEnd
  \cgalParamNBegin{solver_traits}
    \cgalParamDescription{the solver for the linear system of a Newton step}
    \cgalParamType{a model of `NewtonSolverTraits_3`, passed by `std::ref()` if it keeps a state of interest}
    \cgalParamDefault{`Volume_mesh_parameterization::Conjugate_gradient_solver_traits_3<ConcurrencyTag>`}
  \cgalParamNEnd
  \cgalParamNBegin{boundary_mode}
    \cgalParamDescription{the way in which the boundary is met}
    \cgalParamType{`Volume_mesh_parameterization::Boundary_mode`}
    \cgalParamDefault{`Boundary_mode::AUTO`: fixed, and soft if no valid map with fixed boundary is found}
  \cgalParamNEnd
  \cgalParamNBegin{do_refine}
    \cgalParamDescription{whether the complex may be refined where the boundary cannot be reached otherwise:
                          before the computation, as `Volume_mesh_parameterization::make_parameterizable()` does
                          for this boundary map, where few cells stay inverted with fixed boundary, and while a soft
                          boundary approaches its targets, by splitting interior edges of the cells that block it; and
                          in bridges (see `refinement_mode`). The new vertices receive their images too.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`true` where a boundary parameterizer finds the images and the complex, or the arrays, are not
                      constant; `false` where the images are given}
    \cgalParamExtra{The boundary of the complex does not change, unless `Refinement_mode::BOUNDARY` is passed. Edges are split
                    as long as not more than a tenth of the vertices, or 1000 of a small complex, has been added. The complex
                    stays refined whatever the status is.}
    \cgalParamPrecondition{`c3t3` is not constant, whatever the value is; otherwise the program is not compiled.}
  \cgalParamNEnd
  \cgalParamNBegin{refinement_mode}
    \cgalParamDescription{which vertices refinement may add: those that are needed to reach the boundary, or also those that
                          help, in bridges: edges, facets and cells inside whose vertices are all prescribed, as across a
                          gap or a wall that is one cell wide. All bridges are split at once if one has a vertex of a
                          cell that is inverted where the search starts, or of a cell with four prescribed vertices and
                          a distortion of angles above 10. With `Refinement_mode::BOUNDARY`, `boundary_parameterizer` may
                          split edges of the boundary, too.}
    \cgalParamType{`Volume_mesh_parameterization::Refinement_mode`}
    \cgalParamDefault{`Refinement_mode::HELPFUL`}
    \cgalParamExtra{This takes one solution of a linear system, and time O(n + m d (d + log m)) for n cells and m bridges,
                    with at most d cells around an edge. The number of new vertices is not limited, but at most that of
                    bridges. Without refinement, or with `Boundary_mode::SOFT`, bridges are not split.
                    A new vertex on the boundary is at the midpoint of an edge, up to rounding, and has the surface patch or
                    curve of the edge. The refined boundary is held first, in at most a third of the time; if this fails, edges
                    inside that begin at it are split, too; and if this fails, the boundary as given is mapped, in the last quarter
                    of the time. Rounding may make cells of the triangulation outside of the complex flat or inverted.
                    `Polycube_boundary_parameterizer_3` alone splits edges of the boundary.}
    \cgalParamPrecondition{`c3t3` is not constant, whatever the value is; otherwise the program is not compiled.}
  \cgalParamNEnd
  \cgalParamNBegin{do_slide_boundary}
    \cgalParamDescription{whether vertices of the boundary may leave their targets, and slide, where the boundary that
                          the targets describe is planar. As soon as a map with the boundary at its targets inverts no cell,
                          a vertex whose facets are coplanar moves in their plane, one whose facets lie in two planes along
                          their common line, and every other one stays. Inside of a plane, vertices of sharp edges
                          of the body whose targets lead along an axis move along it only, as lines of polycubes do
                          (\ref VMPBoundaryTarget). So the images of planar regions, of the edges
                          between them and of the complex remain the same, and remain one to one.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
    \cgalParamExtra{Neighboring facets are in one region if they are exactly coplanar, or enclose an angle below 0.001. A
                    region is planar if its vertices are in its plane up to 1e-7 times the diagonal of the bounding box;
                    they move parallel to the plane. In a plane orthogonal to an axis, the coordinate along the axis keeps
                    its bits. Vertices of `vertex_is_constrained_map` stay at their targets, also on the boundary. No
                    vertex slides if the boundary is missed.}
  \cgalParamNEnd
  \cgalParamNBegin{soft_boundary_parameters}
    \cgalParamDescription{the parameters of the map with soft boundary}
    \cgalParamType{`Volume_mesh_parameterization::Soft_boundary_parameters`}
    \cgalParamDefault{those of the paper for `Boundary_mode::SOFT`, and otherwise
                      `Volume_mesh_parameterization::approaching_soft_boundary_parameters()`}
    \cgalParamPrecondition{The weight is positive, the factor larger than 1, and both are finite.}
  \cgalParamNEnd
  \cgalParamNBegin{positional_constraints}
    \cgalParamDescription{further linear equations between the images of vertices, for `Boundary_mode::SOFT`}
    \cgalParamType{`std::vector<Volume_mesh_parameterization::Linear_constraint_3<C3t3::Vertex_handle> >`}
    \cgalParamDefault{none}
    \cgalParamExtra{With constraints, prescribed vertices come near their targets, but are never put on them. If the norm
                    of all residuals is at most `Soft_boundary_parameters::residual_tolerance`, the status is
                    `OK_WITHIN_TOLERANCE`, and otherwise `ERROR_BOUNDARY_NOT_REACHED`; `boundary_residual` tells how near
                    the vertices are.}
    \cgalParamPrecondition{The vertices belong to cells of the complex; otherwise `std::out_of_range` is thrown.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{a map that is `true` for the vertices inside the complex that `boundary_map` prescribes as well,
                          and for vertices of the boundary that must not slide}
    \cgalParamType{a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and `bool` as value type}
    \cgalParamDefault{a constant property map returning `false`}
    \cgalParamPrecondition{`boundary_map` is given as well.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_condition_map}
    \cgalParamDescription{what the image of each vertex may do, on the boundary and inside: it is at its target, in the plane or on
                          the line through its target with a given direction, or free}
    \cgalParamType{a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
                   `Volume_mesh_parameterization::Vertex_condition_3` as value type}
    \cgalParamDefault{vertices of the boundary are at their targets, vertices inside are free}
    \cgalParamExtra{Targets are those of `boundary_map`; that of a free vertex is not read. Where a plane is orthogonal to an axis,
                    or a line is along an axis, a coordinate of the target that is not prescribed may be no number. If a
                    part of the boundary is free, the search starts from the complex, rotated and translated such that it is
                    nearest to what is prescribed. The complex is scaled by the median stretch of the edges between vertices
                    at their targets; without such edges, by the nearest similarity if at least four vertices have a condition.
                    The energy must have a minimum then (see `DistortionEnergy_3`), or the status is
                    `ERROR_ENERGY_WITHOUT_MINIMUM`. `Parameterization_result::boundary_crosses_itself` tells whether the free
                    boundary intersects itself. Refinement also splits edges, facets and cells inside whose vertices the conditions
                    keep in the plane of a facet of the boundary.}
    \cgalParamPrecondition{`vertex_is_constrained_map` and `do_slide_boundary` are not given; otherwise the program is not
                           compiled.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the maximal number of Newton steps of each stage: with fixed boundary, with soft boundary,
                          with boundary vertices that slide, for each barrier of the bound of angles, and again after
                          each refinement}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{`1000`}
    \cgalParamPrecondition{The value is finite and not negative.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{a limit for the running time in seconds}
    \cgalParamType{`double`}
    \cgalParamDefault{no limit}
    \cgalParamExtra{Results that depend on it are not reproducible.}
    \cgalParamPrecondition{The value is a number.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{an object that is told of each step, and may end the computation}
    \cgalParamType{a model of `ParameterizationVisitor_3`, passed by `std::ref()` if it keeps a state of interest}
    \cgalParamDefault{`Volume_mesh_parameterization::Default_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{verbose}
    \cgalParamDescription{whether the sizes, the linear solver, what `check_derivatives()` finds wrong in the energy, and a line
                         a step are printed to `std::cout`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the status, the distortions and the running times. Failures that depend on the complex or on the boundary are
        reported by `Parameterization_result::status` and, in words, by `Parameterization_result::message`, not thrown.

Named parameters that break a precondition are answered by `CGAL::Precondition_exception`, also in programs that are
compiled with `NDEBUG`; those that are not listed above are not compiled. Exceptions of property
maps, energy, solver and visitor pass through, with `uvw_map` left alone, and so does `std::bad_alloc`.

A Newton step takes time linear in the number of cells, plus the solution of a linear system. The memory is linear in
the number of cells, plus what the solver needs.

\sa `CGAL::Volume_mesh_parameterization::get_error_message()`
\sa `CGAL::Volume_mesh_parameterization::make_vertex_point_map()`
\sa `CGAL::Volume_mesh_parameterization::boundary_vertices()`
\sa `CGAL::Volume_mesh_parameterization::make_parameterizable()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename C3t3,
          typename VertexUVWMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS
#ifndef DOXYGEN_RUNNING
          , typename = std::enable_if_t<!Volume_mesh_parameterization::internal::is_soup<C3t3> > // a soup is for another overload
#endif
          >
Volume_mesh_parameterization::Parameterization_result
stretch_minimizing_volume_parameterization(C3t3& c3t3, VertexUVWMap uvw_map,
                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  namespace VMP = Volume_mesh_parameterization;

  static_assert(VMP::internal::Is_complex<C3t3>::value,
                "c3t3 must be a complex, which tells the cells that are meant; for arrays, pass points, cells and images.");
  using NamedParameters = CGAL_NP_CLASS;
  using Vertex_handle = typename C3t3::Vertex_handle;
  using Point_3 = typename C3t3::Triangulation::Geom_traits::Point_3;

  constexpr bool has_boundary_map = !parameters::is_default_parameter<NamedParameters, internal_np::boundary_map_t>::value;
  constexpr bool has_do_refine = VMP::internal::has_do_refine<NamedParameters>;
  static_assert(VMP::internal::Is_map_of<VertexUVWMap, Vertex_handle>::value,
                "uvw_map must be a property map of vertices: for a container, pass make_vertex_point_map(container).");
  static_assert(VMP::internal::Can_hold<VertexUVWMap, Point_3>::value,
                "uvw_map must hold Point_3, the point type of the geometric traits of the triangulation.");
  static_assert(!has_boundary_map
                || parameters::is_default_parameter<NamedParameters, internal_np::boundary_parameterizer_t>::value,
                "boundary_map and boundary_parameterizer must not both be passed: each gives the images of the boundary.");
  static_assert(!(has_do_refine && std::is_const<C3t3>::value),
                "do_refine must not be passed for a constant complex, which cannot be refined.");
  VMP::internal::check_refinement_mode<NamedParameters, !std::is_const<C3t3>::value>();

  return VMP::internal::run_problem<ConcurrencyTag>(np, [&](const VMP::internal::Map_problem_3& problem)
  {
    constexpr bool may_refine = !std::is_const<C3t3>::value && (has_do_refine || !has_boundary_map);
    VMP::internal::Body_of_complex_3<std::remove_const_t<C3t3> > body(c3t3);
    body.image_type = VMP::internal::coordinate_type_of_map<VertexUVWMap, Point_3>();
    const auto vertex = [&](const std::size_t p) { return body.vertices[p]; };
    std::vector<VMP::internal::Insertion_3> insertions;
    std::vector<std::array<double, 3> > images;
    const auto parameterize = [&](const auto& target)
    {
      return VMP::internal::parameterize_body_3<Vertex_handle, may_refine>(body, np, target, vertex, problem, insertions,
                                                                           images);
    };
    VMP::Parameterization_result result;
    if constexpr(has_boundary_map)
    {
      const auto boundary_map = parameters::get_parameter(np, internal_np::boundary_map);
      static_assert(VMP::internal::Is_map_of<std::remove_const_t<decltype(boundary_map)>, Vertex_handle>::value,
                    "boundary_map must be a property map of vertices: for a container, pass make_vertex_point_map(container), "
                    "and for a function, boost::make_function_property_map<Vertex_handle>(function).");
      result = parameterize([&](const std::size_t p) { return get(boundary_map, vertex(p)); });
    }
    else
      result = parameterize(VMP::internal::Targets_to_be_found());
    if constexpr(may_refine)
    {
      VMP::internal::insert_vertices(c3t3, body, insertions);
      if constexpr(!has_boundary_map)
        if(!insertions.empty())
          VMP::internal::tell_order_of_cells(VMP::internal::boundary_parameterizer_of(np), c3t3, body);
    }
    if(result.has_valid_map)
      for(std::size_t v = 0; v < images.size(); ++v)
        put(uvw_map, body.vertices[v], Point_3(images[v][0], images[v][1], images[v][2]));
    return result;
  });
}

} // namespace CGAL

#endif // CGAL_STRETCH_MINIMIZING_VOLUME_PARAMETERIZATION_H
