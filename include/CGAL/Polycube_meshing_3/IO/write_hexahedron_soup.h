// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_IO_WRITE_HEXAHEDRON_SOUP_H
#define CGAL_POLYCUBE_MESHING_3_IO_WRITE_HEXAHEDRON_SOUP_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/Hexahedron_soup_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/check_hexahedra.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Domain/scaled_jacobians.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/VTU_writer.h>

namespace CGAL::Volume_mesh_parameterization::IO {

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// writes hexahedra and the quadrangles of their boundary in the ASCII \ref IOStreamMedit "MEDIT (.mesh) file format". The
/// references of hexahedra are their subdomains, those of quadrangles the ones of the body if there are any, else their faces.
/// Quadrangles of interfaces follow, with their references; those without one have a number for each pair of subdomains, in
/// ascending order, that follow all others.
///
/// \param os the stream
/// \param mesh the hexahedra
///
/// \return whether the stream has taken everything
///
/// \exception Input_error tells which arrays do not fit together.
inline bool write_MEDIT(std::ostream& os, const Hexahedron_soup_3& mesh)
{
  internal::check_hexahedra(mesh);
  internal::Text_writer writer(os);
  internal::write_MEDIT_points(writer, mesh.points);
  internal::write_MEDIT_cells(writer, "Hexahedra", mesh.cells, mesh.cell_references);
  std::vector<std::array<std::size_t, 4> > quadrangles = mesh.facets;
  std::vector<int> references = mesh.facet_references;
  if(std::count(references.begin(), references.end(), 0) == std::ptrdiff_t(references.size()))
    references.assign(mesh.polycube_faces.begin(), mesh.polycube_faces.end());
  const std::vector<int> at_interfaces = internal::references_at_interfaces(mesh, references);
  quadrangles.insert(quadrangles.end(), mesh.interface_facets.begin(), mesh.interface_facets.end());
  references.insert(references.end(), at_interfaces.begin(), at_interfaces.end());
  internal::write_MEDIT_cells(writer, "Quadrilaterals", quadrangles, references);
  writer << "End\n";
  return writer.finish();
}

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// writes hexahedra, and the quadrangles of their boundary and of interfaces, as a VTK XML file (`.vtu`). The points have the
/// vectors `uvw`, their images. The cells have the values `scaled_jacobian` (as in `Hexahedral_mesh_result`), `block`,
/// `grid_index` (the indices (i, j, k) in the block) and `subdomain`. A quadrangle has the values of its hexahedron. The values
/// `face` and `surface` are the face of the polycube and the reference of a quadrangle, and 0 for hexahedra. If there are
/// interfaces, `interface` has the two subdomains of a quadrangle there, and 0 and 0 for all other cells.
///
/// \param os the stream, opened in binary mode if it is a file
/// \param mesh the hexahedra
///
/// \return whether the stream has taken everything
///
/// \exception Input_error tells which arrays do not fit together.
inline bool write_VTU(std::ostream& os, const Hexahedron_soup_3& mesh)
{
  internal::check_hexahedra(mesh);
  const std::size_t number_of_hexahedra = mesh.cells.size(), end_of_boundary = number_of_hexahedra + mesh.facets.size();
  const std::size_t number_of_cells = end_of_boundary + mesh.interface_facets.size();
  const std::vector<double> quality = internal::scaled_jacobians(mesh);
  const auto hexahedron = [&](const std::size_t i)
  {
    return i < number_of_hexahedra ? i : i < end_of_boundary ? mesh.facet_cells[i - number_of_hexahedra]
                                                             : mesh.interface_cells[i - end_of_boundary][0];
  };
  const auto reference = [&](const std::size_t i)
  {
    return i < number_of_hexahedra ? 0 : i < end_of_boundary ? mesh.facet_references[i - number_of_hexahedra]
                                                             : mesh.interface_references[i - end_of_boundary];
  };

  internal::VTU_writer writer(mesh.points, internal::VTU_cells<8>{ mesh.cells, 12 }, internal::VTU_cells<4>{ mesh.facets, 9 },
                              internal::VTU_cells<4>{ mesh.interface_facets, 9 });
  writer.begin("PointData");
  writer.add_points("uvw", mesh.images);
  writer.end("PointData");
  writer.begin("CellData");
  writer.add<double>("scaled_jacobian", number_of_cells, [&](std::size_t i) { return quality[hexahedron(i)]; });
  writer.add<std::int32_t>("block", number_of_cells, [&](std::size_t i) { return mesh.cell_blocks[hexahedron(i)]; });
  writer.add<std::int32_t>("grid_index", 3 * number_of_cells,
                           [&](std::size_t i) { return mesh.cell_indices[hexahedron(i / 3)][i % 3]; }, 3);
  writer.add<std::int32_t>("subdomain", number_of_cells, [&](std::size_t i) { return mesh.cell_references[hexahedron(i)]; });
  writer.add<std::int32_t>("face", number_of_cells, [&](std::size_t i)
  { return i < number_of_hexahedra || i >= end_of_boundary ? 0 : mesh.polycube_faces[i - number_of_hexahedra]; });
  writer.add<std::int32_t>("surface", number_of_cells, reference);
  if(number_of_cells > end_of_boundary)
    writer.add<std::int32_t>("interface", 2 * number_of_cells, [&](std::size_t i)
    { return i / 2 < end_of_boundary ? 0 : internal::subdomains_at_interface(mesh, i / 2 - end_of_boundary)[i % 2]; }, 2);
  writer.end("CellData");
  writer.write(os);
  return os.good();
}

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// writes hexahedra to a file, as to a stream. The file is replaced, but not if an exception is thrown.
///
/// \param filename the name of the file
/// \param mesh the hexahedra
///
/// \return whether the file is complete
inline bool write_MEDIT(const std::string& filename, const Hexahedron_soup_3& mesh)
{ return internal::write_file(filename, [&](std::ostream& os) { IO::write_MEDIT(os, mesh); }); }

/// \ingroup PkgPolycubeMeshing3Hexahedra
///
/// writes hexahedra to a file, as to a stream. The file is replaced, but not if an exception is thrown.
///
/// \param filename the name of the file
/// \param mesh the hexahedra
///
/// \return whether the file is complete
inline bool write_VTU(const std::string& filename, const Hexahedron_soup_3& mesh)
{ return internal::write_file(filename, [&](std::ostream& os) { IO::write_VTU(os, mesh); }); }

} // namespace CGAL::Volume_mesh_parameterization::IO

#endif // CGAL_POLYCUBE_MESHING_3_IO_WRITE_HEXAHEDRON_SOUP_H
