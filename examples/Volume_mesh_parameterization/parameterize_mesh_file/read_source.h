#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_READ_SOURCE_H

#include "Mesh_format.h"
#include "Progress_line.h"
#include "check_coordinate_systems.h"
#include "mend_source.h"
#include "notes_on_features.h"
#include "read_in_own_process.h"
#include "regions_of_source.h"

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/IO/features.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

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

// Reads a mesh in any of the formats. Throws `Interruption` where the time is over.
inline CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3 read_mesh(const std::string& filename, Progress_line& progress)
{
  namespace VMP = CGAL::Volume_mesh_parameterization;
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

inline Source read_source(const Options& options, Progress_line& progress)
{
  auto soup = read_mesh(options.source, progress);
  if(!options.regions.empty())
    naming(options.source, [&] { take_regions(options.regions, soup); });
  if(!options.features.empty()
     && !CGAL::Volume_mesh_parameterization::IO::read_features(options.features, soup,
                                                               CGAL::parameters::visitor(std::ref(progress))))
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
