// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_EVALUATION_CELL_LOCATOR_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_EVALUATION_CELL_LOCATOR_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/determinant.h>

#include <boost/config/pragma_message.hpp>
#include <boost/iterator/function_output_iterator.hpp>

// Silences a message at each compilation: the R-tree of Boost 1.74 includes a header that Boost deprecates.
#pragma push_macro("BOOST_PRAGMA_MESSAGE")
#undef BOOST_PRAGMA_MESSAGE
#define BOOST_PRAGMA_MESSAGE(x)
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#pragma pop_macro("BOOST_PRAGMA_MESSAGE")

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

using Corners_3 = std::array<Exact_point_3, 4>;

// Returns six times the volumes of the four tetrahedra in which a point replaces one corner.
template <typename FT>
std::array<FT, 4> volumes_with_point_3(const Corners_3& corners, const Exact_point_3& p)
{
  std::array<std::array<FT, 3>, 4> d;
  for(std::size_t i = 0; i < 4; ++i)
    for(int k = 0; k < 3; ++k)
      d[i][static_cast<std::size_t>(k)] = FT(corners[i][k]) - FT(p[k]);
  const auto volume = [&](const std::size_t i, const std::size_t j, const std::size_t k)
  { return FT(CGAL::determinant<FT>(d[i][0], d[i][1], d[i][2], d[j][0], d[j][1], d[j][2], d[k][0], d[k][1], d[k][2])); };
  return { volume(1, 2, 3), volume(0, 3, 2), volume(0, 1, 3), volume(0, 2, 1) };
}

// Returns the barycentric coordinates of a point in the closed tetrahedron: not negative, of sum 1 up to rounding. Rounding
// errs by some 1e-15 L^3 in each volume, for a tetrahedron of size L; unless this is small against the sum of the volumes,
// they are computed exactly.
inline std::array<double, 4> barycentric_coordinates_3(const Corners_3& corners, const Exact_point_3& p)
{
  double size = 0;
  for(const Exact_point_3& corner : corners)
    for(int k = 0; k < 3; ++k)
      size = (std::max)(size, std::abs(corner[k] - p[k]));
  std::array<double, 4> result = volumes_with_point_3<double>(corners, p);
  double sum = result[0] + result[1] + result[2] + result[3];
  if(!(std::abs(sum) > 1e-5 * size * size * size))
  {
    const std::array<Exact_rational, 4> exact = volumes_with_point_3<Exact_rational>(corners, p);
    const Exact_rational exact_sum = exact[0] + exact[1] + exact[2] + exact[3];
    for(std::size_t i = 0; i < 4; ++i)
      result[i] = CGAL::to_double(Exact_rational(exact[i] / exact_sum));
    sum = 1;
  }
  double clamped_sum = 0;
  for(double& coordinate : result)
    clamped_sum += coordinate = (std::max)(0., coordinate / sum);
  for(double& coordinate : result)
    coordinate /= clamped_sum;
  return result;
}

// Point of the closed body, by a cell that has it.
struct Point_in_cell_3
{
  std::size_t cell = 0;
  std::array<double, 4> coordinates{}; // barycentric coordinates
};

// Finds the tetrahedra that contain points, by a packed R-tree of their bounding boxes. The boxes are exact, and exact
// predicates decide in them, so there are no gaps between cells. Cells that are flat or not finite are never found.
class Cell_locator_3
{
public:
  Cell_locator_3(const std::vector<std::array<double, 3> >& points, const std::vector<std::array<std::size_t, 4> >& cells)
    : m_cells(cells)
  {
    m_points.reserve(points.size());
    for(const std::array<double, 3>& p : points)
      m_points.push_back(exact_point(p));

    std::vector<Entry> entries;
    entries.reserve(m_cells.size());
    for(std::size_t c = 0; c < m_cells.size(); ++c)
    {
      const Corners_3 p = corners(c);
      if(std::all_of(p.begin(), p.end(), is_finite_point) && orientation_of(p) != COPLANAR)
        entries.emplace_back(box_of(p), c);
    }
    m_tree = Tree(entries); // packs, unlike insertion
  }

  std::size_t number_of_points() const { return m_points.size(); }
  std::size_t number_of_cells() const { return m_cells.size(); }
  const std::array<std::size_t, 4>& vertices(const std::size_t cell) const { return m_cells[cell]; }
  const Exact_point_3& corner(const std::size_t cell, const std::size_t i) const { return m_points[m_cells[cell][i]]; }

