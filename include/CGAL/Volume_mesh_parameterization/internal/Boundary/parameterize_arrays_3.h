// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_PARAMETERIZE_ARRAYS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_PARAMETERIZE_ARRAYS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/map_to_boundaries_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Maps a body to prescribed targets. `target(p)` is that of a point, and `vertex(p)` what the user calls the point. The body is
// refined, or gone.
template <typename Vertex, bool may_refine, typename NamedParameters, typename TargetOfPoint, typename VertexOfPoint>
Parameterization_result parameterize_body_3(Body_3& body, const NamedParameters& np, const TargetOfPoint& target,
                                            const VertexOfPoint& vertex, const Map_problem_3& problem,
                                            std::vector<Insertion_3>& insertions,
                                            std::vector<std::array<double, 3> >& images)
{
  const Prescription_3 prescription = prescription_3<Vertex>(body, np, target, vertex);
  if constexpr(may_refine) // refinement is compiled only where users can ask for it
  {
    if(problem.options.refinement != Refinement_mode::NONE)
      return refine_and_parameterize_body_3(body, prescription, problem, insertions, images);
  }
  return parameterize_body_3(std::move(body), prescription, problem, images);
}

template <typename NamedParameters>
auto boundary_parameterizer_of(const NamedParameters& np)
{ return parameter_or(np, internal_np::boundary_parameterizer, Ball_boundary_parameterizer_3()); }

// Stands for the targets that a boundary parameterizer finds.
template <typename Parameterizer>
struct Targets_to_be_found
{
  Parameterizer parameterizer;

  explicit Targets_to_be_found(const Parameterizer& p) : parameterizer(p) {}
};

template <typename NamedParameters>
auto targets_to_be_found(const NamedParameters& np) { return Targets_to_be_found(boundary_parameterizer_of(np)); }

template <typename NamedParameters, typename C3t3>
auto targets_to_be_found(const NamedParameters& np, const C3t3& c3t3, const Body_of_complex_3<C3t3>& body)
{
  using Parameterizer = decltype(boundary_parameterizer_of(np));
  using Of_complex = Parameterizer_of_complex_3<Parameterizer, C3t3>;
  if constexpr(!is_boundary_parameterizer_of_arrays<Parameterizer> && Of_complex::can_be_called)
    return Targets_to_be_found(Of_complex{ boundary_parameterizer_of(np), c3t3, body.vertices });
  else
    return targets_to_be_found(np);
}

template <typename Vertex, bool may_refine, typename NamedParameters, typename Parameterizer, typename VertexOfPoint>
Parameterization_result parameterize_body_3(Body_3& body, const NamedParameters& np,
                                            const Targets_to_be_found<Parameterizer>& target,
                                            const VertexOfPoint& vertex, const Map_problem_3& problem,
                                            std::vector<Insertion_3>& insertions,
                                            std::vector<std::array<double, 3> >& images)
{
  static_assert(parameters::is_default_parameter<NamedParameters, internal_np::vertex_is_constrained_t>::value,
                "The images of constrained vertices are missing: pass a boundary_map, or targets for arrays.");
  problem.progress.end_numbering();
  const Parameterizer& parameterizer = target.parameterizer;
  const bool do_refine = may_refine && problem.options.refinement != Refinement_mode::NONE;
  std::vector<Mapped_boundary_3> boundaries;
  const Error_code status
    = find_boundaries_3(parameterizer, body, do_refine && problem.options.refinement == Refinement_mode::BOUNDARY,
                        problem.progress.budget(), boundaries);
  problem.progress.end_boundary();
  if(status != OK)
  {
    Parameterization_result result = problem.progress.effort();
    result.status = status;
    result.message = get_error_message(status) + where_boundary_fails(body, status);
    result.seconds_total = problem.progress.seconds();
    return result;
  }
  for(Mapped_boundary_3& boundary : boundaries)
    for(std::array<double, 3>& p : boundary.targets)
      p = body.image_type.rounded_point(p);
  const auto store_result = [&](const Mapped_boundary_3& boundary)
  {
    if constexpr(is_of_this_package<Parameterizer>)
      parameterizer.store_result(body, boundary);
  };
  Prescription_3 prescription = prescription_3<Vertex>(body, np, [](std::size_t) { return Exact_point_3(); }, vertex);
  if constexpr(may_refine)
    if(do_refine)
    {
      Mapped_body_3 mapped = map_to_boundaries_3(std::move(body), prescription, boundaries, problem);
      body = std::move(mapped.body);
      insertions = std::move(mapped.insertions);
      images = std::move(mapped.images);
      store_result(*mapped.boundary);
      return mapped.result;
    }
  store_result(boundaries.front());
  prescription.targets = boundaries.front().targets;
  return parameterize_body_3(std::move(body), prescription, problem, images);
}

// Orders the result of a parameterizer, which is that of the cells of a body, as the cells of the refined complex.
template <typename Parameterizer, typename C3t3, typename Body>
void reorder_cells(const Parameterizer& parameterizer, const C3t3& c3t3, const Body& body)
{
  if constexpr(is_of_this_package<Parameterizer>)
    parameterizer.reorder_cells(order_of_cells(c3t3, body));
}

// Maps a mesh of arrays, whose points are stored in some type. `take(soup)` takes over the refined mesh.
template <typename ConcurrencyTag, bool may_refine, typename TargetOfPoint, typename ImageRange, typename NamedParameters,
          typename Take>
Parameterization_result parameterize_arrays_3(Tetrahedron_soup_3 soup, const Coordinate_type& point_type,
                                              const TargetOfPoint& target, ImageRange& images, const NamedParameters& np,
                                              const Take& take)
{
  static_assert(parameters::is_default_parameter<NamedParameters, internal_np::boundary_map_t>::value,
                "boundary_map must not be passed for arrays: the targets are an argument.");
  return run_problem<ConcurrencyTag>(np, [&](const Map_problem_3& problem)
  {
    Body_3 body = body_of(std::move(soup), problem.options.is_parallel);
    body.point_type = point_type;
    body.image_type = coordinate_type_of<ImageRange>();
    std::vector<Insertion_3> insertions;
    std::vector<std::array<double, 3> > images_of_points;
    const Parameterization_result result = parameterize_body_3<std::size_t, may_refine>(
      body, np, target, [](const std::size_t v) { return v; }, problem, insertions, images_of_points);
    if(result.has_valid_map)
      assign_coordinates(images_of_points, images);
    if(!insertions.empty())
      take(body.soup);
    return result;
  });
}

// Returns a function with the target of each point, of a range that has one for each of them.
template <typename NamedParameters, typename TargetRange>
auto target_of_point(const TargetRange& targets, const std::size_t number_of_points)
{
  static_assert(parameters::is_default_parameter<NamedParameters, internal_np::boundary_parameterizer_t>::value,
                "boundary_parameterizer must not be passed with targets: leave these out, it finds them.");
  require(number_of_rows(targets) == number_of_points, "targets must have an element for each point.");
  return [&targets](const std::size_t p) { return coordinates(row(targets, p)); };
}

template <typename NamedParameters>
constexpr bool has_refinement_mode = !parameters::is_default_parameter<NamedParameters, internal_np::refinement_mode_t>::value;

// Arrays that a call can refine are no temporaries and not constant.
template <typename Range>
constexpr bool is_refinable = std::is_lvalue_reference<Range>::value && !std::is_const<std::remove_reference_t<Range> >::value;

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_PARAMETERIZE_ARRAYS_3_H
