// Targets of the boundary of a mesh in a file: a text, a table, a mesh, or a surface.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGETS_OF_FILE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGETS_OF_FILE_H

#include "Progress_line.h"
#include "read_source.h"

#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

// Reads the target of each point of the mesh; not numbers for points without one. `notes` say how the file is understood, if
// there are several ways.
inline Points targets_of_file(const std::string& filename, const VMP::Tetrahedron_soup_3& mesh,
                              Progress_line& progress, std::vector<std::string>& notes)
{
  const auto np = CGAL::parameters::visitor(std::ref(progress)).output_iterator(std::back_inserter(notes));
  const Mesh_format format = format_of(filename);
  const bool is_surface = format == Mesh_format::SURFACE, is_mesh = format == Mesh_format::GMSH || format == Mesh_format::VTK;
  Points result;
  const bool is_complete = !is_surface && !is_mesh ? VMP::IO::read_boundary_targets(filename, mesh, result, np)
    : naming(filename, [&, target = is_mesh ? read_mesh(filename, progress) : read_surface(filename, progress)]
             { return VMP::IO::boundary_targets_of_mesh(target, mesh, result, np); });
  if(!is_complete)
    throw Interruption();
  return result;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_TARGETS_OF_FILE_H
