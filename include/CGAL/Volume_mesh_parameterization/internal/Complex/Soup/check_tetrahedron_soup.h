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
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_point_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/sentence.h>

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

template <std::size_t N>
void check_simplex(const std::array<std::size_t, N>& simplex, const std::size_t number_of_points, const char* kind,
                   const std::size_t index)
{
  for(auto it = simplex.begin(); it != simplex.end(); ++it)
  {
    if(*it >= number_of_points)
      throw Input_error(sentence(kind, index, " (counted from 0) has a vertex ", *it, " that does not exist"));
    if(std::find(simplex.begin(), it, *it) != it)
      throw Input_error(sentence(kind, index, " (counted from 0) has the vertex ", *it, " twice"));
  }
}

inline void check_simplices(const Tetrahedron_soup_3& soup)
{
  if(soup.cell_references.size() != soup.cells.size() || soup.facet_references.size() != soup.facets.size())
    throw Input_error("there is not one reference per cell and per facet");
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
    check_simplex(soup.cells[c], soup.points.size(), "cell ", c);
  for(std::size_t f = 0; f < soup.facets.size(); ++f)
    check_simplex(soup.facets[f], soup.points.size(), "triangle ", f);
}

// Are the cells negatively oriented? All must be oriented alike, and none may be flat.
inline bool has_negative_cells(const Tetrahedron_soup_3& soup)
{
  const std::size_t none = soup.cells.size();
  std::size_t first_positive = none, first_negative = none;
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
  {
    const auto [p, q, r, s] = cell_points(soup, c);
    const Orientation orientation = CGAL::orientation(p, q, r, s);
    if(orientation == ZERO)
      throw Input_error(sentence("cell ", c, " (counted from 0) has zero volume"));
    std::size_t& first = orientation == POSITIVE ? first_positive : first_negative;
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

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_SOUP_CHECK_TETRAHEDRON_SOUP_H
