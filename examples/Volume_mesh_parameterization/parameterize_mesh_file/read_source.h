#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H

#include "Mesh_format.h"
#include "Progress_line.h"
#include "mend_source.h"
#include "read_in_own_process.h"
#include "regions_of_source.h"
#include "sentence_on_content.h"

#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/IO/surfaces.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

// Calls f, and puts the name of the file before the sentence of an error.
template <typename Function>
auto naming(const std::string& filename, const Function& f)
{
  try
  {
    return f();
  }
  catch(const VMP::Input_error& error)
  {
    const std::string name = filename + ": ", sentence = error.what();
    throw VMP::Input_error(sentence.find(name) == 0 ? sentence : name + sentence);
  }
}

// The third field of a line: between commas, or of 8 columns, or of 16 behind a name that ends with a star.
inline std::string third_Nastran_field(const std::string& line)
{
  if(const std::size_t comma = line.find(','); comma != line.npos)
  {
    const std::size_t begin = line.find(',', comma + 1);
    return begin == line.npos ? "" : line.substr(begin + 1, line.find(',', begin + 1) - begin - 1);
  }
  const std::size_t width = line.find('*') < 8 ? 16 : 8, begin = 8 + width;
  return line.size() < begin ? "" : line.substr(begin, width);
}

// Checks a Nastran file, as Gmsh ignores the coordinate systems of points. Throws if a point, or by GRDSET all of them, are in
// another coordinate system than the basic one.
inline void check_coordinate_systems(const std::string& filename)
{
  std::ifstream is(filename);
  std::string line;
  for(std::size_t number = 1; std::getline(is, line); ++number)
    if(line.compare(0, 4, "GRID") == 0 || line.compare(0, 6, "GRDSET") == 0)
    {
      std::string system = third_Nastran_field(line);
      system.erase(0, system.find_first_not_of(" 0"));
      system.erase(system.find_last_not_of(" \r") + 1);
      if(!system.empty())
        throw VMP::Input_error(
          "line " + std::to_string(number) + ": the coordinate system (CP) is '" + system
          + "', but only the basic one (0 or blank) is supported. Write the points in basic coordinates");
    }
}

// Reads a mesh in the format of its name. Throws `Interruption` where the time is over.
inline VMP::Tetrahedron_soup_3 read_mesh_by_name(const std::string& filename, Progress_line& progress)
{
  if(is_Nastran_name(filename))
    naming(filename, [&] { check_coordinate_systems(filename); });
#ifdef PARAMETERIZE_MESH_FILE_USES_GMSH
  if(format_of(filename) == Mesh_format::GMSH)
    return naming(filename, [&]
    { return read_in_own_process(filename, "Gmsh", progress, [&](auto& soup) { gmsh_module().read(filename, soup); }); });
#endif
#ifdef PARAMETERIZE_MESH_FILE_USES_VTK
  if(format_of(filename) == Mesh_format::VTK)
    return naming(filename, [&]
    { return read_in_own_process(filename, "VTK", progress, [&](auto& soup) { read_by_VTK(filename, soup); }); });
#endif
  VMP::Tetrahedron_soup_3 soup;
  try
  {
    if(!VMP::IO::read_tetrahedron_soup(filename, soup, CGAL::parameters::visitor(std::ref(progress))))
      throw Interruption();
  }
  catch(const VMP::Input_error& error)
  {
    throw VMP::Input_error(error.what() + advice_for(filename));
  }
  return soup;
}

// Reads a mesh, likewise. Where that fails, the content may tell more than the name.
inline VMP::Tetrahedron_soup_3 read_mesh(const std::string& filename, Progress_line& progress)
{
  try
  {
    return read_mesh_by_name(filename, progress);
  }
  catch(const VMP::Input_error& error)
  {
    const std::string sentence = sentence_on_content(filename);
    throw VMP::Input_error(sentence.empty() ? error.what() : filename + ": " + sentence);
  }
}

