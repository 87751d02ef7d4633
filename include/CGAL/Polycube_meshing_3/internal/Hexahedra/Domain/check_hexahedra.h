// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_CHECK_HEXAHEDRA_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_CHECK_HEXAHEDRA_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/Hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Soups/check_tetrahedron_soup.h>

#include <map>

namespace CGAL::Polycube_meshing_3::internal {

// Returns which of the six quadrangles of a hexahedron has these vertices in any order, or 6 if none has.
inline std::size_t side_of_quadrangle(const Hexahedron_soup_3& mesh, const std::size_t cell,
                                      const std::array<std::size_t, 4>& vertices)
{
  std::size_t side = 0;
  while(side < quadrangles_of_hexahedron.size() && sorted(vertices_of(mesh, { cell, side })) != sorted(vertices))
    ++side;
  return side;
}

// Returns the subdomains on both sides of the i-th quadrangle of interfaces, the smaller reference first.
inline std::array<int, 2> subdomains_at_interface(const Hexahedron_soup_3& mesh, const std::size_t i)
{ return { mesh.cell_references[mesh.interface_cells[i][0]], mesh.cell_references[mesh.interface_cells[i][1]] }; }

// Returns the references of quadrangles of interfaces for files in which each quadrangle needs one. If the reference is 0, the
// quadrangle gets a number of its pair of subdomains. These numbers ascend with the pairs and follow all references.
inline std::vector<int> references_at_interfaces(const Hexahedron_soup_3& mesh, const std::vector<int>& references_of_boundary)
{
  int last = 0;
  for(const std::vector<int>& references : { references_of_boundary, mesh.interface_references })
    for(const int reference : references)
      last = (std::max)(last, reference);
  std::map<std::array<int, 2>, int> numbers; // of pairs of subdomains
  for(std::size_t i = 0; i < mesh.interface_facets.size(); ++i)
    if(mesh.interface_references[i] == 0)
      numbers[subdomains_at_interface(mesh, i)] = 0;
  for(auto& [pair, number] : numbers)
    number = ++last;
  std::vector<int> result = mesh.interface_references;
  for(std::size_t i = 0; i < result.size(); ++i)
    if(result[i] == 0)
      result[i] = numbers.at(subdomains_at_interface(mesh, i));
  return result;
}

// Throws `Input_error` if arrays do not fit together. After this check, writers may trust their indices.
inline void check_hexahedra(const Hexahedron_soup_3& mesh)
{
  const std::size_t n = mesh.cells.size(), m = mesh.facets.size();
  if(mesh.images.size() != mesh.points.size() || mesh.cell_blocks.size() != n || mesh.cell_indices.size() != n
     || mesh.cell_references.size() != n || mesh.facet_cells.size() != m || mesh.polycube_faces.size() != m
     || mesh.facet_references.size() != m)
    throw Input_error("there is not one entry of each array per point, per hexahedron and per quadrangle");
  const std::size_t number_of_facets = mesh.interface_facets.size();
  if(mesh.interface_cells.size() != number_of_facets || mesh.interface_references.size() != number_of_facets)
    throw Input_error("there is not one entry of each array per quadrangle of an interface");
  if(mesh.edges.size() != mesh.edge_references.size())
    throw Input_error("there is not one reference per edge");
  for(std::size_t e = 0; e < mesh.edges.size(); ++e)
    check_simplex(mesh.edges[e], mesh.points.size(), "edge ", e);
  for(const std::size_t v : mesh.corners)
    if(v >= mesh.points.size())
      throw Input_error(sentence("the corner ", v, " is no point"));
  for(std::size_t c = 0; c < n; ++c)
    check_simplex(mesh.cells[c], mesh.points.size(), "hexahedron ", c);
  for(std::size_t f = 0; f < m; ++f)
    if(mesh.facet_cells[f] >= n || side_of_facet(mesh, f) == quadrangles_of_hexahedron.size())
      throw Input_error(sentence("quadrangle ", f, " (counted from 0) is none of its hexahedron"));
  for(std::size_t i = 0; i < mesh.interface_facets.size(); ++i)
    for(const std::size_t c : mesh.interface_cells[i])
      if(c >= n || side_of_quadrangle(mesh, c, mesh.interface_facets[i]) == quadrangles_of_hexahedron.size())
        throw Input_error(sentence("quadrangle ", i, " of an interface (counted from 0) is none of its hexahedra"));
}

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_HEXAHEDRA_DOMAIN_CHECK_HEXAHEDRA_H
