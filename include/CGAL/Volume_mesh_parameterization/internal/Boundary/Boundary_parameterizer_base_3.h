// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOUNDARY_PARAMETERIZER_BASE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOUNDARY_PARAMETERIZER_BASE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Vertex_map.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_of_complex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <cmath>
#include <string>
#include <type_traits>

namespace CGAL::Volume_mesh_parameterization::internal {

// Images of a boundary as it is given, or after edges of it are split.
struct Mapped_boundary_3
{
  std::vector<std::array<std::size_t, 2> > splits; // edges by their points, one after the other; new points come behind all others
  std::vector<std::array<double, 3> > targets;     // of all points; those of points inside are not numbers
  std::array<std::array<double, 3>, 3> rotation = {}; // rows of the one into the axes of a polycube
  std::string strategy = {};                          // that found it, if there are several
  bool is_complete = true;                            // or was a phase ended that would make it better?
};

// Base of all models of `BoundaryParameterizer_3`: `Model::map(surface, given, images, budget)` finds the images. The
// parameters of a call, corners for instance, are a `Model::Given`, by default without a value.
template <typename Model>
class Boundary_parameterizer_base_3
{
public:
  /// writes the image of each vertex of the boundary of a complex.
  template <typename C3t3, typename VertexPointMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
            typename = typename C3t3::Triangulation>
  Error_code parameterize(const C3t3& c3t3, VertexPointMap target,
                          const CGAL_NP_CLASS& np = parameters::default_values()) const
  { return parameterize_complex(Body_of_complex_3<C3t3>(c3t3), target, np, typename Model::Given()); }

  /// writes the image of each point on the boundary of a mesh that is given by arrays.
  template <typename PointRange, typename CellRange, typename TargetRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
            typename = If_range<PointRange> >
  Error_code parameterize(const PointRange& points, const CellRange& cells, TargetRange& targets,
                          const CGAL_NP_CLASS& np = parameters::default_values()) const
  { return parameterize_arrays(body_of(points, cells), targets, np, typename Model::Given()); }

  /// writes the image of each point on the boundary of a mesh with points, cells and marked edges, which are its sharp ones.
  template <typename Mesh, typename TargetRange, typename CGAL_NP_TEMPLATE_PARAMETERS, typename = decltype(Mesh::edges)>
  Error_code parameterize(const Mesh& mesh, TargetRange& targets,
                          const CGAL_NP_CLASS& np = parameters::default_values()) const
  { return parameterize_arrays(body_of_arrays(mesh.points, mesh.cells, mesh.edges), targets, np, typename Model::Given()); }

  // Finds images of the boundary of a body, which may be refined for them if the model can do that.
  Error_code find_boundaries(const Body_3& body, const bool may_refine, const Budget& budget,
                             std::vector<Mapped_boundary_3>& boundaries) const
  { return model().find(body, typename Model::Given(), may_refine, budget, boundaries); }

  // Stores what users may ask of the chosen boundary, and later orders it as the cells of a refined complex.
  void store_result(const Body_3&, const Mapped_boundary_3&) const {}
  void reorder_result(const std::vector<std::size_t>&) const {}

protected:
  template <typename C3t3, typename VertexPointMap, typename NamedParameters, typename Given>
  Error_code parameterize_complex(const Body_of_complex_3<C3t3>& body, VertexPointMap target, const NamedParameters& np,
                                  const Given& given) const
  {
    using Point_3 = typename C3t3::Triangulation::Geom_traits::Point_3;
    return parameterize_body(body, np, given, [&](const std::vector<std::array<double, 3> >& targets)
    {
      for(std::size_t v = 0; v < targets.size(); ++v)
        if(const auto& [x, y, z] = targets[v]; !std::isnan(x))
          put(target, body.vertices[v], Point_3(x, y, z));
    });
  }

  template <typename TargetRange, typename NamedParameters, typename Given>
  Error_code parameterize_arrays(const Body_3& body, TargetRange& targets, const NamedParameters& np,
                                 const Given& given) const
  {
    return parameterize_body(body, np, given, [&](const std::vector<std::array<double, 3> >& of_points)
    { assign_coordinates(of_points, targets); });
  }

  template <typename Given>
  Error_code find(const Body_3& body, const Given& given, bool, const Budget& budget,
                  std::vector<Mapped_boundary_3>& boundaries) const
  {
    const Numbered_surface_3 surface = surface_of(body);
    std::vector<Vector_3> images;
    const Error_code status = model().map(surface, given, images, budget);
    if(budget.is_exhausted()) // then the status does not matter
      return ERROR_INTERRUPTED;
    if(status == OK)
      boundaries.push_back(mapped_boundary(body, surface, {}, images));
    return status;
  }