// Reads a surface as it is by CGAL, whose readers take the memory that a damaged file asks for.
inline VMP::Tetrahedron_soup_3 read_surface(const std::string& filename, const Progress_line& progress)
{
  return naming(filename, [&]
  { return read_in_own_process(filename, "CGAL", progress, [&](auto& soup) { VMP::IO::read_surface(filename, soup); }); });
}

// Reads a surface that encloses a body, and repairs it.
inline VMP::Tetrahedron_soup_3 read_closed_surface(const std::string& filename, const double joining_distance,
                                                   const Progress_line& progress)
{
  return naming(filename, [&]
  {
    return read_in_own_process(filename, "CGAL", progress,
                               [&](auto& soup) { VMP::IO::read_closed_surface(filename, soup, joining_distance); });
  });
}

// Fills the body of a CAD file or of a closed surface with tetrahedra. Other attempts follow if Gmsh fails or crashes. Without
// Gmsh, the error has the advice.
inline VMP::Tetrahedron_soup_3 filled_body(const Options& options, Progress_line& progress)
{
#ifdef PARAMETERIZE_MESH_FILE_USES_GMSH
  const auto fill = [&](const int number_of_failures)
  {
    return read_in_own_process(options.source, "Gmsh", progress, [&](auto& soup)
    {
      gmsh_module().fill(options.source, soup, options.cell_size, options.joining_distance, number_of_failures,
                         options.do_fill_voids);
    }, true);
  };
  return naming(options.source, [&]
  {
    const int number_of_attempts = format_of(options.source) == Mesh_format::SOLIDS ? 3 : 2;
    std::exception_ptr failure; // the first one
    for(int i = 0; i < number_of_attempts; ++i)
      try
      {
        VMP::Tetrahedron_soup_3 soup = fill(i);
        if(i > 0)
          soup.notes.push_back(std::string("Gmsh failed in its first attempt. Another one, with ")
                               + (i == 1 ? "another algorithm" : "cells of twice the size") + ", succeeded");
        return soup;
      }
      catch(const Out_of_time&) { throw; }
      catch(const VMP::Input_error&)
      {
        if(!failure)
          failure = std::current_exception();
      }
    std::rethrow_exception(failure);
  });
#else
  return read_mesh(options.source, progress);
#endif
}

// Says which edges would be sharp if the mesh marked none, but are not as it marks others; nothing if there are none.
inline std::string note_of_unmarked_edges(const VMP::Tetrahedron_soup_3& soup)
{
  if(soup.edges.empty())
    return "";
  const auto sharp = VMP::sharp_boundary_edges(soup.points, soup.cells, soup.edges);
  const auto by_angle = VMP::sharp_boundary_edges(soup.points, soup.cells);
  std::vector<std::array<std::size_t, 2> > unmarked;
  std::set_difference(by_angle.begin(), by_angle.end(), sharp.begin(), sharp.end(), std::back_inserter(unmarked));
  return unmarked.empty() ? std::string()
    : counted(unmarked.size(), "sharp edge of the boundary is", "sharp edges of the boundary are")
      + " not marked and not followed, such as the edge between the vertices " + std::to_string(unmarked[0][0]) + " and "
      + std::to_string(unmarked[0][1]) + " (counted from 0). --features FILE marks other edges";
}

inline Source read_source(const Options& options, Progress_line& progress)
{
  auto soup = is_body_name(options.source) ? filled_body(options, progress) : read_mesh(options.source, progress);
  naming(options.source, [&] { VMP::remove_false_marks(soup); });
  if(!options.regions.empty())
    naming(options.source, [&] { take_regions(options.regions, soup); });
  if(!options.features.empty()
     && !VMP::IO::read_features(options.features, soup, CGAL::parameters::visitor(std::ref(progress))))
    throw Interruption();
  Source source = naming(options.source, [&] { return mended_source(std::move(soup), options); });
  for(std::string& note : notes_of_unused_regions(source.soup))
    source.notes.push_back(std::move(note));
  if(options.domain == "polycube" || !options.hexahedra.empty())
    if(const std::string note = note_of_unmarked_edges(source.soup); !note.empty())
      source.notes.push_back(note);
  return source;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H
