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

protected:
  template <typename C3t3, typename VertexPointMap, typename NamedParameters, typename Given>
  Error_code parameterize_complex(const Body_of_complex_3<C3t3>& body, VertexPointMap target, const NamedParameters& np,
                                  const Given& given) const
  {
    using Point_3 = typename C3t3::Triangulation::Geom_traits::Point_3;
    return parameterize_body(body, np, given, [&](const std::size_t v, const Eigen::Vector3d& image)
    { put(target, body.vertices[v], Point_3(image[0], image[1], image[2])); });
  }

  // Assigns coordinates that are not numbers to points inside, which have no image.
  template <typename TargetRange, typename NamedParameters, typename Given>
  Error_code parameterize_arrays(const Body_3& body, TargetRange& targets, const NamedParameters& np,
                                 const Given& given) const
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::array<double, 3> > images(body.soup.points.size(), { nan, nan, nan });
    const Error_code status
      = parameterize_body(body, np, given, [&](const std::size_t v, const Eigen::Vector3d& image)
    { images[v] = coordinates(image); });
    if(status == OK)
      assign_coordinates(images, targets);
    return status;
  }

private:
  // Calls `write(point, image)` for each point on the boundary, only if all succeeds. Once the budget is exhausted, the
  // answer of `map()` does not matter.
  template <typename NamedParameters, typename Given, typename Write>
  Error_code parameterize_body(const Body_3& body, const NamedParameters& np, const Given& given, const Write& write) const
  {
    check_named_parameters(np);
    Limits<NamedParameters> limits(np);
    const Budget budget = limits.budget();
    const Numbered_surface_3 surface = surface_of(body);
    std::vector<Eigen::Vector3d> images;
    const Error_code status = static_cast<const Model&>(*this).map(surface, given, images, budget);
    if(budget.is_exhausted())
      return ERROR_INTERRUPTED;
    if(status == OK)
      for(std::size_t v = 0; v < images.size(); ++v)
        write(surface.vertices[v], images[v]);
    return status;
  }
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_BOUNDARY_PARAMETERIZER_BASE_3_H
