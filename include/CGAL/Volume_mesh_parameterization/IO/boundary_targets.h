// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_BOUNDARY_TARGETS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_BOUNDARY_TARGETS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Files/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/Files/read_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <istream>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Volume_mesh_parameterization {

namespace internal {

// the cells as a set of vertex sets
inline std::vector<std::array<std::size_t, 4> > sorted_cells(std::vector<std::array<std::size_t, 4> > cells)
{
  for(std::array<std::size_t, 4>& cell : cells)
    std::sort(cell.begin(), cell.end());
  std::sort(cells.begin(), cells.end());
  return cells;
}

inline void check_same_connectivity(const Tetrahedron_soup_3& source, const Tetrahedron_soup_3& target)
{
  if(target.points.size() != source.points.size())
    throw Input_error("the target has " + std::to_string(target.points.size()) + " vertices and the source has "
                      + std::to_string(source.points.size()));
  if(target.cells.size() != source.cells.size())
    throw Input_error("the target has " + std::to_string(target.cells.size()) + " cells and the source has "
                      + std::to_string(source.cells.size()));
  if(target.cells != source.cells && sorted_cells(target.cells) != sorted_cells(source.cells))
    throw Input_error("the cells of the target join other vertices than those of the source");
}

} // namespace internal

namespace IO {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads lines `vertex_index x y z`. Indices start at 0, and no vertex may have two lines.
///
/// \param is the stream
/// \param number_of_vertices the number of vertices of the mesh
/// \param targets gets `number_of_vertices` points; a vertex without a line gets not-a-number coordinates
///
/// \exception Input_error names the line that is wrong; `targets` is then unchanged.
inline void read_boundary_targets(std::istream& is,
                                  std::size_t number_of_vertices,
                                  std::vector<std::array<double, 3> >& targets)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::array<double, 3> > points(number_of_vertices, {none, none, none});

  const std::string text = internal::read_text(is);
  internal::Text_scanner scanner(text);
  while(scanner.has_word())
  {
    const long long v = scanner.next_number<long long>("the index of a vertex");
    if(v < 0 || static_cast<unsigned long long>(v) >= number_of_vertices)
      scanner.fail("vertex " + std::to_string(v) + " does not exist, the mesh has "
                   + std::to_string(number_of_vertices) + " vertices, counted from 0");

    std::array<double, 3>& point = points[static_cast<std::size_t>(v)];
    if(!std::isnan(point[0]))
      scanner.fail("vertex " + std::to_string(v) + " has a second line");

    for(double& x : point)
    {
      if(!scanner.has_word_on_line())
        scanner.fail("the line has less than the three coordinates of vertex " + std::to_string(v));
      x = scanner.next_number<double>("a finite coordinate");
    }
    if(scanner.has_word_on_line())
      scanner.fail("the line does not end after the three coordinates of vertex " + std::to_string(v));
  }

  targets.swap(points);
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads target points from a file: from a file `*.mesh` the points of a mesh with the vertices and cells of `source`
/// (cells in any order), from any other file lines `vertex_index x y z`.
///
/// \param filename the name of the file
/// \param source the mesh whose boundary is to be mapped
/// \param targets gets a point for each vertex of `source`; a vertex without a line gets not-a-number coordinates
///
/// \exception Input_error names the file and what is wrong; `targets` is then unchanged.
inline void read_boundary_targets(const std::string& filename,
                                  const Tetrahedron_soup_3& source,
                                  std::vector<std::array<double, 3> >& targets)
{
  const std::string_view extension = ".mesh";
  const bool is_mesh = filename.size() > extension.size()
    && filename.compare(filename.size() - extension.size(), extension.size(), extension) == 0;

  internal::read_file(filename, [&](std::istream& is)
  {
    if(!is_mesh)
      return IO::read_boundary_targets(is, source.points.size(), targets);

    Tetrahedron_soup_3 target;
    IO::read_MEDIT(is, target);
    internal::check_same_connectivity(source, target);
    targets.swap(target.points);
  });
}

} // namespace IO
} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_BOUNDARY_TARGETS_H
