// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_ARRAYS_VOLUME_PARAMETERIZATION_OF_ARRAYS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_ARRAYS_VOLUME_PARAMETERIZATION_OF_ARRAYS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Numbered_complex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/check_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/parameterize_complex_3.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// The numbered mesh of a tetrahedron soup, whose vertices are the indices of its points.
class Numbered_soup_3
  : public Numbered_vertices_3<std::size_t>
{
public:
  template <typename VertexIsConstrainedMap, typename BoundaryMap>
  Numbered_soup_3(const Tetrahedron_soup_3& soup, const VertexIsConstrainedMap is_constrained, const BoundaryMap target,
                  const bool has_volume_weights)
    : m_number_of_points(soup.points.size())
  {
    check_simplices(soup);
    std::vector<std::array<int, 4> > cells;
    cells.reserve(soup.cells.size());
    reserve(soup.points.size());
    for(const std::array<std::size_t, 4>& cell : soup.cells)
      cells.push_back({ add_vertex(cell[0]), add_vertex(cell[1]), add_vertex(cell[2]), add_vertex(cell[3]) });

    const std::vector<bool> is_point_on_boundary = Facet_matching_3(soup).points_on_boundary();
    std::vector<bool> is_on_boundary;
    for(const std::size_t v : vertices())
      is_on_boundary.push_back(is_point_on_boundary[v]);
    set_mesh(cells, [&](const std::size_t v) { return soup.points[v]; }, is_on_boundary, is_constrained, target,
             has_volume_weights);
  }

  void write(const Eigen::Matrix3Xd& image, std::vector<std::array<double, 3> >& images) const
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    images.assign(m_number_of_points, { nan, nan, nan });
    for(std::size_t v = 0; v < vertices().size(); ++v)
      images[vertices()[v]] = { image(0, v), image(1, v), image(2, v) };
  }

private:
  std::size_t m_number_of_points;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

namespace CGAL {

/*!
\ingroup PkgVolumeMeshParameterizationRef

computes the same map for those whose mesh is arrays, without a complex. Vertices are indices of points, counted from 0.

\param points the points
\param cells four indices of points each, such that all cells are positive
\param targets the image of each point that is a vertex of the boundary, of a facet of one cell only. The others are not
       read, unless `vertex_is_constrained_map` tells them; a coordinate that is not a number stands for a missing
       target.
\param images receives the image of each point if the map is valid, and is left alone otherwise. Points without a cell
       receive coordinates that are not numbers. May be the same array as `points` or `targets`.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of the function for a complex,
       with `std::size_t` for `C3t3::Vertex_handle`, except `boundary_map` and `do_refine`, which are not compiled

\return the same as for a complex

`Volume_mesh_parameterization::Input_error` is thrown if a cell has an index that does not exist or an index twice, or
if a facet has more than two cells or two on the same side; `CGAL::Precondition_exception` if there are not as many
targets as points.
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename NamedParameters = parameters::Default_named_parameters>
Volume_mesh_parameterization::Parameterization_result
stretch_minimizing_volume_parameterization(const std::vector<std::array<double, 3> >& points,
                                           const std::vector<std::array<std::size_t, 4> >& cells,
                                           const std::vector<std::array<double, 3> >& targets,
                                           std::vector<std::array<double, 3> >& images,
                                           const NamedParameters& np = parameters::default_values())
{
  namespace VMP = Volume_mesh_parameterization;
  static_assert(parameters::is_default_parameter<NamedParameters, internal_np::boundary_map_t>::value,
                "boundary_map must not be passed for arrays: the targets are an argument.");
  static_assert(parameters::is_default_parameter<NamedParameters, internal_np::do_refine_t>::value,
                "do_refine must not be passed for arrays, which are not refined: make a complex of them.");
  VMP::internal::require(targets.size() == points.size(), "There are as many targets as points.");

  const VMP::Tetrahedron_soup_3 soup = { points, cells, std::vector<int>(cells.size()), {}, {} };
  const auto target_map = boost::make_iterator_property_map(targets.begin(), boost::identity_property_map());
  return VMP::internal::run_problem<ConcurrencyTag, std::size_t>(np, target_map, [&](const auto& problem)
  {
    return VMP::internal::parameterize_complex_3<VMP::internal::Numbered_soup_3>(soup, problem, images);
  });
}

} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_ARRAYS_VOLUME_PARAMETERIZATION_OF_ARRAYS_H
