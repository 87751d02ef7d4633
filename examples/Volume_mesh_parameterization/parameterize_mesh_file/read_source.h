#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H

#include "Named_choices.h"
#include "Progress_line.h"

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using Points = std::vector<std::array<double, 3> >;

// The mesh of a file, in its order, with positive cells.
struct Source
{
  CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 soup;
  bool is_turned; // are the cells negative in the file, and in what is written?

  CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 as_in_file() const
  {
    auto result = soup;
    for(std::array<std::size_t, 4>& cell : result.cells)
      if(is_turned)
        std::swap(cell[2], cell[3]);
    return result;
  }
};

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

inline Source read_source(const std::string& filename, Progress_line& progress)
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
  const bool is_turned = naming(filename, [&] { return VMP::orient_tetrahedron_soup<Concurrency_tag>(soup); });
  return { std::move(soup), is_turned };
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H
