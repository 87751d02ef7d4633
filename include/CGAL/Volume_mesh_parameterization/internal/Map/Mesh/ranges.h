// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_RANGES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_RANGES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/Coordinate_type.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <type_traits>

// Points and cells of any types: random access ranges, or matrices of Eigen with a row for each point or cell.
namespace CGAL::Volume_mesh_parameterization::internal {

template <typename Range>
constexpr bool is_matrix = std::is_base_of<Eigen::EigenBase<std::decay_t<Range> >, std::decay_t<Range> >::value;

template <typename Range, typename = void>
struct Is_range : std::bool_constant<is_matrix<Range> > {};

template <typename Range>
struct Is_range<Range, std::void_t<decltype(std::declval<Range&>().begin()), decltype(std::declval<Range&>().size())> >
  : std::true_type {};

template <typename Range>
using If_range = std::enable_if_t<Is_range<Range>::value>;

template <typename Range>
std::size_t number_of_rows(const Range& range)
{
  if constexpr(is_matrix<Range>)
    return static_cast<std::size_t>(range.rows());
  else
    return range.size();
}

// Returns the point or cell of index `i`, with its entries by `operator[]`.
template <typename Range>
decltype(auto) row(Range& range, const std::size_t i)
{
  if constexpr(is_matrix<Range>)
    return range.row(static_cast<Eigen::Index>(i));
  else
    return range.begin()[i];
}

template <typename Range>
using Coordinate_of_range = Coordinate_of<decltype(row(std::declval<Range&>(), 0))>;

template <typename Range>
Coordinate_type coordinate_type_of() { return coordinate_type<Coordinate_of_range<Range> >(); }

// Resizes a range; the first rows keep their values, new ones are undefined.
template <typename Range>
void resize_rows(Range& range, const std::size_t size, const int number_of_columns)
{
  if constexpr(is_matrix<Range>)
    range.conservativeResize(static_cast<Eigen::Index>(size), number_of_columns);
  else
    range.resize(size);
}

template <int number_of_columns, typename Range>
void check_columns(const Range& range)
{
  if constexpr(is_matrix<Range>)
  {
    constexpr int rows = std::decay_t<Range>::RowsAtCompileTime, columns = std::decay_t<Range>::ColsAtCompileTime;
    static_assert(columns == number_of_columns || (columns == Eigen::Dynamic && rows == Eigen::Dynamic),
                  "Matrices have a row for each point or cell, with three or four columns: pass the transposed one.");
    require(range.rows() == 0 || range.cols() == number_of_columns,
            "A matrix of points must have three columns, and one of cells four.");
  }
}

template <typename PointRange>
std::vector<std::array<double, 3> > coordinates_of(const PointRange& points)
{
  check_columns<3>(points);
  std::vector<std::array<double, 3> > result(number_of_rows(points));
  for(std::size_t v = 0; v < result.size(); ++v)
    result[v] = coordinates(row(points, v));
  return result;
}

// Writes the coordinates from index `first` on; what is before stays.
template <typename PointRange>
void assign_coordinates(const std::vector<std::array<double, 3> >& coordinates, PointRange& points,
                        const std::size_t first = 0)
{
  using Coordinate = Coordinate_of_range<PointRange>;
  static_assert(!std::is_integral<Coordinate>::value, "Points that are written must not have integers as coordinates.");
  resize_rows(points, coordinates.size(), 3);
  for(std::size_t v = first; v < coordinates.size(); ++v)
  {
    const Coordinate x(coordinates[v][0]), y(coordinates[v][1]), z(coordinates[v][2]);
    if constexpr(is_matrix<PointRange>)
      row(points, v) << x, y, z;
    else
      row(points, v) = std::decay_t<decltype(row(points, v))>{ x, y, z };
  }
}

template <typename CellRange>
std::vector<std::array<std::size_t, 4> > indices_of(const CellRange& cells)
{
  check_columns<4>(cells);
  const auto index = [](const auto& v) { return static_cast<std::size_t>(v); };
  std::vector<std::array<std::size_t, 4> > result(number_of_rows(cells));
  for(std::size_t c = 0; c < result.size(); ++c)
  {
    const auto& cell = row(cells, c);
    result[c] = { index(cell[0]), index(cell[1]), index(cell[2]), index(cell[3]) };
  }
  return result;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_RANGES_H
