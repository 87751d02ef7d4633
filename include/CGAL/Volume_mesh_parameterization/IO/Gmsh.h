// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_GMSH_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_GMSH_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/IO/Gmsh_mesher.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Gmsh_writer.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/Text_scanner.h>

#include <filesystem>
#include <fstream>

namespace CGAL::Volume_mesh_parameterization {
namespace internal {

// Gmsh itself reports no reason.
inline void require_readable(const std::string& filename)
{
  if(!std::filesystem::exists(filename) || !std::ifstream(filename))
    throw Input_error(sentence_on_unopened_file());
  if(!std::filesystem::is_regular_file(filename))
    throw Input_error("Gmsh reads regular files only");
}

} // namespace internal

namespace IO {

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// reads a tetrahedral mesh from a file of Gmsh (`.msh`), I-deas (`.unv`) or Nastran (`.bdf`), by Gmsh. The header `gmsh.h` and
/// the library are needed. References are physical groups, with their names, or entities if there are no groups in a dimension.
/// A simplex in several groups comes once for each: `merge_coinciding_cells()` joins cells. The first steps of views are data.
///
/// \param filename the name of the file, which must be a regular one
/// \param soup gets the mesh
///
/// \exception Input_error names the fault, if possible in the words of Gmsh; \c soup is then unchanged. On a damaged file,
///            Gmsh may crash or never finish.
inline void read_by_Gmsh(const std::string& filename, Tetrahedron_soup_3& soup)
{
  internal::require_readable(filename);
  // Gmsh takes other files with such a name for scripts, and runs them
  const bool is_MSH = std::filesystem::path(filename).extension().string().find(".msh") == 0;
  if(is_MSH && std::ifstream(filename).peek() != '$')
    throw Input_error("this is not a mesh of Gmsh");
  internal::with_Gmsh([&]
  {
    gmsh::merge(filename);
    soup = internal::Gmsh_reader().read(is_MSH ? internal::names_of_groups(filename) : internal::Names_of_groups());
  });
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// fills the body of a file with tetrahedra, by Gmsh. The file has solids of a CAD program (`.step`, `.stp`, `.iges`, `.igs`,
/// `.brep`), is a script of Gmsh that makes solids (`.geo`), or has a closed surface (`.stl`, `.off`, `.obj`, `.ply`, `.vtp`).
///
/// A surface is repaired as by `read_closed_surface()`, but may touch itself, and enclose several bodies. It gets new triangles by
/// `CGAL::Polygon_mesh_processing::isotropic_remeshing()`, which keep edges with 40 degrees or more between normals. If Gmsh
/// cannot fill these triangles, those of the file stay. Lengths keep the unit of a STEP file if it is metre, centimetre,
/// millimetre or inch. If faces of cylinders or spheres have a smaller diameter than the cells, circles get eight edges.
///
/// Solids that touch share faces of the mesh. References are the numbers of solids, faces and curves in Gmsh, with the names of
/// solids, or physical groups of a script. Curves between faces are marked edges. A surface has no references and no marked edges.
///
/// \param filename the name of the file, which must be a regular one
/// \param soup gets the mesh
/// \param cell_size the largest length of edges, about, up to a tenth of the diagonal of the bounding box; with 0,
///        `Mesh.MeshSizeMax` of the script, or else a twentieth of the diagonal
/// \param joining_distance the distance up to which points at gaps of a surface are joined if that closes it; 0 stands for a tiny
///        part of the surface
/// \param number_of_failures how many attempts have failed before: after one, another algorithm is tried, and after two, solids
///        get cells of twice the size; triangles of a surface stay then
/// \param do_fill_voids whether voids inside of solids, or of what a surface encloses, are filled; a script decides that itself
///
/// \pre `cell_size` and `joining_distance` are not negative; otherwise `CGAL::Precondition_exception` is thrown, in every build.
///
/// \exception Input_error names the fault, if possible in the words of Gmsh, and a remedy; \c soup is then unchanged. Gmsh may
///            crash or never finish. A script of Gmsh may run other programs.
inline void mesh_by_Gmsh(const std::string& filename, Tetrahedron_soup_3& soup, const double cell_size = 0,
                         const double joining_distance = 0, const int number_of_failures = 0, const bool do_fill_voids = false)
{
  internal::require(cell_size >= 0 && joining_distance >= 0, "cell_size and joining_distance must not be negative.");
  internal::require_readable(filename);
  if(internal::is_surface_name(filename))
    soup = internal::filled_surface(internal::read_closed_surface(filename, joining_distance, internal::Budget(), true),
                                    { cell_size, number_of_failures, do_fill_voids });
  else if(internal::has_extension(filename, { ".step", ".stp", ".iges", ".igs", ".brep", ".geo" }))
    soup = internal::filled_solids(filename, { cell_size, number_of_failures, do_fill_voids });
  else
    throw Input_error("the extension is not one of a body that Gmsh fills");
}

/// \ingroup PkgVolumeMeshParameterizationIO
///
/// writes a tetrahedral mesh in the format of Gmsh, by Gmsh. References are physical groups, with their names. Data of points and
/// of cells become views.
///
/// \param os the stream
/// \param mesh the mesh
/// \param version 4.1 for a binary file, or 2.2 for text of 16 digits
///
/// \exception Input_error has the sentence of Gmsh if it fails.
inline void write_MSH(std::ostream& os, const Tetrahedron_soup_3& mesh, const double version = 4.1)
{
  internal::check_simplices(mesh);
  internal::with_Gmsh([&]
  {
    auto soup = mesh;
    const std::vector<std::vector<double> > further_references = internal::take_further_references(soup);
    internal::Gmsh_writer writer(soup.points, soup.group_names);
    std::vector<std::size_t> points(soup.points.size());
    std::iota(points.begin(), points.end(), std::size_t(1));
    const auto cells = writer.add(3, 4, soup.cells, soup.cell_references, further_references);
    const auto facets = writer.add(2, 2, soup.facets, soup.facet_references);
    const auto edges = writer.add(1, 1, soup.edges, soup.edge_references);
    writer.add_data("NodeData", soup.point_data, points);
    std::vector<std::size_t> elements = cells;
    elements.insert(elements.end(), facets.begin(), facets.end());
    elements.insert(elements.end(), edges.begin(), edges.end());
    writer.add_data("ElementData", internal::joined_cell_data(soup), elements);
    writer.write(os, version);
  });
}

} // namespace IO
} // namespace CGAL::Volume_mesh_parameterization

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_GMSH_H
