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

#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Vertex_condition_3.h>
#include <CGAL/Volume_mesh_parameterization/Vertex_map.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Vertex_insertion_3.h>
#include <CGAL/Volume_mesh_parameterization/volume_parameterization_of_arrays.h>

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_NAMED_PARAMETERS
#  error "The include directory of Volume_mesh_parameterization must precede the one of CGAL."
#endif

namespace CGAL {

/*!
\ingroup PkgVolumeMeshParameterizationFunctions

computes a map from a tetrahedral complex to a domain with prescribed boundary. No cell of the image is inverted, and the
distortion of angles and volumes is low. The map is linear on each cell and given by the images of the vertices.

The method is the stretch-minimizing parameterization of Jin et al.\ \cgalCite{cgal:jqzctz-smvp-15}. With fixed boundary, a
harmonic map is untangled \cgalCite{cgal:gkkrs-ffm-21} and a distortion energy minimized by Newton steps that never invert a
cell. With soft boundary, the method of the paper, no cell is ever inverted, and the boundary may be missed. At the end, exact
predicates on the written coordinates check that no cell is inverted.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
        `Sequential_tag`, `Parallel_tag`, and `Parallel_if_available_tag`. The result does not depend on it. It depends on the
        compiler, flags and instructions of the engine, and of the unit that names another energy or solver.
\tparam C3t3 a model of `MeshComplex_3InTriangulation_3`; if it is not `const`, of
        `MeshComplexWithFeatures_3InTriangulation_3` too. Its triangulation must not be periodic.
\tparam VertexUVWMap a model of `WritablePropertyMap` with `C3t3::Vertex_handle` as key type and
        `C3t3::Triangulation::Geom_traits::Point_3` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param c3t3 the complex; it is modified only if it may be refined (see `refinement_mode`), and may be constant otherwise. Its
       cells may have several subdomains and connected components; vertices without a cell are ignored.
\param uvw_map receives the image of each vertex of a cell if the map is valid (see
       `Parameterization_result::has_valid_map`), and does not change otherwise. Its points may have coordinates of a type
       narrower than `double`, as in `Simple_cartesian<float>`. Then targets are rounded to this type before the computation, and
       images before the exact check. If rounding inverts cells, vertices inside move by a few units in the last place; if this
       does not help, the status is `ERROR_INVERTED_BY_ROUNDING`.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below, in three groups. The
       \ref Chapter_Volume_Mesh_Parameterization "manual" has the details.

<b>Boundary of the image</b>

\cgalNamedParamsBegin
  \cgalParamNBegin{boundary_map}
    \cgalParamDescription{the image of each vertex of the boundary of the complex}
    \cgalParamType{a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
                   `C3t3::Triangulation::Geom_traits::Point_3` as value type}
    \cgalParamDefault{the images that `boundary_parameterizer` finds}
    \cgalParamExtra{A point with a coordinate that is not a number is a missing target. For a container, pass
                    `Volume_mesh_parameterization::make_vertex_point_map()`. Vertices receive exactly the points given, rounded
                    to the number type of `uvw_map`, unless they slide or the boundary is missed.}
  \cgalParamNEnd
  \cgalParamNBegin{boundary_parameterizer}
    \cgalParamDescription{finds the image of each vertex of the boundary (\ref VMPBoundaryTarget)}
    \cgalParamType{a model of `BoundaryParameterizer_3`}
    \cgalParamDefault{`Volume_mesh_parameterization::Ball_boundary_parameterizer_3()`}
    \cgalParamExtra{If it finds no images, the result has the status that it returns.}
    \cgalParamPrecondition{`boundary_map` is not given; otherwise the program is not compiled.}
  \cgalParamNEnd
  \cgalParamNBegin{boundary_mode}
    \cgalParamDescription{the way in which the boundary is met (\ref VMPBoundaryMode)}
    \cgalParamType{`Volume_mesh_parameterization::Boundary_mode`}
    \cgalParamDefault{`Boundary_mode::AUTO`: fixed, and soft if no valid map with fixed boundary is found}
  \cgalParamNEnd
  \cgalParamNBegin{do_slide_boundary}
    \cgalParamDescription{whether vertices slide in patches of the target and along the edges between them
                          (\ref VMPBoundarySlide)}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
    \cgalParamExtra{A vertex whose target is not a number slides in the boundary of the source, from the start.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{interior vertices with images in `boundary_map`, and boundary vertices that must not slide}
    \cgalParamType{a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and `bool` as value type}
    \cgalParamDefault{a constant property map returning `false`}
    \cgalParamPrecondition{`boundary_map` is given as well.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_condition_map}
    \cgalParamDescription{what the image of each vertex may do, on the boundary and inside
                          (\ref VMPBoundaryFree, \ref VMPSurfaces)}
    \cgalParamType{a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
                   `Volume_mesh_parameterization::Vertex_condition_3` as value type}
    \cgalParamDefault{vertices of the boundary are at their targets, vertices inside are free}
    \cgalParamExtra{For a container, pass `Volume_mesh_parameterization::make_vertex_condition_map()`, with which a vertex
                    without an entry is free. Targets are those of `boundary_map`. A coordinate of a target that is not prescribed
                    is not read. Refinement also splits edges, facets and cells inside whose vertices the conditions keep in the
                    plane of a facet of the boundary.}
    \cgalParamPrecondition{`vertex_is_constrained_map` and `do_slide_boundary` are not given; otherwise the program is not
                           compiled.}
  \cgalParamNEnd
\cgalNamedParamsEnd

<b>Distortion, refinement and limits</b>

\cgalNamedParamsBegin
  \cgalParamNBegin{energy}
    \cgalParamDescription{the energy whose mean over the cells is minimized (\ref VMPEnergy)}
    \cgalParamType{a model of `DistortionEnergy_3`}
    \cgalParamDefault{`Volume_mesh_parameterization::Stretch_energy_3()`}
    \cgalParamExtra{The singular values are divided by `reference_scale`.}
  \cgalParamNEnd
  \cgalParamNBegin{reference_scale}
    \cgalParamDescription{the scale of the source at which its cells are undistorted}
    \cgalParamType{`double`}
    \cgalParamDefault{1 if vertices of the boundary are free, otherwise the cube root of the ratio of the volumes of target and
                      source}
    \cgalParamExtra{With 1, an elastic energy has the rest shape of the source. With
                    `Volume_mesh_parameterization::found_reference_scale`, what is prescribed determines the scale.}
    \cgalParamPrecondition{The value is positive and finite, or `found_reference_scale`.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_angle_distortion}
    \cgalParamDescription{a bound for the distortion of angles \f$\sigma_1/\sigma_3 + \sigma_3/\sigma_1\f$ of every cell
                          (\ref VMPAngleBound)}
    \cgalParamType{`double`}
    \cgalParamDefault{no bound}
    \cgalParamExtra{The status reports whether the bound is met. If it is missed, the energy has at most doubled. The bound is
                    ignored if the boundary is missed.
                    With `Volume_mesh_parameterization::least_angle_distortion`, the largest distortion is made as small as
                    possible, up to 2 %. This takes several times as long as the minimization, and does not change the status.}
    \cgalParamPrecondition{The value is `least_angle_distortion`, which is 2, or larger.}
  \cgalParamNEnd
  \cgalParamNBegin{refinement_mode}
    \cgalParamDescription{which vertices may be added to the complex if the boundary cannot be reached otherwise, or if they help
                          (\ref VMPRefinement)}
    \cgalParamType{`Volume_mesh_parameterization::Refinement_mode`}
    \cgalParamDefault{`Refinement_mode::HELPFUL` if a boundary parameterizer finds the images and the complex, or the arrays, are
                      not constant; `Refinement_mode::NONE` if the images are given}
    \cgalParamExtra{New vertices receive images, too. The complex stays refined whatever the status is.}
    \cgalParamPrecondition{`c3t3` is not constant, whatever the value is; otherwise the program is not compiled.}
  \cgalParamNEnd
  \cgalParamNBegin{initial_map}
    \cgalParamDescription{the images of the vertices at which the search starts, for instance of a map to a similar boundary}
    \cgalParamType{a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
                   `C3t3::Triangulation::Geom_traits::Point_3` as value type}
    \cgalParamDefault{the harmonic map}
    \cgalParamExtra{It may be the same as `uvw_map`. A point with a coordinate that is not a number is a missing image. Infinite
                    coordinates result in `ERROR_NON_FINITE_COORDINATE`. A soft boundary ignores the initial map.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{a limit for the running time in seconds}
    \cgalParamType{`double`}
    \cgalParamDefault{no limit}
    \cgalParamExtra{Results that depend on it are not reproducible.}
    \cgalParamPrecondition{The value is a number, and not negative.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{an object that is called after each step, and may end the computation}
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

<b>For experts</b>

\cgalNamedParamsBegin
  \cgalParamNBegin{use_volume_weights}
    \cgalParamDescription{whether a cell counts by its volume in the source, as in `Volume_mesh_parameterization::Distortion_3`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`: all cells count alike, as in the paper}
  \cgalParamNEnd
  \cgalParamNBegin{use_regular_references}
    \cgalParamDescription{whether each image is compared with a regular tetrahedron; cells of the source may then be inverted
                          or flat (\ref VMPTangled)}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
    \cgalParamExtra{The boundary is fixed, whatever `boundary_mode` is, and distortions are those of the images of regular cells.
                    By the order of their vertices, two cells at a facet must lie on different sides of it.}
  \cgalParamNEnd
  \cgalParamNBegin{energy_tolerance}
    \cgalParamDescription{the part of the energy below which the gain of five Newton steps ends the minimization}
    \cgalParamType{`double`}
    \cgalParamDefault{`0.001`}
    \cgalParamExtra{With 0, the minimization continues to a minimum, which may take hundreds of steps for the last percent.}
    \cgalParamPrecondition{The value is not negative.}
  \cgalParamNEnd
  \cgalParamNBegin{solver_traits}
    \cgalParamDescription{the solver for the linear system of a Newton step (\ref VMPSolver)}
    \cgalParamType{a model of `NewtonSolverTraits_3`, passed by `std::ref()` if it keeps a state of interest}
    \cgalParamDefault{`Volume_mesh_parameterization::Conjugate_gradient_solver_traits_3<ConcurrencyTag>`}
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
    \cgalParamExtra{With constraints, prescribed vertices come near their targets, but are never put on them.}
    \cgalParamPrecondition{The vertices belong to cells of the complex; otherwise `std::out_of_range` is thrown.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the maximal number of Newton steps of each stage}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{`1000`}
    \cgalParamPrecondition{The value is finite and not negative.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the status, the distortions and the running times. Failures that depend on the complex or on the boundary are
        reported by `Parameterization_result::status` and, in words, by `Parameterization_result::message`, not thrown.

If a named parameter breaks a precondition, \cgal's error handlers throw `CGAL::Precondition_exception`, also in programs that
are compiled with `NDEBUG`. Other named parameters than those listed above do not compile. Exceptions of property maps, energy,
solver and visitor pass through, and `std::bad_alloc`. Then, `uvw_map` does not change.

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
                "c3t3 must be a complex. For arrays, pass points, cells and images.");
  using NamedParameters = CGAL_NP_CLASS;
  using Vertex_handle = typename C3t3::Vertex_handle;
  using Point_3 = typename C3t3::Triangulation::Geom_traits::Point_3;

  constexpr bool has_boundary_map = !parameters::is_default_parameter<NamedParameters, internal_np::boundary_map_t>::value;
  constexpr bool has_refinement_mode = VMP::internal::has_refinement_mode<NamedParameters>;
  static_assert(VMP::internal::Is_map_of<VertexUVWMap, Vertex_handle>::value,
                "uvw_map must be a property map of vertices: for a container, pass make_vertex_point_map(container).");
  static_assert(VMP::internal::Can_hold<VertexUVWMap, Point_3>::value,
                "uvw_map must hold Point_3, the point type of the geometric traits of the triangulation.");
  static_assert(!has_boundary_map
                || parameters::is_default_parameter<NamedParameters, internal_np::boundary_parameterizer_t>::value,
                "boundary_map and boundary_parameterizer must not both be passed: each gives the images of the boundary.");
  static_assert(!(has_refinement_mode && std::is_const<C3t3>::value),
                "refinement_mode must not be passed for a constant complex, which cannot be refined.");

  constexpr bool may_refine = !std::is_const<C3t3>::value && (has_refinement_mode || !has_boundary_map);
  VMP::internal::Named_problem_3<ConcurrencyTag, NamedParameters> named(np);
  VMP::internal::Body_of_complex_3<std::remove_const_t<C3t3> > body(c3t3);
  body.image_type = VMP::internal::coordinate_type_of_map<VertexUVWMap, Point_3>();
  const auto vertex = [&](const std::size_t p) { return body.vertices[p]; };
  const auto map_to = [&](const auto& target)
  { return VMP::internal::map_body_3<Vertex_handle, may_refine>(body, np, target, vertex, named.problem()); };
  VMP::internal::Body_map_3 map;
  if constexpr(has_boundary_map)
  {
    const auto boundary_map = parameters::get_parameter(np, internal_np::boundary_map);
    static_assert(VMP::internal::Is_map_of<std::remove_const_t<decltype(boundary_map)>, Vertex_handle>::value,
                  "boundary_map must be a property map of vertices: for a container, pass make_vertex_point_map(container), "
                  "and for a function, boost::make_function_property_map<Vertex_handle>(function).");
    map = map_to([&](const std::size_t p) { return get(boundary_map, vertex(p)); });
  }
  else
    map = map_to(VMP::internal::targets_to_be_found(np, std::as_const(c3t3), body));
  if constexpr(may_refine)
  {
    VMP::internal::insert_vertices(c3t3, body, map.insertions);
    if constexpr(!has_boundary_map)
      if(!map.insertions.empty())
        VMP::internal::reorder_result(VMP::internal::boundary_parameterizer_of(np), c3t3, body);
  }
  for(std::size_t v = 0; v < map.images.size(); ++v) // none without a valid map
    put(uvw_map, body.vertices[v], Point_3(map.images[v][0], map.images[v][1], map.images[v][2]));
  return map.result;
}

} // namespace CGAL

#endif // CGAL_STRETCH_MINIMIZING_VOLUME_PARAMETERIZATION_H