  // Finds the cell of smallest index whose closure contains the point.
  std::optional<Point_in_cell_3> find(const Exact_point_3& p) const
  {
    if(!is_finite_point(p))
      return std::nullopt;
    std::size_t cell = m_cells.size();
    for_each_cell_at(to_tree(p), [&](const std::size_t c)
    {
      if(c < cell && contains(corners(c), p))
        cell = c;
    });
    if(cell == m_cells.size())
      return std::nullopt;
    return Point_in_cell_3{ cell, barycentric_coordinates_3(corners(cell), p) };
  }

  // Finds the point itself, or the nearest one of the closed body, up to rounding; none if there are no cells, or the squared
  // distance overflows.
  std::optional<Point_in_cell_3> find_nearest(const Exact_point_3& p) const
  {
    if(!is_finite_point(p) || m_tree.empty())
      return std::nullopt;
    if(const std::optional<Point_in_cell_3> found = find(p))
      return found;
    // the cell of the nearest box bounds the distance; then all cells that may be as near are compared
    const auto in_nearest_box = m_tree.qbegin(boost::geometry::index::nearest(to_tree(p), 1));
    std::size_t cell = in_nearest_box->second;
    Exact_point_3 nearest = nearest_on_facets(corners(cell), p);
    double distance = CGAL::squared_distance(p, nearest);
    if(!CGAL::is_finite(distance))
      return std::nullopt;
    const double r = std::sqrt(distance);
    const Box around(Tree_point(p.x() - r, p.y() - r, p.z() - r), Tree_point(p.x() + r, p.y() + r, p.z() + r));
    for_each_cell_at(around, [&](const std::size_t c)
    {
      const Exact_point_3 candidate = nearest_on_facets(corners(c), p);
      const double to_cell = CGAL::squared_distance(p, candidate);
      if(to_cell < distance || (to_cell == distance && c < cell))
      {
        distance = to_cell;
        cell = c;
        nearest = candidate;
      }
    });
    return Point_in_cell_3{ cell, barycentric_coordinates_3(corners(cell), nearest) };
  }

private:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Tree_point = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Box = boost::geometry::model::box<Tree_point>;
  using Entry = std::pair<Box, std::size_t>;
  using Tree = boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<8> >;

  // Calls f for each cell whose bounding box intersects a point or a box. A visitor takes less time than iterators.
  template <typename Geometry, typename Function>
  void for_each_cell_at(const Geometry& geometry, const Function& f) const
  {
    m_tree.query(boost::geometry::index::intersects(geometry),
                 boost::make_function_output_iterator([&](const Entry& entry) { f(entry.second); }));
  }

  Corners_3 corners(const std::size_t c) const
  {
    const std::array<std::size_t, 4>& cell = m_cells[c];
    return { m_points.at(cell[0]), m_points.at(cell[1]), m_points.at(cell[2]), m_points.at(cell[3]) };
  }

  static Orientation orientation_of(const Corners_3& p) { return CGAL::orientation(p[0], p[1], p[2], p[3]); }

  static Tree_point to_tree(const Exact_point_3& p) { return Tree_point(p.x(), p.y(), p.z()); }

  static Box box_of(const Corners_3& p)
  {
    const Bbox_3 box = p[0].bbox() + p[1].bbox() + p[2].bbox() + p[3].bbox();
    return Box(Tree_point(box.xmin(), box.ymin(), box.zmin()), Tree_point(box.xmax(), box.ymax(), box.zmax()));
  }

  static bool contains(const Corners_3& tetrahedron, const Exact_point_3& p)
  {
    const Orientation outside = CGAL::opposite(orientation_of(tetrahedron));
    for(std::size_t i = 0; i < 4; ++i)
    {
      Corners_3 replaced = tetrahedron;
      replaced[i] = p;
      if(orientation_of(replaced) == outside)
        return false;
    }
    return true;
  }

  static Exact_point_3 nearest_on_facets(const Corners_3& corners, const Exact_point_3& p)
  {
    std::array<Exact_point_3, 4> candidates;
    for(std::size_t i = 0; i < 4; ++i)
      candidates[i] = Kernel().construct_projected_point_3_object()(
        Kernel::Triangle_3(corners[(i + 1) % 4], corners[(i + 2) % 4], corners[(i + 3) % 4]), p);
    return *std::min_element(candidates.begin(), candidates.end(), [&](const Exact_point_3& a, const Exact_point_3& b)
    { return CGAL::squared_distance(a, p) < CGAL::squared_distance(b, p); });
  }

  std::vector<Exact_point_3> m_points;
  std::vector<std::array<std::size_t, 4> > m_cells;
  Tree m_tree;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_EVALUATION_CELL_LOCATOR_3_H
