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

#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <cmath>
#include <type_traits>

namespace CGAL::Volume_mesh_parameterization::internal {

// Base of all models of `BoundaryParameterizer_3`: `Model::map(surface, given, images, budget)` finds the images. The
// parameters of a call, corners for instance, are a `Model::Given`, by default without a value.
template <typename Model>
class Boundary_parameterizer_base_3
{
public:
  /// writes the image of each vertex of the boundary of a complex.
  template <typename C3t3, typename VertexPointMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const C3t3& c3t3, VertexPointMap target,
                          const CGAL_NP_CLASS& np = parameters::default_values()) const
  { return parameterize_complex(Body_of_complex_3<C3t3>(c3t3), target, np, typename Model::Given()); }

  /// writes the image of each point on the boundary of a mesh that is given by arrays.
  template <typename PointRange, typename CellRange, typename TargetRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
            typename = If_range<PointRange> >
  Error_code parameterize(const PointRange& points, const CellRange& cells, TargetRange& targets,
                          const CGAL_NP_CLASS& np = parameters::default_values()) const
  { return parameterize_arrays(body_of(points, cells), targets, np, typename Model::Given()); }

  /// writes the image of each point on the boundary of a soup, whose marked edges are its sharp ones.
  template <typename TargetRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
  Error_code parameterize(const Tetrahedron_soup_3& soup, TargetRange& targets,
                          const CGAL_NP_CLASS& np = parameters::default_values()) const
  { return parameterize_arrays(body_of(soup), targets, np, typename Model::Given()); }

  // Finds the image of each point on the boundary of a body, in the order of its points; those of the others are not numbers.
  Error_code find_targets(const Body_3& body, const Budget& budget, std::vector<std::array<double, 3> >& targets) const
  { return find_targets(body, typename Model::Given(), budget, targets); }

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

private:
  template <typename Given>
  Error_code find_targets(const Body_3& body, const Given& given, const Budget& budget,
                          std::vector<std::array<double, 3> >& targets) const
  {
    const Numbered_surface_3 surface = surface_of(body);
    std::vector<Eigen::Vector3d> images;
    const Error_code status = static_cast<const Model&>(*this).map(surface, given, images, budget);
    if(budget.is_exhausted()) // then the status does not matter
      return ERROR_INTERRUPTED;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    targets.assign(body.soup.points.size(), { nan, nan, nan });
    if(status == OK)
      for(std::size_t v = 0; v < images.size(); ++v)
        targets[surface.vertices[v]] = coordinates(images[v]);
    return status;
  }

  template <typename NamedParameters, typename Given, typename Write>
  Error_code parameterize_body(const Body_3& body, const NamedParameters& np, const Given& given, const Write& write) const
  {
    check_named_parameters(np);
    Limits<NamedParameters> limits(np);
    std::vector<std::array<double, 3> > targets;
    const Error_code status = find_targets(body, given, limits.budget(), targets);
    if(status == OK)
      write(targets);
    return status;
  }
};

template <typename Parameterizer>
using Answer_of_boundary_parameterizer = decltype(std::declval<const Parameterizer&>().parameterize(
  std::declval<const std::vector<std::array<double, 3> >&>(), std::declval<const std::vector<std::array<std::size_t, 4> >&>(),
  std::declval<std::vector<std::array<double, 3> >&>()));

template <typename Parameterizer>
using Is_boundary_parameterizer
  = std::is_convertible<boost::detected_t<Answer_of_boundary_parameterizer, Parameterizer>, Error_code>;

// Lets a boundary parameterizer ask a budget.
struct Visitor_of_budget
{
  const Budget& budget;

  bool after_step(const Parameterization_step& step) { return budget.tell(step); }
  bool goes_on() const { return !budget.is_exhausted(); }
};

// Finds targets by any model of `BoundaryParameterizer_3`. The models of this package take the body as it is.
template <typename Parameterizer>
Error_code find_targets_3(const Parameterizer& parameterizer, const Body_3& body, const Budget& budget,
                          std::vector<std::array<double, 3> >& targets)
{
  static_assert(Is_boundary_parameterizer<Parameterizer>::value,
                "boundary_parameterizer must have a function parameterize(points, cells, targets) that returns an Error_code.");
  if constexpr(std::is_base_of<Boundary_parameterizer_base_3<Parameterizer>, Parameterizer>::value)
    return parameterizer.find_targets(body, budget, targets);
  else
    return parameterizer.parameterize(body.soup.points, body.soup.cells, targets,
                                      parameters::visitor(Visitor_of_budget{ budget }));
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOUNDARY_PARAMETERIZER_BASE_3_H