  // Returns the images of a surface, whose new points come behind all others, as those of the points of the body.
  static Mapped_boundary_3 mapped_boundary(const Body_3& body, const Numbered_surface_3& surface,
                                           const std::vector<std::array<std::size_t, 2> >& splits,
                                           const std::vector<Vector_3>& images)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const std::size_t n = surface.vertices.size(), number_of_points = body.points.size();
    const auto point = [&](const std::size_t v) { return v < n ? surface.vertices[v] : number_of_points + (v - n); };
    Mapped_boundary_3 result;
    for(const auto& [v, w] : splits)
      result.splits.push_back({ point(v), point(w) });
    result.targets.assign(number_of_points + splits.size(), { nan, nan, nan });
    for(std::size_t v = 0; v < images.size(); ++v)
      result.targets[point(v)] = coordinates(images[v]);
    return result;
  }

private:
  const Model& model() const { return static_cast<const Model&>(*this); }

  template <typename NamedParameters, typename Given, typename Write>
  Error_code parameterize_body(const Body_3& body, const NamedParameters& np, const Given& given, const Write& write) const
  {
    check_named_parameters(np);
    Limits<NamedParameters> limits(np);
    std::vector<Mapped_boundary_3> boundaries;
    const Error_code status = model().find(body, given, false, limits.budget(), boundaries);
    if(status != OK)
      return status;
    model().store_result(body, boundaries.front());
    write(boundaries.front().targets);
    return OK;
  }
};

// Lets a boundary parameterizer ask a budget.
struct Visitor_of_budget
{
  const Budget& budget;

  bool after_step(const Parameterization_step& step) { return budget.report(step); }
  bool goes_on() const { return !budget.is_exhausted(); }
};

template <typename Parameterizer, typename... Arguments>
using Answer_of_boundary_parameterizer = decltype(std::declval<const Parameterizer&>().parameterize(
  std::declval<Arguments>()..., parameters::visitor(std::declval<Visitor_of_budget>())));

template <typename Parameterizer, typename... Arguments>
constexpr bool is_boundary_parameterizer
  = std::is_convertible<boost::detected_t<Answer_of_boundary_parameterizer, Parameterizer, Arguments...>, Error_code>::value;

// The named parameters are passed as well: a function of complexes, with its defaults, would take three ranges, too.
template <typename Parameterizer>
constexpr bool is_boundary_parameterizer_of_arrays
  = is_boundary_parameterizer<Parameterizer, const std::vector<std::array<double, 3> >&,
                              const std::vector<std::array<std::size_t, 4> >&, std::vector<std::array<double, 3> >&>;

// Calls a boundary parameterizer that takes complexes only.
template <typename Parameterizer, typename C3t3>
struct Parameterizer_of_complex_3
{
  using Images = std::unordered_map<typename C3t3::Vertex_handle, typename C3t3::Triangulation::Geom_traits::Point_3>;
  static constexpr bool can_be_called
    = is_boundary_parameterizer<Parameterizer, const C3t3&, Vertex_map<Images> >;

  Parameterizer parameterizer;
  const C3t3& c3t3;
  const std::vector<typename C3t3::Vertex_handle>& vertices; // of each point

  template <typename NamedParameters>
  Error_code parameterize(const std::vector<std::array<double, 3> >& points, const std::vector<std::array<std::size_t, 4> >&,
                          std::vector<std::array<double, 3> >& targets, const NamedParameters& np) const
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Images images;
    const Error_code status = parameterizer.parameterize(c3t3, make_vertex_point_map(images), np);
    targets.assign(points.size(), { nan, nan, nan });
    for(std::size_t p = 0; p < points.size(); ++p)
      if(const auto image = images.find(vertices[p]); image != images.end())
        targets[p] = coordinates(image->second);
    return status;
  }
};

template <typename Parameterizer>
constexpr bool is_of_this_package = std::is_base_of<Boundary_parameterizer_base_3<Parameterizer>, Parameterizer>::value;

// Finds images of a boundary by any model of `BoundaryParameterizer_3`. The models of this package take the body as it is. If the
// boundary may be refined, there may be several, in the order in which they are proposed.
template <typename Parameterizer>
Error_code find_boundaries_3(const Parameterizer& parameterizer, const Body_3& body, const bool may_refine, const Budget& budget,
                             std::vector<Mapped_boundary_3>& boundaries)
{
  static_assert(is_boundary_parameterizer_of_arrays<Parameterizer>,
                "boundary_parameterizer must have a function parameterize(points, cells, targets, np), or for complexes "
                "parameterize(c3t3, target, np), that returns an Error_code.");
  if constexpr(is_of_this_package<Parameterizer>)
    return parameterizer.find_boundaries(body, may_refine, budget, boundaries);
  else
  {
    std::vector<std::array<double, 3> > targets;
    const Error_code status = parameterizer.parameterize(body.points, body.cells, targets,
                                                         parameters::visitor(Visitor_of_budget{ budget }));
    if(status != OK)
      return status;
    const std::vector<bool> is_on_boundary = used_points(body.boundary, body.points.size());
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    targets.resize(is_on_boundary.size(), { nan, nan, nan });
    for(std::size_t v = 0; v < targets.size(); ++v)
      if(!is_on_boundary[v])
        targets[v] = { nan, nan, nan };
    boundaries.push_back({ {}, std::move(targets) });
    return OK;
  }
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOUNDARY_PARAMETERIZER_BASE_3_H
