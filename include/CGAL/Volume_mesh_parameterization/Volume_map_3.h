// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_VOLUME_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_VOLUME_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Evaluation/Cell_locator_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_of_complex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace CGAL::Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationResults

evaluates a map that is linear on the cells of a tetrahedral mesh, and its inverse, at any points.

A point of the closed body is always found, also on a facet, an edge or a vertex. Exact predicates decide which cells contain the
point, and the cell of smallest index is returned. If cells or their images overlap, this rule holds, too. Therefore, results do
not depend on the number of threads. The constructor builds a tree of cells for each side. The mesh need not be Delaunay or
convex. Cells that are flat or have a non-finite coordinate are never found.

Construction takes time O(n log n) and memory O(n) for n cells. A query takes time O(log n) for cells of good shape. All
queries are `const`, and several threads may make them.

\sa `CGAL::stretch_minimizing_volume_parameterization()`
*/
class Volume_map_3
{
public:
  /// The type of points, on both sides.
  using Point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;

  /// The image or preimage of a point.
  struct Location
  {
    Point_3 point;                                   ///< the point on the other side
    std::size_t cell;                                ///< the index of the cell found
    std::array<double, 4> barycentric_coordinates;   ///< coordinates in the cell: not negative, of sum 1 up to rounding
  };

  /*!
  takes the map of a complex from `CGAL::stretch_minimizing_volume_parameterization()`. Cells are numbered in the order of
  `cells_in_complex_begin()`.

  \tparam C3t3 a model of `MeshComplex_3InTriangulation_3`
  \tparam VertexUVWMap a model of `ReadablePropertyMap` with `C3t3::Vertex_handle` as key type and
          `C3t3::Triangulation::Geom_traits::Point_3` as value type
  */
  template <typename C3t3, typename VertexUVWMap>
  Volume_map_3(const C3t3& c3t3, const VertexUVWMap uvw_map) : Volume_map_3(arrays_of(c3t3, uvw_map)) {}

  /// takes the points and cells of a mesh in arrays, as `CGAL::stretch_minimizing_volume_parameterization()` does, and the
  /// image of each point. Throws `std::out_of_range` if an index of a cell does not exist.
  /// \pre There are as many images as points; otherwise `CGAL::Precondition_exception` is thrown, in every build.
  template <typename PointRange = std::vector<std::array<double, 3> >,
            typename CellRange = std::vector<std::array<std::size_t, 4> >,
            typename ImageRange = std::vector<std::array<double, 3> > >
  Volume_map_3(const PointRange& points, const CellRange& cells, const ImageRange& images)
    : Volume_map_3(checked({ internal::coordinates_of(points), internal::indices_of(cells), internal::coordinates_of(images) }))
  {}

  /// returns the image of a point; empty if the point is outside.
  std::optional<Location> image(const Point_3& p) const { return carried(m_source.find(p), m_target); }

  /// returns the preimage of a point; empty if the point is outside the image of the body.
  std::optional<Location> preimage(const Point_3& q) const { return carried(m_target.find(q), m_source); }

  /// returns the image of the nearest point of the body. It is for points that rounding may have put outside. The result is
  /// empty if there is no cell, if the point is not finite, or if the squared distance overflows. The time grows with the
  /// distance.
  std::optional<Location> nearest_image(const Point_3& p) const { return carried(m_source.find_nearest(p), m_target); }

  /// returns the preimage of the nearest point of the image of the body, as `nearest_image()` does.
  std::optional<Location> nearest_preimage(const Point_3& q) const { return carried(m_target.find_nearest(q), m_source); }

  /// interpolates data of the vertices, linearly on each cell.
  ///
  /// \tparam ValueRange a random access range of numbers, vectors of \cgal or Eigen, or other values with a sum and a product by
  ///         `double`. A matrix of Eigen with a row for each point is also possible. For a column vector of Eigen, the result is a
  ///         number.
  /// \param location a result of one of the queries, of either direction
  /// \param values the value at each point of the arrays, or of a complex in the order of
  ///        `mesh_complex_3_to_tetrahedron_soup()`
  /// \pre There are as many values as points, and the location is of this map; otherwise `CGAL::Precondition_exception` is
  ///      thrown, in every build.
  template <typename ValueRange>
  auto interpolate(const Location& location, const ValueRange& values) const
  {
    internal::require(internal::number_of_rows(values) == m_source.number_of_points(),
                      "values must have an element for each point.");
    internal::require(location.cell < m_source.number_of_cells(), "location must be a result of this map.");
    const std::array<std::size_t, 4>& cell = m_source.vertices(location.cell);
    const std::array<double, 4>& b = location.barycentric_coordinates;
    const auto value = [&](const int i) -> decltype(auto) { return internal::row(values, cell[i]); };
    const auto sum = [&]() { return b[0] * value(0) + b[1] * value(1) + b[2] * value(2) + b[3] * value(3); };
    using Value = std::decay_t<decltype(value(0))>;
    if constexpr(!internal::is_matrix<Value>)
      return sum();
    else if constexpr(Value::SizeAtCompileTime == 1) // a row of a vector
      return sum().value();
    else
      return typename Value::PlainObject(sum()); // a sum of Eigen would refer to its parts
  }

  /// returns the differential in the cell that `image()` finds, a 3 x 3 matrix; empty if the point is outside.
  std::optional<Eigen::Matrix3d> differential(const Point_3& p) const
  {
    const std::optional<internal::Point_in_cell_3> found = m_source.find(p);
    if(!found)
      return std::nullopt;
    // D E = F for the edges E of the cell and F of its image
    return edges(m_source, found->cell).transpose().fullPivLu().solve(edges(m_target, found->cell).transpose())
      .transpose();
  }

