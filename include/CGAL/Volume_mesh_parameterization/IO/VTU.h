// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTU_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTU_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/cell_distortions.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/hexahedron_corners_3.h>

#include <CGAL/config.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

namespace internal {

// Collects an XML `UnstructuredGrid` in the appended form (VTK User's Guide, "VTK XML Formats"): the XML declares arrays with
// their offsets into the data behind it, where each is its number of bytes and its values, as this machine stores them.
class VTU_writer
{
public:
  // Begins with points, and cells of one type, by the number that VTK gives it.
  template <std::size_t n>
  VTU_writer(const std::vector<std::array<double, 3> >& points, const std::vector<std::array<std::size_t, n> >& cells,
             const int type)
    : m_xml("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
#ifdef CGAL_LITTLE_ENDIAN
            "LittleEndian"
#else
            "BigEndian"
#endif
            "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
            + std::to_string(points.size()) + "\" NumberOfCells=\"" + std::to_string(cells.size()) + "\">\n")
  {
    begin("Points");
    add_points("Points", points);
    end("Points");
    begin("Cells");
    add<std::int32_t>("connectivity", n * cells.size(), [&](const std::size_t i) { return cells[i / n][i % n]; });
    add<std::int64_t>("offsets", cells.size(), [](const std::size_t i) { return n * (i + 1); });
    add<std::uint8_t>("types", cells.size(), [&](std::size_t) { return type; });
    end("Cells");
  }

  void begin(const std::string& element) { m_xml += "<" + element + ">\n"; }
  void end(const std::string& element) { m_xml += "</" + element + ">\n"; }

  // Adds `value(0)`, ..., `value(n - 1)`, converted to `Number`.
  template <typename Number, typename Value>
  void add(const std::string& name, const std::size_t n, const Value& value, const std::size_t number_of_components = 1)
  {
    m_xml += std::string("<DataArray type=\"") + type_name(Number()) + "\" Name=\"" + name + "\" NumberOfComponents=\""
      + std::to_string(number_of_components) + "\" format=\"appended\" offset=\"" + std::to_string(m_data.size())
      + "\"/>\n";
    append(static_cast<std::uint64_t>(n * sizeof(Number)));
    for(std::size_t i = 0; i < n; ++i)
      append(static_cast<Number>(value(i)));
  }

  void add_points(const std::string& name, const std::vector<std::array<double, 3> >& points)
  {
    add<double>(name, 3 * points.size(), [&](const std::size_t i) { return points[i / 3][i % 3]; }, 3);
  }

  void write(std::ostream& os) const
  {
    os << m_xml << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" << m_data
       << "\n</AppendedData>\n</VTKFile>\n";
  }

private:
  static const char* type_name(double) { return "Float64"; }
  static const char* type_name(std::uint8_t) { return "UInt8"; }
  static const char* type_name(std::int32_t) { return "Int32"; }
  static const char* type_name(std::int64_t) { return "Int64"; }

  template <typename Number>
  void append(const Number number)
  {
    m_data.append(reinterpret_cast<const char*>(&number), sizeof(number));
  }

  std::string m_xml, m_data;
};

} // namespace internal

namespace IO {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// writes a tetrahedral mesh with its parameterization as a VTK XML file (`.vtu`), for instance for ParaView.
///
/// The points are those of the mesh and have the vectors `uvw`, their images. The cells have the values `reference`,
/// `angle_distortion` (the ratio of the largest and the smallest stretch plus its inverse), `det_J` (the volume
/// of the image relative to that of the cell) and `volume_distortion` (`det_J` plus its inverse).
/// The values are binary, in the appended form of the format (`encoding="raw"`), so the bits are kept: 53 bytes a cell and 48
/// a point. A failure to write is left in the state of the stream.
///
/// \param os the stream, opened in binary mode (`std::ios::binary`) if it is a file
/// \param soup the mesh
/// \param uvw the image of each point, in the order of the points
/// \pre `uvw` has as many points as `soup`.
inline void write_VTU(std::ostream& os,
                      const Tetrahedron_soup_3& soup,
                      const std::vector<std::array<double, 3> >& uvw)
{
  const std::size_t number_of_cells = soup.cells.size();
  const int vtk_tetra = 10;
  const std::vector<Cell_distortion_3> distortions = cell_distortions(soup.points, soup.cells, uvw);

  internal::VTU_writer writer(soup.points, soup.cells, vtk_tetra);
  writer.begin("PointData");
  writer.add_points("uvw", uvw);
  writer.end("PointData");
  writer.begin("CellData");
  writer.add<std::int32_t>("reference", number_of_cells, [&](std::size_t i) { return soup.cell_references[i]; });
  writer.add<double>("angle_distortion", number_of_cells, [&](std::size_t i) { return distortions[i].angle; });
  writer.add<double>("volume_distortion", number_of_cells, [&](std::size_t i) { return distortions[i].volume; });
  writer.add<double>("det_J", number_of_cells, [&](std::size_t i) { return distortions[i].det_J; });
  writer.end("CellData");
  writer.write(os);
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// writes a mesh complex with its parameterization as a VTK XML file (`.vtu`). Subdomain indices become the values
/// `reference` of the cells.
///
/// \param os the stream
/// \param c3t3 the complex
/// \param uvw_map the image of each vertex of a cell of the complex
///
/// \tparam C3t3 a model of `MeshComplex_3InTriangulation_3` whose type `Subdomain_index` is an integer type
/// \tparam VertexUVWMap a model of `ReadablePropertyMap` with `C3t3::Triangulation::Vertex_handle` as key type
///         and the point type of the geometric traits as value type
template <typename C3t3, typename VertexUVWMap>
void write_VTU(std::ostream& os, const C3t3& c3t3, VertexUVWMap uvw_map)
{
  Tetrahedron_soup_3 soup;
  std::vector<typename C3t3::Triangulation::Vertex_handle> vertices;
  mesh_complex_3_to_tetrahedron_soup(c3t3, soup, vertices);
  IO::write_VTU(os, soup, internal::points_of(vertices, uvw_map));
}

/// \ingroup PkgVolumeMeshParameterizationHexahedra
///
/// writes hexahedra as a VTK XML file (`.vtu`). The cells have the values `scaled_jacobian`, as in
/// `Hexahedral_mesh_result`.
///
/// \param os the stream
/// \param mesh the hexahedra
inline void write_VTU(std::ostream& os, const Hexahedron_soup_3& mesh)
{
  const int vtk_hexahedron = 12;
  const std::vector<double> quality = internal::scaled_jacobians(mesh);

  internal::VTU_writer writer(mesh.points, mesh.cells, vtk_hexahedron);
  writer.begin("CellData");
  writer.add<double>("scaled_jacobian", quality.size(), [&](std::size_t i) { return quality[i]; });
  writer.end("CellData");
  writer.write(os);
}

} // namespace IO
} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTU_H
