// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_REQUIRE_TETRAHEDRA_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_REQUIRE_TETRAHEDRA_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <limits>

namespace CGAL::Volume_mesh_parameterization::internal {

// Throws `Input_error` if there is no tetrahedron. `converter` makes the file one that TetGen reads, if it is not empty.
inline void require_tetrahedra(const std::size_t number_of_cells, const std::size_t number_of_facets,
                               const std::string& converter = "")
{
  if(number_of_cells > 0)
    return;
  if(number_of_facets == 0)
    throw Input_error("the file contains no tetrahedron");
  throw Input_error("the mesh is a surface with " + counted(number_of_facets, "triangle", "triangles") + " and no tetrahedron. A "
                    "volume mesher fills it: " + (converter.empty() ? "" : "convert it to *.mesh by '" + converter + "', and ")
                    + "pass it to 'tetgen -pqg', which writes a file *.1.mesh");
}

// Refuses a mesh with other cells, named in the plural. The remedy depends on the format.
inline std::string sentence_on_other_cells(const std::string& cells, const char* const remedy = "mesh the body by tetrahedra only")
{ return "the mesh is not tetrahedral, because it has " + cells + "; " + remedy; }

// Removes the points that are no corner of a cell, facet or edge, as those on the edges of second-order cells are not, and no
// marked one, and notes it.
inline void remove_nodes_of_higher_order(Tetrahedron_soup_3& soup)
{
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> indices(soup.points.size(), none);
  const auto for_each_vertex = [&](const auto& f)
  {
    const auto of_all = [&](auto& simplices)
    {
      for(auto& simplex : simplices)
        for(std::size_t& v : simplex)
          f(v);
    };
    of_all(soup.cells);
    of_all(soup.facets);
    of_all(soup.edges);
    std::for_each(soup.corners.begin(), soup.corners.end(), f);
  };
  for_each_vertex([&](const std::size_t v) { indices[v] = 0; });
  std::size_t number_of_points = 0;
  for(std::size_t& index : indices)
    index = index == none ? none : number_of_points++;
  const auto move_entries = [&](auto& values, const std::size_t number_of_components)
  {
    for(std::size_t v = 0; v < indices.size(); ++v)
      for(std::size_t i = 0; i < number_of_components && indices[v] != none; ++i)
        values[indices[v] * number_of_components + i] = values[v * number_of_components + i];
    values.resize(number_of_points * number_of_components);
  };
  soup.notes.push_back("the mesh has cells of a higher order. Only their corners are used; "
                       + counted(indices.size() - number_of_points, "other point is", "other points are") + " left out");
  move_entries(soup.points, 1);
  for(Data_array_3& array : soup.point_data)
    move_entries(array.values, array.number_of_components);
  for_each_vertex([&](std::size_t& v) { v = indices[v]; });
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_REQUIRE_TETRAHEDRA_H