  /// returns the differential of the inverse in a cell, a 3 x 3 matrix; not finite if the image of the cell is flat.
  /// \pre The cell exists; otherwise `CGAL::Precondition_exception` is thrown, in every build.
  Eigen::Matrix3d inverse_differential(const std::size_t cell) const
  {
    internal::require(cell < m_source.number_of_cells(), "cell must be the index of a cell.");
    return edges(m_source, cell) * edges(m_target, cell).inverse();
  }

  /// \name Ranges
  /// Queries for each point of a range, as for `CGAL::stretch_minimizing_volume_parameterization()`. With
  /// `ConcurrencyTag = Parallel_tag`, they run in parallel. Spatial sorting of the points saves much time for large meshes.
  /// @{

  /// returns what `image()` returns, for each point.
  template <typename ConcurrencyTag = Sequential_tag, typename PointRange>
  std::vector<std::optional<Location> > images(const PointRange& points) const
  { return for_each_point<ConcurrencyTag, Location>(points, [this](const Point_3& p) { return image(p); }); }

  /// returns what `preimage()` returns, for each point.
  template <typename ConcurrencyTag = Sequential_tag, typename PointRange>
  std::vector<std::optional<Location> > preimages(const PointRange& points) const
  { return for_each_point<ConcurrencyTag, Location>(points, [this](const Point_3& q) { return preimage(q); }); }

  /// returns what `nearest_image()` returns, for each point.
  template <typename ConcurrencyTag = Sequential_tag, typename PointRange>
  std::vector<std::optional<Location> > nearest_images(const PointRange& points) const
  { return for_each_point<ConcurrencyTag, Location>(points, [this](const Point_3& p) { return nearest_image(p); }); }

  /// returns what `nearest_preimage()` returns, for each point.
  template <typename ConcurrencyTag = Sequential_tag, typename PointRange>
  std::vector<std::optional<Location> > nearest_preimages(const PointRange& points) const
  { return for_each_point<ConcurrencyTag, Location>(points, [this](const Point_3& q) { return nearest_preimage(q); }); }

  /// returns what `differential()` returns, for each point.
  template <typename ConcurrencyTag = Sequential_tag, typename PointRange>
  std::vector<std::optional<Eigen::Matrix3d> > differentials(const PointRange& points) const
  { return for_each_point<ConcurrencyTag, Eigen::Matrix3d>(points, [this](const Point_3& p) { return differential(p); }); }
  /// @}

private:
  struct Arrays
  {
    std::vector<std::array<double, 3> > points;
    std::vector<std::array<std::size_t, 4> > cells;
    std::vector<std::array<double, 3> > images;
  };

  template <typename C3t3, typename VertexUVWMap>
  static Arrays arrays_of(const C3t3& c3t3, const VertexUVWMap& uvw_map)
  {
    internal::Body_of_complex_3<C3t3> body(c3t3);
    return { std::move(body.points), std::move(body.cells), internal::points_of(body.vertices, uvw_map) };
  }

  static Arrays checked(Arrays map)
  {
    internal::require(map.images.size() == map.points.size(), "images must have an element for each point.");
    return map;
  }

  explicit Volume_map_3(const Arrays& map) : m_source(map.points, map.cells), m_target(map.images, map.cells) {}

  static std::optional<Location> carried(const std::optional<internal::Point_in_cell_3>& found,
                                         const internal::Cell_locator_3& other)
  {
    if(!found)
      return std::nullopt;
    std::array<double, 3> p = {0, 0, 0};
    for(std::size_t i = 0; i < 4; ++i)
      for(int k = 0; k < 3; ++k)
        p[static_cast<std::size_t>(k)] += found->coordinates[i] * other.corner(found->cell, i)[k];
    return Location{ Point_3(p[0], p[1], p[2]), found->cell, found->coordinates };
  }

  static Eigen::Matrix3d edges(const internal::Cell_locator_3& side, const std::size_t cell)
  {
    Eigen::Matrix3d result;
    for(int i = 0; i < 3; ++i)
      result.col(i) = Eigen::Vector3d(internal::to_vector(side.corner(cell, i + 1)) - internal::to_vector(side.corner(cell, 0)));
    return result;
  }

  template <typename ConcurrencyTag, typename Result, typename PointRange, typename Query>
  static std::vector<std::optional<Result> > for_each_point(const PointRange& points, const Query& query)
  {
    std::vector<Point_3> queries;
    for(const auto& [x, y, z] : internal::coordinates_of(points))
      queries.emplace_back(x, y, z);
    // neighbors, one after the other, find the same part of a tree in the cache; points that are not finite are not found
    std::vector<std::size_t> order;
    for(std::size_t i = 0; i < queries.size(); ++i)
      if(internal::is_finite_point(queries[i]))
        order.push_back(i);
    internal::sort_in_space<ConcurrencyTag>(order.begin(), order.end(), queries);
    std::vector<std::optional<Result> > results(queries.size());
    internal::for_each_index(internal::is_parallel<ConcurrencyTag>(), 0, order.size(), [&](const std::size_t k)
    { results[order[k]] = query(queries[order[k]]); });
    return results;
  }

  internal::Cell_locator_3 m_source, m_target;
};

} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_VOLUME_MAP_3_H
