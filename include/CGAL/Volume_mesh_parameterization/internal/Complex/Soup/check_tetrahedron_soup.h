// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_SOUP_CHECK_TETRAHEDRON_SOUP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_SOUP_CHECK_TETRAHEDRON_SOUP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Input_error.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/sentence.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL::Volume_mesh_parameterization::internal {

using Exact_point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;

inline std::array<Exact_point_3, 4> cell_points(const Tetrahedron_soup_3& soup, std::size_t c)
{
  std::array<Exact_point_3, 4> points;
  for(std::size_t i = 0; i < 4; ++i)
  {
    const std::array<double, 3>& p = soup.points[soup.cells[c][i]];
    points[i] = Exact_point_3(p[0], p[1], p[2]);
  }
  return points;
}

inline Orientation cell_orientation(const Tetrahedron_soup_3& soup, std::size_t c)
{
  const std::array<Exact_point_3, 4> p = cell_points(soup, c);
  return CGAL::orientation(p[0], p[1], p[2], p[3]);
}

inline std::string cell_volume(const Tetrahedron_soup_3& soup, std::size_t c)
{
  const std::array<Exact_point_3, 4> p = cell_points(soup, c);
  return sentence(CGAL::volume(p[0], p[1], p[2], p[3]));
}

inline void check_points(const Tetrahedron_soup_3& soup)
{
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    for(double x : soup.points[v])
      if(!std::isfinite(x))
        throw Input_error("vertex " + std::to_string(v) + " (counted from 0) has a coordinate that is not finite");
}

template <std::size_t N>
void check_simplex(const std::array<std::size_t, N>& simplex,
                   std::size_t number_of_points,
                   const char* kind,
                   std::size_t index)
{
  const std::string subject = std::string(kind) + " " + std::to_string(index) + " (counted from 0)";
  for(auto it = simplex.begin(); it != simplex.end(); ++it)
  {
    if(*it >= number_of_points)
      throw Input_error(subject + " has a vertex " + std::to_string(*it) + " that does not exist");
    if(std::find(simplex.begin(), it, *it) != it)
      throw Input_error(subject + " has the vertex " + std::to_string(*it) + " twice");
  }
}

inline void check_simplices(const Tetrahedron_soup_3& soup)
{
  if(soup.cell_references.size() != soup.cells.size() || soup.facet_references.size() != soup.facets.size())
    throw Input_error("there is not one reference per cell and per facet");
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    check_simplex(soup.cells[c], soup.points.size(), "cell", c);
  for(std::size_t f = 0; f < soup.facets.size(); ++f)
    check_simplex(soup.facets[f], soup.points.size(), "triangle", f);
}

// Are the cells negatively oriented? All must be oriented alike, and none may be flat.
inline bool has_negative_cells(const Tetrahedron_soup_3& soup)
{
  const std::size_t none = soup.cells.size();
  std::size_t first_positive = none;
  std::size_t first_negative = none;
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
  {
    const Orientation orientation = cell_orientation(soup, c);
    if(orientation == ZERO)
      throw Input_error("cell " + std::to_string(c) + " (counted from 0) has zero volume");
    std::size_t& first = orientation == POSITIVE ? first_positive : first_negative;
    first = (std::min)(first, c);
  }
  if(first_positive != none && first_negative != none)
    throw Input_error("cell " + std::to_string(first_negative) + " (counted from 0) has the negative volume "
                      + cell_volume(soup, first_negative) + ", but cell " + std::to_string(first_positive)
                      + " has the positive volume " + cell_volume(soup, first_positive));
  return first_negative != none;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_SOUP_CHECK_TETRAHEDRON_SOUP_H
