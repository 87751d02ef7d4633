#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H

#include "Progress_line.h"
#include "mend_source.h"

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

// Calls f, and puts the name of the file before the sentence of an error.
template <typename Function>
auto naming(const std::string& filename, const Function& f)
{
  try
  {
    return f();
  }
  catch(const CGAL::Volume_mesh_parameterization::Input_error& error)
  {
    throw CGAL::Volume_mesh_parameterization::Input_error(filename + ": " + error.what());
  }
}

inline Source read_source(const Options& options, Progress_line& progress)
{
  const std::string& filename = options.source;
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
  return naming(filename, [&] { return mended_source(std::move(soup), options); });
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H
