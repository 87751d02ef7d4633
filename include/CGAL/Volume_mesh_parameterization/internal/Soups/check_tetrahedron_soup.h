// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_CHECK_TETRAHEDRON_SOUP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_CHECK_TETRAHEDRON_SOUP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Facet_matching_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/exact_point_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <cmath>

namespace CGAL::Volume_mesh_parameterization::internal {

inline std::array<Exact_point_3, 4> cell_points(const Tetrahedron_soup_3& soup, std::size_t c)
{
  const auto point = [&](const std::size_t i) { return exact_point(soup.points[soup.cells[c][i]]); };
  return { point(0), point(1), point(2), point(3) };
}

inline void check_points(const Tetrahedron_soup_3& soup)
{
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    for(double x : soup.points[v])
      if(!std::isfinite(x))
        throw Input_error(sentence("vertex ", v, " (counted from 0) has a coordinate that is not finite"));
}

inline void check_data(const std::vector<Data_array_3>& arrays, const std::size_t number_of_elements)
{
  for(const Data_array_3& array : arrays)
    if(array.values.size() != number_of_elements * array.number_of_components)
      throw Input_error("the data '" + array.name + "' have not the size of the mesh");
}

inline void check_simplices(const Tetrahedron_soup_3& soup)
{
  if(soup.cell_references.size() != soup.cells.size() || soup.facet_references.size() != soup.facets.size()
     || soup.edge_references.size() != soup.edges.size())
    throw Input_error("there is not one reference per cell, facet and edge");
  check_data(soup.point_data, soup.points.size());
  check_data(soup.cell_data, soup.cells.size());
  check_data(soup.facet_data, soup.facets.size());
  check_data(soup.edge_data, soup.edges.size());
  check_cells(soup.cells, soup.points.size());
  for(std::size_t f = 0; f < soup.facets.size(); ++f)
    check_simplex(soup.facets[f], soup.points.size(), "triangle ", f);
  for(std::size_t e = 0; e < soup.edges.size(); ++e)
    check_simplex(soup.edges[e], soup.points.size(), "edge ", e);
  for(std::size_t c = 0; c < soup.corners.size(); ++c)
    check_simplex(std::array{ soup.corners[c] }, soup.points.size(), "corner ", c);
}

inline std::vector<Orientation> orientations_of_cells(const Tetrahedron_soup_3& soup, const bool is_parallel)
{
  return values_of_indices(is_parallel, soup.cells.size(), [&](const std::size_t c)
  {
    const auto [p, q, r, s] = cell_points(soup, c);
    return CGAL::orientation(p, q, r, s);
  });
}

// Are the cells negatively oriented? All must be oriented alike, and none may be flat.
inline bool has_negative_cells(const Tetrahedron_soup_3& soup, const bool is_parallel = false)
{
  const std::vector<Orientation> orientations = orientations_of_cells(soup, is_parallel);
  const std::size_t none = soup.cells.size();
  std::size_t first_positive = none, first_negative = none;
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
  {
    if(orientations[c] == ZERO)
      throw Input_error(sentence("cell ", c, " (counted from 0) has zero volume"));
    std::size_t& first = orientations[c] == POSITIVE ? first_positive : first_negative;
    first = (std::min)(first, c);
  }
  const auto volume = [&](const std::size_t c)
  {
    const auto [p, q, r, s] = cell_points(soup, c);
    return CGAL::volume(p, q, r, s);
  };
  if(first_positive != none && first_negative != none)
    throw Input_error(sentence("cell ", first_negative, " (counted from 0) has the negative volume ", volume(first_negative),
                               ", but cell ", first_positive, " has the positive volume ", volume(first_positive)));
  return first_negative != none;
}

template <typename PointRange, typename CellRange>
Tetrahedron_soup_3 soup_of(const PointRange& points, const CellRange& cells)
{ return { coordinates_of(points), indices_of(cells), std::vector<int>(number_of_rows(cells)), {}, {} }; }

template <typename T>
constexpr bool is_soup = std::is_same<std::remove_const_t<T>, Tetrahedron_soup_3>::value;

template <typename Soup>
using If_soup = std::enable_if_t<is_soup<Soup> >;

inline Body_3 body_of(const Tetrahedron_soup_3& soup, const bool is_parallel = false)
{
  check_simplices(soup);
  return body_of_arrays(soup.points, soup.cells, soup.edges, is_parallel);
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOUPS_CHECK_TETRAHEDRON_SOUP_H
