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
#include <CGAL/Volume_mesh_parameterization/internal/Files/VTU_writer.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra/hexahedron_corners_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

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

  internal::VTU_writer writer(soup.points.size(), number_of_cells);

  writer.begin("Points");
  writer.add_points("Points", soup.points);
  writer.end("Points");

  writer.add_cells(soup.cells, vtk_tetra);

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
  const std::size_t number_of_cells = mesh.cells.size();
  const int vtk_hexahedron = 12;
  const std::vector<double> quality = internal::scaled_jacobians(mesh);

  internal::VTU_writer writer(mesh.points.size(), number_of_cells);

  writer.begin("Points");
  writer.add_points("Points", mesh.points);
  writer.end("Points");

  writer.add_cells(mesh.cells, vtk_hexahedron);

  writer.begin("CellData");
  writer.add<double>("scaled_jacobian", number_of_cells, [&](std::size_t i) { return quality[i]; });
  writer.end("CellData");

  writer.write(os);
}

} // namespace IO
} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTU_H
