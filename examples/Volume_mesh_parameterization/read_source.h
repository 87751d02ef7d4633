#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H

#include "Progress_line.h"

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

using Points = std::vector<std::array<double, 3> >;

// The mesh of a file, in its order, with positive cells.
inline CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 read_source(const std::string& filename,
                                                                          Progress_line& progress)
{
  namespace VMP = CGAL::Volume_mesh_parameterization;
  VMP::Tetrahedron_soup_3 soup;
  try
  {
    if(VMP::IO::read_tetrahedron_soup(filename, soup, CGAL::parameters::visitor(std::ref(progress)))
       == VMP::ERROR_INTERRUPTED)
      throw Interruption();
  }
  catch(const VMP::Input_error& error)
  {
    const std::filesystem::path path(filename), extension = path.extension();
    if(extension == ".mesh" || extension == ".meshb" || extension == ".vtu" || !std::filesystem::is_regular_file(path))
      throw;
    throw VMP::Input_error(error.what() + std::string("; other formats can be converted: meshio convert ") + filename + " "
                           + std::filesystem::path(path).replace_extension(".mesh").string());
  }
  try
  {
    VMP::orient_tetrahedron_soup(soup);
  }
  catch(const VMP::Input_error& error)
  {
    throw VMP::Input_error(filename + ": " + error.what());
  }
  return soup;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H
