// The option --hexahedra of parameterize_mesh_file: hexahedra of a map to a box or a polycube, in a file.
#ifndef HEXAHEDRA_FILE_H
#define HEXAHEDRA_FILE_H

#include "Mesh_format.h"
#include "Progress_line.h"

#include <CGAL/Polycube_meshing_3/IO/write_hexahedron_soup.h>
#include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/Output_file.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace PM = CGAL::Polycube_meshing_3;

class Hexahedra_file
{
public:
  // The values of the option: the spacing of the grid, and the name of the file; none if it is not given.
  explicit Hexahedra_file(const std::vector<std::string>& words)
  {
    if(words.empty())
      return;
    if(words.size() != 2)
      throw std::runtime_error("--hexahedra needs a spacing and the name of a file");
    char* end;
    m_spacing = std::strtod(words[0].c_str(), &end);
    m_name = words[1];
    if(*end != '\0' || !(m_spacing > 0) || !std::isfinite(m_spacing))
      throw std::runtime_error("the spacing of hexahedra '" + words[0] + "' is not a finite positive number");
    if(!VMP::IO::Output_file::is_stream(m_name) && !is_mesh_name(m_name) && extension() != ".inp")
      throw std::runtime_error(m_name + ": the name of the hexahedra must end with .inp, " + mesh_extensions);
  }

  const std::string& name() const { return m_name; } // empty if there is none
  double spacing() const { return m_spacing; }       // 0 if there is none

  // Writes the file only if there is a valid mesh.
  PM::Hexahedral_mesh_result write(const VMP::Tetrahedron_soup_3& source, const std::vector<std::array<double, 3> >& uvw,
                                   const bool are_staircases, Progress_line& progress) const
  {
    PM::Hexahedron_soup_3 mesh;
    const PM::Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3<CGAL::Parallel_if_available_tag>(
      source, uvw, m_spacing, mesh, CGAL::parameters::visitor(std::ref(progress)).do_keep_interfaces(!are_staircases)
                                    .maximum_running_time(progress.seconds_left()));
    if(result.has_valid_mesh)
    {
      VMP::IO::Output_file file(m_name);
      if(extension() == ".vtu")
        PM::IO::write_VTU(file.stream(), mesh, source.group_names);
      else if(extension() == ".inp")
        PM::IO::write_INP(file.stream(), mesh, "C3D8", source.group_names);
#ifdef PARAMETERIZE_MESH_FILE_USES_GMSH
      else if(is_Gmsh_name(m_name))
        gmsh_module().write_hexahedra(file.stream(), mesh, source.group_names, version_of_Gmsh_name(m_name));
#endif
      else
        PM::IO::write_MEDIT(file.stream(), mesh);
      file.commit(CGAL::parameters::visitor(std::ref(progress)));
    }
    return result;
  }

private:
  std::string extension() const { return extension_of(m_name); }

  double m_spacing = 0;
  std::string m_name;
};

#endif // HEXAHEDRA_FILE_H
