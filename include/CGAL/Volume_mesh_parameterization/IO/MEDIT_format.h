// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_MEDIT_FORMAT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_MEDIT_FORMAT_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/Binary_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/MEDIT_reader.h>
#include <CGAL/Volume_mesh_parameterization/internal/Soups/check_tetrahedron_soup.h>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

inline Tetrahedron_soup_3 read_MEDIT_text(const std::string& text, const Budget& budget)
{
  if(Binary_MEDIT_reader::is_binary(text))
    return Binary_MEDIT_reader(text, budget).read();
  return MEDIT_reader(Text_scanner(text, budget)).read();
}

inline void write_MEDIT_points(Text_writer& writer, const std::vector<std::array<double, 3> >& points)
{
  writer << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << points.size() << "\n";
  for(const std::array<double, 3>& p : points)
    writer << p[0] << " " << p[1] << " " << p[2] << " 0\n";
}

template <std::size_t N, typename Reference>
void write_MEDIT_cells(Text_writer& writer, const char* keyword,
                       const std::vector<std::array<std::size_t, N> >& cells, const std::vector<Reference>& references)
{
  writer << keyword << "\n" << cells.size() << "\n";
  for(std::size_t i = 0; i < cells.size(); ++i)
  {
    for(std::size_t v : cells[i])
      writer << v + 1 << " ";
    writer << references[i] << "\n";
  }
}

inline void write_MEDIT_corners(Text_writer& writer, const std::vector<std::size_t>& corners)
{
  writer << "Corners\n" << corners.size() << "\n";
  for(const std::size_t v : corners)
    writer << v + 1 << "\n";
}

} // namespace internal

namespace IO {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads a tetrahedral mesh from a stream in the \ref IOStreamMedit "MEDIT file format", versions 1 to 4. Text (`.mesh`) may
/// have a byte order mark of UTF-8. Binary files (`.meshb`) may have either order of bytes. The content decides about the
/// format.
///
/// The sections `Vertices`, `Tetrahedra`, `Triangles`, `Edges` and `Corners` are read, in any order, and several of a kind are
/// joined. Of second-order elements (`TetrahedraP2`, ...), only the corners are read. Their other points are left out, and a note
/// of the soup says so. The references of vertices and the other sections are skipped, among them `Ridges`, because all `Edges`
/// are marked. Hexahedra, prisms and pyramids are split into tetrahedra, with diagonals at the least vertices of facets.
/// `Quadrilaterals` are their facets. The final keyword `End` may be missing. The time is linear in the size of the file.
///
/// \param is the stream
/// \param soup gets the mesh
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `maximum_running_time` and
///        `visitor`, as `stretch_minimizing_volume_parameterization()` takes them
///
/// \return `false` if the time is over or the visitor ends the reading; `soup` is then unchanged. A
///         stream that waits for its source is waited for; a file is not.
///
/// \exception Input_error names the line of a text that is wrong, or what is wrong; \c soup is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_MEDIT(std::istream& is, Tetrahedron_soup_3& soup, const NamedParameters& np = parameters::default_values())
{
  return internal::read_within_limits(np, "", [&](const internal::Budget& budget)
  { soup = internal::read_MEDIT_text(internal::read_text(is, budget), budget); });
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads a tetrahedral mesh from a file, likewise.
///
/// \param filename the name of the file
/// \param soup gets the mesh
/// \param np the same named parameters
///
/// \return the same; a pipe that has nothing to read is not waited for after the limit
///
/// \exception Input_error names the file and the line that are wrong; \c soup is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_MEDIT(const std::string& filename, Tetrahedron_soup_3& soup,
                const NamedParameters& np = parameters::default_values())
{
  return internal::read_within_limits(np, filename, [&](const internal::Budget& budget)
  { soup = internal::read_MEDIT_text(internal::read_file(filename, budget), budget); });
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// writes a tetrahedral mesh in the ASCII \ref IOStreamMedit "MEDIT (.mesh) file format".
///
/// Vertices and cells keep their order, and `read_MEDIT()` restores the coordinates bit by bit. The format holds neither the
/// names of groups nor data.
///
/// \param os the stream
/// \param soup the mesh
///
/// \return whether the stream has taken everything
///
/// \exception Input_error if an index does not exist, or a reference is missing.
inline bool write_MEDIT(std::ostream& os, const Tetrahedron_soup_3& soup)
{
  internal::check_simplices(soup);
  internal::Text_writer writer(os);
  internal::write_MEDIT_points(writer, soup.points);
  if(!soup.corners.empty())
    internal::write_MEDIT_corners(writer, soup.corners);
  if(!soup.edges.empty())
    internal::write_MEDIT_cells(writer, "Edges", soup.edges, soup.edge_references);
  if(!soup.facets.empty())
    internal::write_MEDIT_cells(writer, "Triangles", soup.facets, soup.facet_references);
  internal::write_MEDIT_cells(writer, "Tetrahedra", soup.cells, soup.cell_references);
  writer << "End\n";
  return writer.finish();
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// writes a mesh to a file, as to a stream. The file is replaced when it is complete.
///
/// \param filename the name of the file
/// \param soup the tetrahedra
///
/// \return whether the file is complete
inline bool write_MEDIT(const std::string& filename, const Tetrahedron_soup_3& soup)
{ return internal::write_file(filename, [&](std::ostream& os) { IO::write_MEDIT(os, soup); }); }

} // namespace IO
} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_MEDIT_FORMAT_H
