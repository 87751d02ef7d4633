// The module that gmsh_module() loads.
#include "Gmsh_module.h"
#include "Gmsh_writer.h"

extern "C" const Gmsh_module functions_of_Gmsh_module;
const Gmsh_module functions_of_Gmsh_module = { read_by_Gmsh, write_MSH, write_MSH };
