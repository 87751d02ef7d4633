// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_BOUNDARY_TARGETS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_BOUNDARY_TARGETS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>

#include <filesystem>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

struct Target_of_vertex
{
  std::size_t vertex, line;
  std::array<double, 3> point;
};

// Reads lines `vertex_index x y z`.
inline std::vector<Target_of_vertex> read_targets(Text_scanner scanner, const std::size_t number_of_vertices)
{
  std::vector<Target_of_vertex> targets;
  while(!scanner.rest().empty())
  {
    Text_scanner line = scanner.next_line();
    const long long v = line.next_number<long long>("the index of a vertex");
    if(v < 0 || static_cast<unsigned long long>(v) >= number_of_vertices)
      line.fail("vertex " + std::to_string(v) + " does not exist, the mesh has " + std::to_string(number_of_vertices)
                + " vertices, counted from 0");
    targets.push_back({ static_cast<std::size_t>(v), line.line(), next_point(line) });
    line.expect_end("the three coordinates of vertex " + std::to_string(v));
  }
  return targets;
}

// The points of `number` vertices from the first one on; those without a target have coordinates that are not numbers.
inline std::vector<std::array<double, 3> > points_of_vertices(const std::vector<Target_of_vertex>& targets,
                                                              const std::size_t first, const std::size_t number)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::array<double, 3> > points(number, {none, none, none});
  for(const Target_of_vertex& target : targets)
  {
    std::array<double, 3>& point = points[target.vertex - first];
    if(!std::isnan(point[0]))
      Text_scanner::fail(target.line, "vertex " + std::to_string(target.vertex) + " has a second line");
    point = target.point;
  }
  return points;
}

inline bool is_MEDIT_file(const std::string& filename) { return std::filesystem::path(filename).extension() == ".mesh"; }

// Is it one of the formats of meshes? Lines of targets begin with a number in text.
inline bool is_mesh(const std::string_view text)
{ return Binary_MEDIT_reader::is_binary(text) || VTK_arrays::is_VTU(text) || text.find("MeshVersionFormatted") < 100; }

// the cells as a set of vertex sets
inline std::vector<std::array<std::size_t, 4> > sorted_cells(std::vector<std::array<std::size_t, 4> > cells)
{
  for(std::array<std::size_t, 4>& cell : cells)
    std::sort(cell.begin(), cell.end());
  std::sort(cells.begin(), cells.end());
  return cells;
}

// Compares the numbers of the target with those of the source, and then the cells.
template <typename HasSameCells>
void check_same_connectivity(const std::array<std::size_t, 2>& target, const std::array<std::size_t, 2>& source,
                             const HasSameCells& has_same_cells)
{
  const char* const kinds[] = { "vertices", "cells" };
  for(std::size_t i = 0; i < 2; ++i)
    if(target[i] != source[i])
      throw Input_error("the target has " + std::to_string(target[i]) + " " + kinds[i] + " and the source has "
                        + std::to_string(source[i]));
  if(!has_same_cells())
    throw Input_error("the cells of the target join other vertices than those of the source");
}

// The points of a mesh with the vertices and cells of the source.
inline std::vector<std::array<double, 3> > targets_of_mesh(Tetrahedron_soup_3 target, const Tetrahedron_soup_3& source)
{
  check_same_connectivity({ target.points.size(), target.cells.size() }, { source.points.size(), source.cells.size() }, [&]
  { return target.cells == source.cells || sorted_cells(target.cells) == sorted_cells(source.cells); });
  return std::move(target.points);
}

} // namespace internal

namespace IO {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads lines `vertex_index x y z`. Indices start at 0, and no vertex may have two lines. The rest of a line behind `#` is
/// skipped, and a byte order mark of UTF-8.
///
/// \param is the stream
/// \param number_of_vertices the number of vertices of the mesh
/// \param targets gets `number_of_vertices` points; a vertex without a line gets not-a-number coordinates
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `read_MEDIT()`
///
/// \return `false` if the time is over or the visitor ends the reading; `targets` is then unchanged.
///
/// \exception Input_error names the line that is wrong; \c targets is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_boundary_targets(std::istream& is, std::size_t number_of_vertices,
                           std::vector<std::array<double, 3> >& targets,
                           const NamedParameters& np = parameters::default_values())
{
  return internal::read_within_limits(np, "", [&](const internal::Budget& budget)
  {
    const std::string text = internal::read_text(is, budget);
    const auto lines = internal::read_targets(internal::Text_scanner(text, budget), number_of_vertices);
    targets = internal::points_of_vertices(lines, 0, number_of_vertices);
  });
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads target points from a file: from a mesh, as `read_tetrahedron_soup()` reads it, with the vertices and cells of
/// `source` (cells in any order) its points, from any other file lines `vertex_index x y z`.
///
/// \param filename the name of the file
/// \param source the mesh whose boundary is to be mapped
/// \param targets gets a point for each vertex of `source`; a vertex without a line gets not-a-number coordinates
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `read_MEDIT()`
///
/// \return `false` if the time is over or the visitor ends the reading; `targets` is then unchanged.
///
/// \exception Input_error names the file and what is wrong; \c targets is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_boundary_targets(const std::string& filename, const Tetrahedron_soup_3& source,
                           std::vector<std::array<double, 3> >& targets,
                           const NamedParameters& np = parameters::default_values())
{
  return internal::read_within_limits(np, filename, [&](const internal::Budget& budget)
  {
    const std::string text = internal::read_file(filename, budget);
    if(!internal::is_MEDIT_file(filename) && !internal::is_mesh(text))
    {
      const auto lines = internal::read_targets(internal::Text_scanner(text, budget), source.points.size());
      targets = internal::points_of_vertices(lines, 0, source.points.size());
      return;
    }
    targets = internal::targets_of_mesh(internal::read_soup(text, budget), source);
  });
}

} // namespace IO
} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_BOUNDARY_TARGETS_H
