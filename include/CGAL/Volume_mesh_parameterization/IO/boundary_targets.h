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
#include <CGAL/Volume_mesh_parameterization/internal/IO/read_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/read_targets.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/targets_of_surface.h>

#include <CGAL/iterator.h>

#include <filesystem>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

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

// The points of a mesh with the vertices and cells of the source, or of a surface.
inline Read_targets targets_of_mesh(Tetrahedron_soup_3 target, const Tetrahedron_soup_3& source, const Budget& budget)
{
  if(target.cells.empty())
    return targets_of_surface(target.points, target.facets, source, budget);
  check_same_connectivity({ target.points.size(), target.cells.size() }, { source.points.size(), source.cells.size() }, [&]
  { return target.cells == source.cells || sorted_cells(target.cells) == sorted_cells(source.cells); });
  return { std::move(target.points) };
}

inline Read_targets targets_of_file(const std::string& filename, const Tetrahedron_soup_3& source, const Budget& budget)
{
  const std::string extension = std::filesystem::path(filename).extension().string();
  if(is_surface_name(filename))
    return targets_of_mesh(read_surface(filename, budget), source, budget);
  const std::string text = read_file(filename, budget);
  if(extension == ".csv")
    return { targets_of_CSV(text, source.points.size(), budget) };
  if(!is_MEDIT_file(filename) && !is_mesh(text))
    return { points_of_vertices(read_targets(Text_scanner(text, budget), source.points.size()), 0, source.points.size()) };
  const bool may_be_surface = is_MEDIT_file(filename) && !Binary_MEDIT_reader::is_binary(text) && !VTK_arrays::is_VTU(text);
  return targets_of_mesh(may_be_surface ? MEDIT_reader(Text_scanner(text, budget)).read(MEDIT_reader::Content::MESH_OR_SURFACE)
                                        : read_soup(text, budget), source, budget);
}

// Sets targets to those of `read(budget)`, and passes the note on them on.
template <typename NamedParameters, typename Read>
bool set_targets(Points& targets, const NamedParameters& np, const std::string& filename, const Read& read)
{
  return read_within_limits<internal_np::output_iterator_t>(np, filename, [&](const Budget& budget)
  {
    Read_targets result = read(budget);
    if(std::all_of(result.points.begin(), result.points.end(), [](const auto& p) { return std::isnan(p[0]); }))
      throw Input_error("there is no target of a vertex");
    targets = std::move(result.points);
    auto out = parameter_or(np, internal_np::output_iterator, Emptyset_iterator());
    if(!result.note.empty())
      *out++ = result.note;
  });
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
/// finds target points for the boundary of a mesh. They are the points of another mesh with its vertices and cells, in any order
/// of the cells. Or they are the points of a surface, a soup without cells.
///
/// The facets of a surface are the boundary of `source`, or a part of it. If its vertices are those of `source`, or those of the
/// boundary in the order of `source`, these are the vertices. Otherwise the facets identify them: of several ways, the one with
/// the least displacement is taken. Then a walk over the facets begins at each edge of the boundary, and most walks end after a
/// few facets.
///
/// \param target the mesh, or the surface
/// \param source the mesh whose boundary is to be mapped
/// \param targets gets a point for each vertex of `source`; a vertex without one gets not-a-number coordinates
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of `read_MEDIT()`, and
///        `output_iterator`. If there are several ways, this output iterator for `std::string` gets a note
///
/// \return `false` if the time is over or the visitor ends the search; `targets` is then unchanged.
///
/// \exception Input_error names the reason if \c target does not fit; \c targets is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool boundary_targets_of_mesh(const Tetrahedron_soup_3& target, const Tetrahedron_soup_3& source,
                              std::vector<std::array<double, 3> >& targets,
                              const NamedParameters& np = parameters::default_values())
{
  internal::check_simplices(target);
  internal::check_simplices(source);
  return internal::set_targets(targets, np, "", [&](const internal::Budget& budget)
  { return internal::targets_of_mesh(target, source, budget); });
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads target points from a file. The extension decides about the format:
/// - `.csv`: a table, for instance of ParaView, with the columns `Points:0` to `Points:2`, or `x`, `y` and `z`, and perhaps
///   `Point ID`. Without a line of names, the columns are the index and the coordinates, or the coordinates alone;
/// - `.off`, `.stl`, `.ply`, `.obj`, `.vtp`: a surface, for `boundary_targets_of_mesh()`;
/// - any other: a mesh, as `read_tetrahedron_soup()` reads it, or a MEDIT file of a surface, for `boundary_targets_of_mesh()`; or
///   lines `vertex_index x y z`.
///
/// \param filename the name of the file
/// \param source the mesh whose boundary is to be mapped
/// \param targets gets a point for each vertex of `source`; a vertex without a line gets not-a-number coordinates
/// \param np the named parameters of `boundary_targets_of_mesh()`
///
/// \return `false` if the time is over or the visitor ends the reading; `targets` is then unchanged.
///
/// \exception Input_error names the file and what is wrong; \c targets is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_boundary_targets(const std::string& filename, const Tetrahedron_soup_3& source,
                           std::vector<std::array<double, 3> >& targets,
                           const NamedParameters& np = parameters::default_values())
{
  return internal::set_targets(targets, np, filename, [&](const internal::Budget& budget)
  { return internal::targets_of_file(filename, source, budget); });
}

} // namespace IO
} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_BOUNDARY_TARGETS_H
