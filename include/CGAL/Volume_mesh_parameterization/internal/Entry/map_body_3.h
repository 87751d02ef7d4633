// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENTRY_MAP_BODY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENTRY_MAP_BODY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/map_to_boundaries_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Entry/named_parameters_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Soups/insert_points.h>

namespace CGAL::Volume_mesh_parameterization::internal {

// Maps a body to prescribed targets. `target(p)` is that of a point, and `vertex(p)` what the user calls the point. The body is
// refined, or gone.
template <typename Vertex, bool may_refine, typename NamedParameters, typename TargetOfPoint, typename VertexOfPoint>
Body_map_3 map_body_3(Body_3& body, const NamedParameters& np, const TargetOfPoint& target, const VertexOfPoint& vertex,
                      const Map_problem_3& problem)
{
  const Prescription_3 prescription = prescription_3<Vertex>(body, np, target, vertex);
  if constexpr(may_refine) // refinement is compiled only where users can ask for it
  {
    if(problem.options.refinement != Refinement_mode::NONE)
      return refine_and_parameterize_body_3(body, prescription, problem);
  }
  return parameterize_body_3(std::move(body), prescription, problem);
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

// The result where a boundary parameterizer finds no boundary.
inline Parameterization_result result_without_boundary(const Body_3& body, const Error_code status, const bool may_split,
                                                       const Progress_3& progress)
{
  Parameterization_result result = progress.effort();
  result.status = status;
  result.message = status == ERROR_NO_POLYCUBE && may_split
    ? "No polycube was found for the boundary, although its edges may be split. Simplify it: remove small details and bores."
    : get_error_message(status) + where_boundary_fails(body, status);
  result.seconds_total = progress.seconds();
  return result;
}

// Maps a body to a boundary that a parameterizer finds.
template <typename Vertex, bool may_refine, typename NamedParameters, typename Parameterizer, typename VertexOfPoint>
Body_map_3 map_body_3(Body_3& body, const NamedParameters& np, const Targets_to_be_found<Parameterizer>& target,
                      const VertexOfPoint& vertex, const Map_problem_3& problem)
{
  static_assert(parameters::is_default_parameter<NamedParameters, internal_np::vertex_is_constrained_t>::value,
                "The images of constrained vertices are missing: pass a boundary_map, or targets for arrays.");
  problem.progress.end_numbering();
  const Parameterizer& parameterizer = target.parameterizer;
  const bool may_split = may_refine && problem.options.refinement == Refinement_mode::BOUNDARY;
  std::vector<Mapped_boundary_3> boundaries;
  const Error_code status = find_boundaries_3(parameterizer, body, may_split, problem.progress.budget(), boundaries);
  problem.progress.end_boundary();
  if(status != OK)
    return { result_without_boundary(body, status, may_split, problem.progress), {}, {} };
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
    if(problem.options.refinement != Refinement_mode::NONE)
    {
      Mapped_body_3 mapped = map_to_boundaries_3(std::move(body), prescription, boundaries, problem);
      body = std::move(mapped.body);
      store_result(*mapped.boundary);
      if(Parameterization_result& result = mapped.map.result; result.status == OK && !mapped.boundary->is_complete)
      {
        result.status = ERROR_INTERRUPTED;
        result.message = get_error_message(ERROR_INTERRUPTED);
      }
      return std::move(mapped.map);
    }
  store_result(boundaries.front());
  prescription.targets = boundaries.front().targets;
  return parameterize_body_3(std::move(body), prescription, problem);
}

// Orders the result of a parameterizer, which is that of the cells of a body, as the cells of the refined complex.
template <typename Parameterizer, typename C3t3, typename Body>
void reorder_result(const Parameterizer& parameterizer, const C3t3& c3t3, const Body& body)
{
  if constexpr(is_of_this_package<Parameterizer>)
    parameterizer.reorder_result(order_of_cells(c3t3, body));
}

template <typename NamedParameters>
constexpr bool has_refinement_mode = !parameters::is_default_parameter<NamedParameters, internal_np::refinement_mode_t>::value;

// Arrays of the user as the source of a map: the body of them, and the way back of its refinement.
template <typename PointRange, typename CellRange>
struct Arrays_3
{
  std::remove_reference_t<PointRange>& points;
  std::remove_reference_t<CellRange>& cells;

  Body_3 body(const bool is_parallel) const
  {
    Body_3 result = body_of_arrays(coordinates_of(points), indices_of(cells), {}, is_parallel);
    result.point_type = coordinate_type_of<PointRange>();
    return result;
  }

  // Appends new points and cells; cells that were there may have become smaller.
  void refine(const Body_3& refined, const std::vector<Insertion_3>&) const
  {
    static_assert(!std::is_const<std::remove_reference_t<PointRange> >::value
                  && !std::is_const<std::remove_reference_t<CellRange> >::value,
                  "refinement_mode must not be passed for constant arrays, which cannot be refined.");
    assign_coordinates(refined.points, points, number_of_rows(points));
    resize_rows(cells, refined.cells.size(), 4);
    for(std::size_t c = 0; c < refined.cells.size(); ++c)
    {
      auto&& cell = row(cells, c);
      for(int i = 0; i < 4; ++i)
        cell[i] = static_cast<std::decay_t<decltype(cell[i])> >(refined.cells[c][i]);
    }
  }
};

// A soup likewise, whose points are double.
template <typename Soup>
struct Arrays_of_soup_3
{
  Soup& soup;

  Body_3 body(const bool is_parallel) const { return body_of(soup, is_parallel); }
  void refine(Body_3 body, const std::vector<Insertion_3>& insertions) const { insert_points(std::move(body), insertions, soup); }
};

// Maps arrays, or a soup, to targets.
template <typename ConcurrencyTag, bool may_refine, typename Source, typename Target, typename ImageRange,
          typename NamedParameters>
Parameterization_result parameterize_arrays_3(const Source& source, const Target& target, ImageRange& images,
                                              const NamedParameters& np)
{
  static_assert(parameters::is_default_parameter<NamedParameters, internal_np::boundary_map_t>::value,
                "boundary_map must not be passed for arrays: the targets are an argument.");
  Named_problem_3<ConcurrencyTag, NamedParameters> named(np);
  const Map_problem_3 problem = named.problem();
  Body_3 body = source.body(problem.options.is_parallel);
  body.image_type = coordinate_type_of<ImageRange>();
  const Body_map_3 map
    = map_body_3<std::size_t, may_refine>(body, np, target, [](const std::size_t p) { return p; }, problem);
  if(map.result.has_valid_map)
    assign_coordinates(map.images, images);
  if constexpr(may_refine)
    if(!map.insertions.empty())
      source.refine(std::move(body), map.insertions);
  return map.result;
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

// Arrays that a call can refine are no temporaries and not constant.
template <typename Range>
constexpr bool is_refinable = std::is_lvalue_reference<Range>::value && !std::is_const<std::remove_reference_t<Range> >::value;

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENTRY_MAP_BODY_3_H
