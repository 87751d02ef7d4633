// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/VTU_writer.h>

namespace CGAL::Volume_mesh_parameterization::IO {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// writes a map on a regular grid as a structured grid of VTK (`.vts`), for instance for ParaView. The points are those of
/// the grid; they have the vectors `preimage`, and the values `det_J` and `is_inside`, 1 or 0. Outside, `preimage` and `det_J`
/// are not numbers, and the points are hidden (`vtkGhostType`). The values are binary, 65 bytes a point.
///
/// \param os the stream, opened in binary mode (`std::ios::binary`) if it is a file
/// \param grid the grid, as `evaluate_on_grid()` returns it
///
/// \return whether the stream has taken everything
///
/// \pre The arrays have as many elements as the grid has points; otherwise `CGAL::Precondition_exception` is thrown, in
///      every build.
inline bool write_VTS(std::ostream& os, const Map_on_grid_3& grid)
{
  const std::size_t n = grid.points.size();
  internal::require(n == grid.numbers[0] * grid.numbers[1] * grid.numbers[2] && grid.preimages.size() == n
                    && grid.det_J.size() == n, "The arrays of grid must have an element for each point.");
  std::string extent;
  for(const std::size_t number : grid.numbers)
    extent += (extent.empty() ? "0 " : " 0 ") + std::to_string(number - 1);
  internal::VTK_writer writer("StructuredGrid", " WholeExtent=\"" + extent + "\"", " Extent=\"" + extent + "\"");
  const auto is_inside = [&](const std::size_t i) { return !std::isnan(grid.det_J[i]); };
  writer.add_section_of_points(grid.points);
  writer.begin("PointData");
  writer.add_points("preimage", grid.preimages);
  writer.add<double>("det_J", n, [&](const std::size_t i) { return grid.det_J[i]; });
  writer.add<std::uint8_t>("is_inside", n, is_inside);
  writer.add<std::uint8_t>("vtkGhostType", n, [&](const std::size_t i) { return is_inside(i) ? 0 : 2; }); // HIDDENPOINT
  writer.end("PointData");
  writer.write(os);
  return os.good();
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// writes a map on a regular grid to a file, as to a stream. The file is replaced when it is complete.
///
/// \param filename the name of the file
/// \param grid the grid
///
/// \return whether the file is complete
inline bool write_VTS(const std::string& filename, const Map_on_grid_3& grid)
{ return internal::write_file(filename, [&](std::ostream& os) { IO::write_VTS(os, grid); }); }

} // namespace CGAL::Volume_mesh_parameterization::IO

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTS_H
