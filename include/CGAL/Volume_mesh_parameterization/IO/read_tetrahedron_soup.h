// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_READ_TETRAHEDRON_SOUP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_READ_TETRAHEDRON_SOUP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/read_VTU.h>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

inline Tetrahedron_soup_3 read_soup(const std::string& text, const Budget& budget)
{ return VTK_arrays::is_VTU(text) ? read_VTU(text, budget) : read_MEDIT_text(text, budget); }

} // namespace internal

namespace IO {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads a tetrahedral mesh from a file of MEDIT, as `read_MEDIT()` does, or a VTK XML file (`.vtu`). The content decides about
/// the format. A VTK file has the type `UnstructuredGrid` in one piece. Its arrays are text or binary (`raw` or base64, in their
/// place or appended). They may be compressed by zlib, lzma or lz4, if these libraries were found.
///
/// In a VTK file, triangles become marked facets, and lines become marked edges. Hexahedra, prisms and pyramids are split into
/// tetrahedra, with diagonals at the least vertices of facets, and quadrilaterals are their facets. Other cells of lower dimension
/// are skipped. Of cells of a higher order the corners are read. References are the first
/// of the cell data below that are integers. Capitals and signs between letters do not matter. If there are none, references are
/// the sets that meshio has joined to one array, numbered from 1 on and with their names. Otherwise, they are 0. Arrays of the
/// section `FieldData` with two integers, a reference and a dimension from 1 to 3, are names of groups.
///
/// - `reference`, `medit:ref`, `gmsh:physical`,
/// - `material`, `attribute`, `mat_id`, `material_id`, `MaterialIDs`,
/// - `su2:tag`, `tetgen:ref`, `nastran:ref`, `netgen:index`, `avsucd:material`, `ugrid:ref`,
/// - `cell_tags`, `ModelRegionID`, `RegionId`, `CellEntityIds`, `elemTag`, `elset`, `block_id`,
/// - `region`, `regions`, `subdomain`, `subdomains`, `label`, `labels`, `grain_id`, `part_id`, `gmsh:geometrical`.
///
/// \param filename the name of the file, which may be a pipe
/// \param soup gets the mesh
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `read_MEDIT()`
///
/// \return `false` if the time is over or the visitor ends the reading; `soup` is then unchanged.
///
/// \exception Input_error names the file and what is wrong; \c soup is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_tetrahedron_soup(const std::string& filename, Tetrahedron_soup_3& soup,
                           const NamedParameters& np = parameters::default_values())
{
  return internal::read_within_limits(np, filename, [&](const internal::Budget& budget)
  { soup = internal::read_soup(internal::read_file(filename, budget), budget); });
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// marks the edges of a list in place of those that a mesh has, as the sharp ones. A line has two vertices, counted from 0; the
/// first line may be the number of edges. The rest of a line behind `#` is skipped.
///
/// \param filename the name of the file
/// \param soup the mesh, whose marked edges get the reference 1
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `read_MEDIT()`
///
/// \return `false` if the time is over or the visitor ends the reading; `soup` is then unchanged.
///
/// \exception Input_error names the file and the line that is wrong; \c soup is then unchanged.
template <typename NamedParameters = parameters::Default_named_parameters>
bool read_features(const std::string& filename, Tetrahedron_soup_3& soup,
                   const NamedParameters& np = parameters::default_values())
{
  return internal::read_within_limits(np, filename, [&](const internal::Budget& budget)
  {
    const std::string text = internal::read_file(filename, budget);
    internal::Text_scanner scanner(text, budget);
    std::vector<std::array<std::size_t, 2> > edges;
    for(bool is_first = true; !scanner.rest().empty(); is_first = false)
    {
      internal::Text_scanner line = scanner.next_line();
      if(line.rest().find(',') != std::string_view::npos)
        line.fail("a line must contain two vertices of the mesh. Sides of triangles, as in files .sharp of LoopyCuts, are not "
                  "supported");
      const std::size_t v = line.next_number<std::size_t>("the index of a vertex");
      if(is_first && line.rest().empty())
        continue;
      const std::size_t w = line.next_number<std::size_t>("the index of a vertex");
      line.expect_end("the two vertices of an edge");
      if(v >= soup.points.size() || w >= soup.points.size() || v == w)
        line.fail("there is no edge between the vertices " + std::to_string(v) + " and " + std::to_string(w)
                  + " (counted from 0)");
      edges.push_back({ v, w });
    }
    soup.edges = std::move(edges);
    soup.edge_references.assign(soup.edges.size(), 1);
    soup.edge_data.clear();
  });
}

} // namespace IO
} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_READ_TETRAHEDRON_SOUP_H
