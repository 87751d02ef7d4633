// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_MEDIT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_MEDIT_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Files/MEDIT_reader.h>
#include <CGAL/Volume_mesh_parameterization/internal/Files/Text_writer.h>
#include <CGAL/Volume_mesh_parameterization/internal/Files/read_text.h>

#include <array>
#include <cstddef>
#include <istream>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

inline void write_MEDIT_points(Text_writer& writer, const std::vector<std::array<double, 3> >& points)
{
  writer << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << points.size() << "\n";
  for(const std::array<double, 3>& p : points)
    writer << p[0] << " " << p[1] << " " << p[2] << " 0\n";
}

template <std::size_t N>
void write_MEDIT_cells(Text_writer& writer,
                       const char* keyword,
                       const std::vector<std::array<std::size_t, N> >& cells,
                       const std::vector<int>& references)
{
  writer << keyword << "\n" << cells.size() << "\n";
  for(std::size_t i = 0; i < cells.size(); ++i)
  {
    for(std::size_t v : cells[i])
      writer << v + 1 << " ";
    writer << references[i] << "\n";
  }
}

} // namespace internal

namespace IO {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads a tetrahedral mesh from a stream in the ASCII \ref IOStreamMedit "MEDIT (.mesh) file format".
///
/// The sections `Vertices`, `Tetrahedra` and `Triangles` are read, in any order; the references of vertices and
/// the other sections are skipped, except that volume elements other than tetrahedra are an error.
/// The final keyword `End` may be missing. The time is linear in the size of the file.
///
/// \param is the stream
/// \param soup gets the mesh
///
/// \exception Input_error names the line that is wrong; `soup` is then unchanged.
inline void read_MEDIT(std::istream& is, Tetrahedron_soup_3& soup)
{
  const std::string text = internal::read_text(is);
  soup = internal::MEDIT_reader(text).read();
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads a tetrahedral mesh from a file in the ASCII \ref IOStreamMedit "MEDIT (.mesh) file format".
///
/// \param filename the name of the file
/// \param soup gets the mesh
///
/// \exception Input_error names the file and the line that are wrong; `soup` is then unchanged.
inline void read_MEDIT(const std::string& filename, Tetrahedron_soup_3& soup)
{
  internal::read_file(filename, [&](std::istream& is)
  {
    IO::read_MEDIT(is, soup);
  });
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// writes a tetrahedral mesh in the ASCII \ref IOStreamMedit "MEDIT (.mesh) file format".
///
/// Vertices and cells keep their order, and `read_MEDIT()` restores the coordinates bit by bit.
/// A failure to write is left in the state of the stream.
///
/// \param os the stream
/// \param soup the mesh
inline void write_MEDIT(std::ostream& os, const Tetrahedron_soup_3& soup)
{
  internal::Text_writer writer(os);
  internal::write_MEDIT_points(writer, soup.points);
  if(!soup.facets.empty())
    internal::write_MEDIT_cells(writer, "Triangles", soup.facets, soup.facet_references);
  internal::write_MEDIT_cells(writer, "Tetrahedra", soup.cells, soup.cell_references);
  writer << "End\n";
}

/// \ingroup PkgVolumeMeshParameterizationHexahedra
///
/// writes hexahedra in the ASCII \ref IOStreamMedit "MEDIT (.mesh) file format", with the reference 0.
///
/// \param os the stream
/// \param mesh the hexahedra
inline void write_MEDIT(std::ostream& os, const Hexahedron_soup_3& mesh)
{
  internal::Text_writer writer(os);
  internal::write_MEDIT_points(writer, mesh.points);
  internal::write_MEDIT_cells(writer, "Hexahedra", mesh.cells, std::vector<int>(mesh.cells.size(), 0));
  writer << "End\n";
}

} // namespace IO
} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_MEDIT_H
