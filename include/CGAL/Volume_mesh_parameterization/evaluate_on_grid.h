// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EVALUATE_ON_GRID_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EVALUATE_ON_GRID_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>

#include <cmath>
#include <limits>

namespace CGAL::Volume_mesh_parameterization {

/// \ingroup PkgVolumeMeshParameterizationResults
///
/// holds a map on a regular grid of its target. The x-coordinate of the points changes first, then y, then z: the point
/// (i, j, k) has the index i + numbers[0] * (j + numbers[1] * k).
struct Map_on_grid_3
{
  std::array<std::size_t, 3> numbers;               ///< number of points along each axis
  std::vector<std::array<double, 3> > points;       ///< points of the grid
  std::vector<std::array<double, 3> > preimages;    ///< their preimages; not-a-number coordinates outside of the image
  std::vector<double> det_J;                        ///< the Jacobian determinant of the map at the preimage; not a number outside
};

/// \ingroup PkgVolumeMeshParameterizationResults
///
/// evaluates the inverse of a map on a regular grid in a box of its target, for instance to fit splines or to take a field to
/// an image of voxels. The first and last points along each axis lie on the box. The time is O(m log n) for m points and n
/// cells.
///
/// \tparam ConcurrencyTag enables parallel queries. Possible values are `Sequential_tag` (the default) and `Parallel_tag`.
///
/// \param map the map
/// \param box the box, for instance that of the images
/// \param numbers the number of points along each axis
///
/// \pre Each number is at least 2; otherwise `CGAL::Precondition_exception` is thrown, in every build.
///
/// \sa `IO::write_VTS()`
template <typename ConcurrencyTag = Sequential_tag>
Map_on_grid_3 evaluate_on_grid(const Volume_map_3& map, const Bbox_3& box, const std::array<std::size_t, 3>& numbers)
{
  internal::require((std::min)({ numbers[0], numbers[1], numbers[2] }) >= 2, "numbers must be at least 2 along each axis.");
  Map_on_grid_3 grid = { numbers, {}, {}, {} };
  const auto coordinate = [&](const int axis, const std::size_t i)
  {
    const double t = static_cast<double>(i) / static_cast<double>(numbers[static_cast<std::size_t>(axis)] - 1);
    return (1 - t) * (box.min)(axis) + t * (box.max)(axis); // both ends without rounding
  };
  for(std::size_t k = 0; k < numbers[2]; ++k)
    for(std::size_t j = 0; j < numbers[1]; ++j)
      for(std::size_t i = 0; i < numbers[0]; ++i)
        grid.points.push_back({ coordinate(0, i), coordinate(1, j), coordinate(2, k) });

  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for(const std::optional<Volume_map_3::Location>& location : map.preimages<ConcurrencyTag>(grid.points))
  {
    grid.preimages.push_back({ none, none, none });
    grid.det_J.push_back(none);
    if(!location)
      continue;
    grid.preimages.back() = { location->point.x(), location->point.y(), location->point.z() };
    grid.det_J.back() = 1 / map.inverse_differential(location->cell).determinant();
  }
  return grid;
}

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EVALUATE_ON_GRID_H
