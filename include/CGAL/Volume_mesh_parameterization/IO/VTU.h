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

#include <CGAL/Volume_mesh_parameterization/internal/IO/add_VTU_data.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/read_VTU.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/cell_quality_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/ranges.h>
#include <CGAL/Volume_mesh_parameterization/internal/Soups/check_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/mesh_complex_3_to_tetrahedron_soup.h>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

inline double volume(const std::vector<std::array<std::size_t, 4> >& cells, const std::vector<std::array<double, 3> >& points)
{
  double sum = 0;
  for(const std::array<std::size_t, 4>& cell : cells)
  {
    const Eigen::Vector3d p = to_vector(points[cell[0]]);
    const auto edge = [&](const int i) -> Eigen::Vector3d { return to_vector(points[cell[i]]) - p; };
    sum += edge(1).cross(edge(2)).dot(edge(3)) / 6;
  }
  return sum;
}

// The volume of the image of the whole mesh is `volume_ratio` times that of the mesh.
inline void write_VTU(std::ostream& os, const Tetrahedron_soup_3& soup, const std::vector<std::array<double, 3> >& uvw,
                      const double volume_ratio)
{
  const std::vector<Cell_distortion_3> distortions = distortions_of_cells_3(soup.points, soup.cells, uvw);
  const std::vector<std::size_t> cells = cells_of_VTU(soup);
  const auto of_cell = [&](const auto& value)
  {
    return [&](const std::size_t i)
    { return cells[i] < soup.cells.size() ? value(distortions[cells[i]]) : std::numeric_limits<double>::quiet_NaN(); };
  };
  const auto angle = [](const Cell_distortion_3& d) { return d.angle; };
  const auto det_J = [](const Cell_distortion_3& d) { return d.det_J; };
  const auto volume = [&](const Cell_distortion_3& d) { return d.det_J / volume_ratio + 1 / (d.det_J / volume_ratio); };
  std::vector<int> references = soup.cell_references;
  references.insert(references.end(), soup.facet_references.begin(), soup.facet_references.end());
  references.insert(references.end(), soup.edge_references.begin(), soup.edge_references.end());

  VTU_writer writer(soup.points, VTU_cells<4>{ soup.cells, 10 }, VTU_cells<3>{ soup.facets, 5 }, VTU_cells<2>{ soup.edges, 3 });
  writer.add_names(soup.group_names);
  writer.begin("PointData");
  writer.add_points("uvw", uvw);
  add_VTU_data(writer, soup.point_data, { "uvw" });
  writer.end("PointData");
  writer.begin("CellData");
  writer.add<std::int32_t>("reference", cells.size(), [&](const std::size_t i) { return references[i]; });
  writer.add<double>("angle_distortion", cells.size(), of_cell(angle));
  writer.add<double>("volume_distortion", cells.size(), of_cell(volume));
  writer.add<double>("det_J", cells.size(), of_cell(det_J));
  add_VTU_data(writer, joined_cell_data(soup), { "reference", "angle_distortion", "volume_distortion", "det_J" });
  writer.end("CellData");
  writer.write(os);
}

} // namespace internal

