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

// Removes points that are no vertex of a cell, facet, edge or corner, such as mid-edge nodes of second-order cells. Adds a
// note.
inline void remove_nodes_of_higher_order(Tetrahedron_soup_3& soup)
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
  soup.notes.push_back("the mesh has cells of a higher order. Only their corners are used; "
                       + counted(indices.size() - kept.size(), "other point is", "other points are") + " left out");
  keep_elements(kept, soup.points);
  keep_elements(kept, soup.point_data);
  for_each_vertex(soup, [&](std::size_t& v) { v = indices[v]; });
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_IO_REQUIRE_TETRAHEDRA_H
