// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
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
#include <CGAL/Volume_mesh_parameterization/internal/Files/Text_writer.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/hexahedron_corners_3.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

namespace internal {

// Writes the parts of an XML `UnstructuredGrid` with all values as text.
class VTU_writer
{
public:
  explicit VTU_writer(std::ostream& os)
    : m_writer(os)
  {}

  void begin_grid(std::size_t number_of_points, std::size_t number_of_cells)
  {
    m_writer << "<?xml version=\"1.0\"?>\n"
            << "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
            << "<UnstructuredGrid>\n"
            << "<Piece NumberOfPoints=\"" << number_of_points
            << "\" NumberOfCells=\"" << number_of_cells << "\">\n";
  }

  void end_grid()
  {
    m_writer << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }

  void begin(const char* element) { m_writer << "<" << element << ">\n"; }
  void end(const char* element) { m_writer << "</" << element << ">\n"; }

  template <std::size_t N, typename Number>
  void write_tuples(const char* name, const std::vector<std::array<Number, N> >& tuples,
                    const std::size_t number_of_components = N)
  {
    begin_array(type_name(Number()), name, number_of_components);
    for(const std::array<Number, N>& tuple : tuples)
    {
      for(const Number& x : tuple)
        m_writer << x << " ";
      m_writer << "\n";
    }
    end_array();
  }

  // Writes `value(0)`, ..., `value(n - 1)`.
  template <typename Value>
  void write_values(const char* name, std::size_t n, const Value& value)
  {
    begin_array(type_name(decltype(value(n))()), name, 1);
    for(std::size_t i = 0; i < n; ++i)
      m_writer << value(i) << "\n";
    end_array();
  }

private:
  static const char* type_name(double) { return "Float64"; }
  static const char* type_name(int) { return "Int32"; }
  static const char* type_name(std::size_t) { return "Int64"; }

  void begin_array(const char* type, const char* name, std::size_t number_of_components)
  {
    m_writer << "<DataArray type=\"" << type << "\" Name=\"" << name
            << "\" NumberOfComponents=\"" << number_of_components << "\" format=\"ascii\">\n";
  }

  void end_array() { end("DataArray"); }

  Text_writer m_writer;
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
/// All values are text from which reading restores the same bits.
/// A failure to write is left in the state of the stream.
///
/// \param os the stream
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

  internal::VTU_writer writer(os);
  writer.begin_grid(soup.points.size(), number_of_cells);

  writer.begin("Points");
  writer.write_tuples("Points", soup.points);
  writer.end("Points");

  writer.begin("Cells");
  writer.write_tuples("connectivity", soup.cells, 1); // cells may have different numbers of vertices, for VTK
  writer.write_values("offsets", number_of_cells, [](std::size_t i) { return 4 * (i + 1); });
  writer.write_values("types", number_of_cells, [](std::size_t) { return vtk_tetra; });
  writer.end("Cells");

  writer.begin("PointData");
  writer.write_tuples("uvw", uvw);
  writer.end("PointData");

  writer.begin("CellData");
  writer.write_values("reference", number_of_cells, [&](std::size_t i) { return soup.cell_references[i]; });
  writer.write_values("angle_distortion", number_of_cells, [&](std::size_t i) { return distortions[i].angle; });
  writer.write_values("volume_distortion", number_of_cells, [&](std::size_t i) { return distortions[i].volume; });
  writer.write_values("det_J", number_of_cells, [&](std::size_t i) { return distortions[i].det_J; });
  writer.end("CellData");

  writer.end_grid();
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

  std::vector<std::array<double, 3> > uvw;
  uvw.reserve(vertices.size());
  for(typename C3t3::Triangulation::Vertex_handle v : vertices)
    uvw.push_back(internal::coordinates(get(uvw_map, v)));
  IO::write_VTU(os, soup, uvw);
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
  const std::size_t number_of_cells = mesh.cells.size();
  const int vtk_hexahedron = 12;
  const std::vector<double> quality = internal::scaled_jacobians(mesh);

  internal::VTU_writer writer(os);
  writer.begin_grid(mesh.points.size(), number_of_cells);

  writer.begin("Points");
  writer.write_tuples("Points", mesh.points);
  writer.end("Points");

  writer.begin("Cells");
  writer.write_tuples("connectivity", mesh.cells, 1);
  writer.write_values("offsets", number_of_cells, [](std::size_t i) { return 8 * (i + 1); });
  writer.write_values("types", number_of_cells, [](std::size_t) { return vtk_hexahedron; });
  writer.end("Cells");

  writer.begin("CellData");
  writer.write_values("scaled_jacobian", number_of_cells, [&](std::size_t i) { return quality[i]; });
  writer.end("CellData");

  writer.end_grid();
}

} // namespace IO
} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTU_H
