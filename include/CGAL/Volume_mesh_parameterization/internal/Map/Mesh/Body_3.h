// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Vertex_condition_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/ranges.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/arguments.h>

#include <boost/container/static_vector.hpp>

#include <iterator>

namespace CGAL::Volume_mesh_parameterization::internal {

// Which points are vertices of facets or cells?
template <typename Simplices>
std::vector<bool> used_points(const Simplices& simplices, const std::size_t number_of_points)
{
  std::vector<bool> result(number_of_points, false);
  for(const auto& simplex : simplices)
    for(const std::size_t v : simplex)
      result[v] = true;
  return result;
}

// Some points with numbers of their own, in the order in which simplices have them.
struct Numbered_points
{
  std::vector<std::size_t> points;
  std::vector<int> numbers; // of all points, -1 for those without one

  template <typename Simplices>
  Numbered_points(const Simplices& simplices, const std::size_t number_of_points) : numbers(number_of_points, -1)
  {
    for(const auto& simplex : simplices)
      for(const std::size_t p : simplex)
        if(numbers[p] == -1)
        {
          numbers[p] = static_cast<int>(points.size());
          points.push_back(p);
        }
  }
};

// An edge, facet or cell, given by its two, three or four points. Those of a cell are in its order.
using Simplex_3 = boost::container::static_vector<std::size_t, 4>;

// A body as arrays: what complexes, soups, and ranges of any types become on their way to all algorithms.
struct Body_3
{
  std::vector<std::array<double, 3> > points;
  std::vector<std::array<std::size_t, 4> > cells;    // four points each, positive
  std::vector<std::array<std::size_t, 2> > edges;    // marked ones
  std::vector<std::array<std::size_t, 3> > boundary; // the facets of one cell only
  std::vector<std::size_t> sides;                    // which sides these are, before any refinement
  Coordinate_type point_type;                        // in which the user stores the points, also those of refinement
  Coordinate_type image_type;                        // and the images
};

// A point that was made a vertex of an edge, facet or cell, as the mean of its points with these weights, and the cells around
// this, by their numbers then.
struct Insertion_3
{
  std::size_t point;
  Simplex_3 simplex;
  boost::container::static_vector<double, 4> weights;
  std::vector<std::size_t> cells;

  // Returns the mean of values at the points of the simplex.
  template <typename Value>
  double mean(const Value& value) const
  {
    double sum = 0, total_weight = 0;
    for(std::size_t i = 0; i < simplex.size(); ++i)
    {
      sum += weights[i] * value(simplex[i]);
      total_weight += weights[i];
    }
    return sum / total_weight;
  }
};

// The vertices of sides of cells, counterclockwise seen from outside. Side `4 * c + i` is opposite to vertex i of cell c.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
std::vector<std::array<std::size_t, 3> > facets_of_sides(const std::vector<std::array<std::size_t, 4> >& cells,
                                                         const std::vector<std::size_t>& sides);

// Throws `Input_error` if indices are wrong, or facets have more than two cells or two on the same side.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
Body_3 body_of_arrays(std::vector<std::array<double, 3> > points, std::vector<std::array<std::size_t, 4> > cells,
                      std::vector<std::array<std::size_t, 2> > edges = {}, bool is_parallel = false);

template <typename PointRange, typename CellRange>
Body_3 body_of(const PointRange& points, const CellRange& cells)
{ return body_of_arrays(coordinates_of(points), indices_of(cells)); }

// Prescription of the user for the points of a body. Without a target or an initial image, a point has coordinates that are not
// numbers.
struct Prescription_3
{
  std::vector<std::array<double, 3> > targets;
  std::vector<Vertex_condition_3> conditions;
  Vertex_condition_3 boundary_condition;       // of points that splits add to the boundary
  std::vector<bool> slides_in_source;          // has a point the planes, edges and patches of the source? no entries if none has
  std::vector<std::array<double, 3> > initial; // images to start from; none of any point if there are no entries
  std::vector<Linear_constraint_3<std::size_t> > constraints;

  void extend_to(std::size_t number_of_points); // new points are free
  std::vector<bool> prescribed_points() const;  // those that are not free
  std::vector<bool> fixed_points() const;       // those at their targets first
};

// Returns the target with 0 in place of missing coordinates that are not prescribed, or the nearest point of the surface.
CGAL_VOLUME_MESH_PARAMETERIZATION_INLINE
std::array<double, 3> completed_target(std::array<double, 3> target, const Vertex_condition_3& condition);

} // namespace CGAL::Volume_mesh_parameterization::internal

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE
#  include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3_impl.h>
#endif

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_BODY_3_H
