// The module that gmsh_module() loads.
#include "Gmsh_module.h"

#include <CGAL/Polycube_meshing_3/IO/MSH.h>
#include <CGAL/Volume_mesh_parameterization/IO/Gmsh.h>

namespace IO = CGAL::Volume_mesh_parameterization::IO;
using CGAL::Polycube_meshing_3::IO::write_MSH; // of hexahedra

extern "C" const Gmsh_module functions_of_Gmsh_module;
const Gmsh_module functions_of_Gmsh_module = { IO::read_by_Gmsh, IO::mesh_by_Gmsh, IO::write_MSH, write_MSH };
