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

#include <algorithm>
#include <map>

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

using Polygon_of_cell = std::vector<std::size_t>;

// Returns the facets of a pyramid, prism or hexahedron by its number of vertices, whose order is that of MEDIT, Gmsh and VTK. The
// normals point inwards.
inline const std::vector<Polygon_of_cell>& facets_of_polyhedron(const std::size_t number_of_vertices)
{
  static const std::map<std::size_t, std::vector<Polygon_of_cell> > facets = {
    { 5, { { 0, 1, 2, 3 }, { 0, 4, 1 }, { 1, 4, 2 }, { 2, 4, 3 }, { 3, 4, 0 } } },
    { 6, { { 0, 1, 2 }, { 3, 5, 4 }, { 0, 3, 4, 1 }, { 1, 4, 5, 2 }, { 2, 5, 3, 0 } } },
    { 8, { { 0, 1, 2, 3 }, { 4, 7, 6, 5 }, { 0, 4, 5, 1 }, { 1, 5, 6, 2 }, { 2, 6, 7, 3 }, { 3, 7, 4, 0 } } } };
  return facets.at(number_of_vertices);
}

// Splits a polygon at its least vertex, and calls `f(triangle)` for each triangle with three vertices.
template <typename Function>
void for_each_triangle(Polygon_of_cell polygon, const Function& f)
{
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  for(std::size_t i = 2; i < polygon.size(); ++i)
    if(polygon[0] != polygon[i - 1] && polygon[0] != polygon[i] && polygon[i - 1] != polygon[i])
      f(std::array{ polygon[0], polygon[i - 1], polygon[i] });
}

// Splits a polyhedron into tetrahedra, and calls `f(tetrahedron)` for each. Its least vertex is joined to the triangles of the
// other facets. Therefore, neighbors split a common facet alike. Vertices may be repeated, as in a hexahedron that is a prism.
template <typename Function>
void for_each_tetrahedron(const std::vector<std::size_t>& vertices, const Function& f)
{
  const std::size_t least = *std::min_element(vertices.begin(), vertices.end());
  for(const Polygon_of_cell& facet : facets_of_polyhedron(vertices.size()))
  {
    Polygon_of_cell polygon;
    for(const std::size_t i : facet)
      polygon.push_back(vertices[i]);
    if(std::find(polygon.begin(), polygon.end(), least) == polygon.end())
      for_each_triangle(polygon, [&](const std::array<std::size_t, 3>& t) { f(std::array{ t[0], t[1], t[2], least }); });
  }
}

inline std::string note_of_split_cells(const std::size_t number_of_polyhedra)
{
  return counted(number_of_polyhedra, "hexahedron, prism or pyramid is", "hexahedra, prisms and pyramids are")
    + " split into tetrahedra, with diagonals at the least vertices of facets";
}

// Removes points that are no vertex of a cell, facet, edge or corner. Returns their number.
inline std::size_t remove_unused_points(Tetrahedron_soup_3& soup)
{
  std::vector<bool> is_vertex(soup.points.size(), false);
  for_each_vertex(soup, [&](const std::size_t v) { is_vertex[v] = true; });
  std::vector<std::size_t> kept, indices(soup.points.size());
  for(std::size_t v = 0; v < indices.size(); ++v)
  {
    indices[v] = kept.size();
    if(is_vertex[v])
      kept.push_back(v);
  }
  keep_elements(kept, soup.points);
  keep_elements(kept, soup.point_data);
  for_each_vertex(soup, [&](std::size_t& v) { v = indices[v]; });
  return indices.size() - kept.size();
}

// Removes points that are no vertices, such as mid-edge nodes of second-order cells. Adds a note.
inline void remove_nodes_of_higher_order(Tetrahedron_soup_3& soup)
{
  soup.notes.push_back("the mesh has cells of a higher order. Only their corners are used; "
                       + counted(remove_unused_points(soup), "other point is", "other points are") + " left out");
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_REQUIRE_TETRAHEDRA_H
