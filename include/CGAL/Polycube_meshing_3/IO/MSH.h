// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_IO_MSH_H
#define CGAL_POLYCUBE_MESHING_3_IO_MSH_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Hexahedron_soup_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/check_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Gmsh_writer.h>

namespace CGAL::Polycube_meshing_3::IO {

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// writes hexahedra in the format of Gmsh, by Gmsh. Quadrangles of the boundary with a reference and quadrangles of interfaces
/// are written with their groups.
///
/// \param os the stream
/// \param mesh the hexahedra
/// \param names the names of groups, as `Tetrahedron_soup_3::group_names` has them
/// \param version 4.1 for a binary file, or 2.2 for text of 16 digits
///
/// \exception Input_error has the sentence of Gmsh if it fails.
inline void write_MSH(std::ostream& os, const Hexahedron_soup_3& mesh,
                      const std::map<std::pair<int, int>, std::string>& names = {}, const double version = 4.1)
{
  internal::check_hexahedra(mesh);
  internal::with_Gmsh([&]
  {
    std::map<std::pair<int, int>, std::string> names_of_groups = names;
    internal::Gmsh_writer writer(mesh.points, names_of_groups);
    writer.add(3, 5, mesh.cells, mesh.cell_references); // dimension, and number of Gmsh for hexahedra
    std::vector<std::array<std::size_t, 4> > facets; // of groups: meshio 5.0 reads no file with others beside them
    std::vector<int> references;
    for(std::size_t f = 0; f < mesh.facets.size(); ++f)
      if(mesh.facet_references[f] > 0)
      {
        facets.push_back(mesh.facets[f]);
        references.push_back(mesh.facet_references[f]);
      }
    const std::vector<int> at_interfaces = internal::references_at_interfaces(mesh, mesh.facet_references);
    for(std::size_t i = 0; i < at_interfaces.size(); ++i)
    {
      const auto [first, second] = internal::subdomains_at_interface(mesh, i);
      names_of_groups.emplace(std::make_pair(2, at_interfaces[i]),
                              "interface_" + std::to_string(first) + "_" + std::to_string(second));
      facets.push_back(mesh.interface_facets[i]);
      references.push_back(at_interfaces[i]);
    }
    writer.add(2, 3, facets, references); // quadrangles
    writer.write(os, version);
  });
}

} // namespace CGAL::Polycube_meshing_3::IO

#endif // CGAL_POLYCUBE_MESHING_3_IO_MSH_H