namespace IO {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads a tetrahedral mesh from a VTK XML file (`.vtu`), as `read_tetrahedron_soup()` does. Images that `write_VTU()` has
/// written are the array `uvw` of `Tetrahedron_soup_3::point_data`.
///
/// \param is the stream, opened in binary mode (`std::ios::binary`) if it is a file
/// \param soup gets the mesh
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `read_MEDIT()`
///
/// \return `false` if the time is over or the visitor ends the reading; `soup` is then unchanged.
///
/// \exception Input_error names the fault; \c soup is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_VTU(std::istream& is, Tetrahedron_soup_3& soup, const NamedParameters& np = parameters::default_values())
{
  return internal::read_within_limits(np, "", [&](const internal::Budget& budget)
  { soup = internal::read_VTU(internal::read_text(is, budget), budget); });
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads a tetrahedral mesh from a file, likewise.
///
/// \param filename the name of the file, which may be a pipe
/// \param soup gets the mesh
/// \param np the same named parameters
///
/// \return the same
///
/// \exception Input_error names the file and what is wrong; \c soup is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_VTU(const std::string& filename, Tetrahedron_soup_3& soup, const NamedParameters& np = parameters::default_values())
{
  return internal::read_within_limits(np, filename, [&](const internal::Budget& budget)
  { soup = internal::read_VTU(internal::read_file(filename, budget), budget); });
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// writes a tetrahedral mesh with its parameterization as a VTK XML file (`.vtu`), for instance for ParaView.
///
/// The points are those of the mesh and have the vectors `uvw`, their images. The cells have the values `reference`,
/// `angle_distortion`, `det_J` and `volume_distortion`. `angle_distortion` is the ratio of the largest and the smallest stretch
/// plus its inverse. `det_J` is the volume of the image relative to that of the cell. `volume_distortion` is `det_J` plus its
/// inverse, of the map scaled to the volume of the mesh (`Parameterization_result::distortion_at_source_volume`). Marked facets
/// and edges are triangles and lines behind the cells, with their own references and the other values of a cell at them. The
/// data of the soup with other names are written, too, and the names of groups, as `read_tetrahedron_soup()` reads them. The
/// values are binary, in the appended form of the format (`encoding="raw"`). All bits are kept: 53 bytes a cell, 48 a point.
///
/// \param os the stream, opened in binary mode (`std::ios::binary`) if it is a file
/// \param soup the mesh
/// \param uvw the image of each point, in the order of the points
///
/// \return whether the stream has taken everything
///
/// \exception Input_error if an index does not exist, or a reference is missing.
///
/// \pre `uvw` has as many points as `soup`; otherwise `CGAL::Precondition_exception` is thrown, in every build.
inline bool write_VTU(std::ostream& os, const Tetrahedron_soup_3& soup, const std::vector<std::array<double, 3> >& uvw)
{
  internal::check_simplices(soup);
  internal::require(uvw.size() == soup.points.size(), "uvw must have an element for each point.");
  internal::write_VTU(os, soup, uvw, internal::volume(soup.cells, uvw) / internal::volume(soup.cells, soup.points));
  return os.good();
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// writes a mesh that is given by arrays, as `CGAL::stretch_minimizing_volume_parameterization()` takes them, with its
/// parameterization. The value `reference` of all cells is 0.
///
/// \param os the stream
/// \param points the points
/// \param cells four indices of points for each cell
/// \param images the image of each point
///
/// \return whether the stream has taken everything
///
/// \exception Input_error if an index does not exist.
///
/// \pre There are as many images as points; otherwise `CGAL::Precondition_exception` is thrown, in every build.
template <typename PointRange, typename CellRange, typename ImageRange>
bool write_VTU(std::ostream& os, const PointRange& points, const CellRange& cells, const ImageRange& images)
{ return IO::write_VTU(os, internal::soup_of(points, cells), internal::coordinates_of(images)); }

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
///
/// \return whether the stream has taken everything
template <typename C3t3, typename VertexUVWMap>
bool write_VTU(std::ostream& os, const C3t3& c3t3, VertexUVWMap uvw_map)
{
  Tetrahedron_soup_3 soup;
  std::vector<typename C3t3::Triangulation::Vertex_handle> vertices;
  mesh_complex_3_to_tetrahedron_soup(c3t3, soup, vertices);
  return IO::write_VTU(os, soup, internal::points_of(vertices, uvw_map));
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// writes a mesh to a file, as to a stream. The file is replaced when it is complete.
///
/// \param filename the name of the file
/// \param mesh the arguments behind the stream: a soup and its images, arrays of points, cells and images, or a complex and its
///        map
///
/// \return whether the file is complete
template <typename... Mesh>
bool write_VTU(const std::string& filename, const Mesh&... mesh)
{ return internal::write_file(filename, [&](std::ostream& os) { IO::write_VTU(os, mesh...); }); }

} // namespace IO
} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTU_H
